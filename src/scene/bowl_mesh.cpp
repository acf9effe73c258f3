#include "scene/bowl_mesh.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::scene {

namespace {

using std::numbers::pi;

/// A closed line of points about the axis; all rings of one wall have as many, and point i of one belongs to point i of
/// the next.
using Ring = std::vector<Vector3d>;

/// Point `across` the direction at `angle` (from x towards z) and `out` along it.
Vector3d polar(double angle, double out, double across, double y) {
    const Vector3d along(std::cos(angle), 0, std::sin(angle)), side(-std::sin(angle), 0, std::cos(angle));
    return out * along + across * side + y * Vector3d::UnitY();
}

void add_strip(MeshShape& mesh, const Ring& lower, const Ring& upper) {
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const std::size_t next = (i + 1) % lower.size();
        mesh.triangles.push_back({lower[i], lower[next], upper[next]});
        mesh.triangles.push_back({lower[i], upper[next], upper[i]});
    }
}

int facets_in(double angle) {
    return std::max(1, static_cast<int>(std::ceil(angle / (widest_facet_deg * pi / 180) - 1e-9)));
}

Ring plain_ring(double radius, double y) {
    Ring ring;
    const int facets = facets_in(2 * pi);
    for (int i = 0; i < facets; ++i)
        ring.push_back(polar(2 * pi * i / facets, radius, 0, y));
    return ring;
}

/// Half the angle that a rib's foot takes at this distance from the axis.
double half_angle(const Ribs& ribs, double radius) {
    return std::asin(std::min(1.0, ribs.width / 2 / radius));
}

/// Where the crest of a rib stands off its foot: m outwards and m up.
struct Crest {
    double out = 0;
    double up = 0;
};

/// The bowl's wall at height y: ribs stand on the chord between the corners of their facet.
Ring wall_ring(const BowlShape& shape, double y, const Crest& crest) {
    const Ribs& ribs = shape.ribs;
    Ring ring;
    const double foot = half_angle(ribs, shape.radius), sector = 2 * pi / ribs.count;
    const double chord = shape.radius * std::cos(foot);
    const int facets = facets_in(sector - 2 * foot);
    for (int k = 0; k < ribs.count; ++k) {
        const double angle = sector * k;
        ring.push_back(polar(angle, chord, -ribs.width / 2, y));
        ring.push_back(polar(angle, chord + crest.out, -ribs.crest / 2, y + crest.up));
        ring.push_back(polar(angle, chord + crest.out, ribs.crest / 2, y + crest.up));
        ring.push_back(polar(angle, chord, ribs.width / 2, y));
        for (int i = 1; i < facets; ++i)
            ring.push_back(polar(angle + foot + (sector - 2 * foot) * i / facets, shape.radius, 0, y));
    }
    return ring;
}

/// The facet of the disc's rim that carries a rib reaches this much farther to both sides than the rib's foot does at
/// the rim's inner edge.
constexpr double facet_over_foot = 1.25;

/// Half the angle of that facet.
double rib_facet(const BowlDiscShape& shape) {
    return facet_over_foot * half_angle(shape.ribs, shape.radius - shape.rim_width);
}

/// The disc at this radius and height. Its corners lie on the circle, as the facets of the rim need; where the disc is
/// flat any other place does as well, and near the axis a rib is wider than its facet: there they stand evenly between
/// the ribs.
Ring disc_ring(const BowlDiscShape& shape, double radius, double y, const Crest& crest) {
    const Ribs& ribs = shape.ribs;
    Ring ring;
    const double facet = rib_facet(shape), sector = 2 * pi / ribs.count;
    const double out = radius * std::cos(facet);
    const double first = std::max(facet, facet_over_foot * half_angle(ribs, radius));
    const int facets = facets_in(sector - 2 * facet);
    for (int k = 0; k < ribs.count; ++k) {
        const double angle = sector * k;
        ring.push_back(polar(angle, out, -ribs.width / 2, y));
        ring.push_back(polar(angle, out + crest.out, -ribs.crest / 2, y + crest.up));
        ring.push_back(polar(angle, out + crest.out, ribs.crest / 2, y + crest.up));
        ring.push_back(polar(angle, out, ribs.width / 2, y));
        for (int i = 0; i <= facets; ++i)
            ring.push_back(polar(angle + first + (sector - 2 * first) * i / facets, radius, 0, y));
    }
    return ring;
}

MeshShape stacked(const std::vector<Ring>& rings, const Vector3d& base) {
    MeshShape mesh;
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
        add_strip(mesh, rings[i], rings[i + 1]);
    for (auto& triangle : mesh.triangles)
        for (Vector3d& corner : triangle)
            corner += base;
    return mesh;
}

Problem fault(const char* key, std::string what, std::string fix) {
    return {.key = key, .what = std::move(what), .fix = std::move(fix)};
}

/// Ribs of which `narrowest` is the smallest radius at which they stand at full width; `or_else` gives them more room.
std::optional<Problem> fault_of(const Ribs& ribs, double narrowest, const char* or_else) {
    if (!(ribs.width < 2 * narrowest && facet_over_foot * half_angle(ribs, narrowest) < 0.98 * pi / ribs.count))
        return fault("rib_width_m",
                     fmt::format("{} ribs of {:.4g} m find no room side by side at {:.4g} m from the axis", ribs.count,
                                 ribs.width, narrowest),
                     fmt::format("make them narrower or fewer, or {}", or_else));
    if (ribs.crest >= ribs.width)
        return fault("rib_crest_m",
                     fmt::format("a rib of {:.4g} m is not wider than its crest of {:.4g} m", ribs.width, ribs.crest),
                     "make the crest narrower than rib_width_m");
    return std::nullopt;
}

} // namespace

std::optional<Problem> fault_of(const BowlShape& shape) {
    const Ribs& ribs = shape.ribs;
    if (ribs.count == 0)
        return std::nullopt;
    const double begin = shape.rib_start * shape.height, wall = shape.height - begin;
    if (ribs.height >= std::min(shape.radius, wall))
        return fault("rib_height_m",
                     fmt::format("ribs {:.4g} m high do not fit into the bowl: from where they begin, {:.4g} m up, its "
                                 "wall goes on for {:.4g} m, and its radius is {:.4g} m",
                                 ribs.height, begin, wall, shape.radius),
                     fmt::format("make them lower than {:.4g} m{}", std::min(shape.radius, wall),
                                 wall <= shape.radius ? ", or let them begin farther down (rib_start)" : ""));
    return fault_of(ribs, shape.radius - ribs.height, "make them lower");
}

std::optional<Problem> fault_of(const BowlDiscShape& shape) {
    const Ribs& ribs = shape.ribs;
    const double flat = shape.radius - shape.rim_width, begin = shape.rib_start * shape.radius;
    if (shape.rim_width >= shape.radius)
        return fault(
            "rim_width_m",
            fmt::format("a rim of {:.4g} m is as wide as the disc's radius of {:.4g} m", shape.rim_width, shape.radius),
            "make it narrower");
    if (ribs.count == 0)
        return std::nullopt;
    if (begin >= flat)
        return fault("rib_start",
                     fmt::format("ribs that begin at {:.4g} m from the axis have no room on a flat part of {:.4g} m",
                                 begin, flat),
                     "let them begin farther in, or make the rim narrower");
    const double on_floor = (flat - begin) / 2, on_rim = shape.rim_width / 2;
    if (ribs.height >= std::min(on_floor, on_rim))
        return fault(
            "rib_height_m",
            fmt::format("ribs {:.4g} m high do not fit onto the disc: twice their height must find room on its "
                        "flat part from where they begin, {:.4g} m of it, and on its rim of {:.4g} m",
                        ribs.height, flat - begin, shape.rim_width),
            fmt::format("make them lower than {:.4g} m, or {}", std::min(on_floor, on_rim),
                        on_floor < on_rim ? "let them begin farther in (rib_start)"
                                          : "make the rim wider (rim_width_m)"));
    return fault_of(ribs, begin, "let them begin farther out (rib_start)");
}

MeshShape mesh_of(const BowlShape& shape) {
    if (shape.ribs.count == 0)
        return stacked({plain_ring(shape.radius, 0), plain_ring(shape.radius, shape.height)}, shape.base);
    // The lower end of a rib leans by 45 degrees: media that rise beneath it shall not hang.
    const double begin = shape.rib_start * shape.height;
    const Crest none{}, full{-shape.ribs.height, 0};
    std::vector<Ring> rings;
    if (begin > 0)
        rings.push_back(wall_ring(shape, 0, none));
    rings.push_back(wall_ring(shape, begin, none));
    rings.push_back(wall_ring(shape, begin + shape.ribs.height, full));
    rings.push_back(wall_ring(shape, shape.height, full));
    return stacked(rings, shape.base);
}

MeshShape mesh_of(const BowlDiscShape& shape) {
    const double flat = shape.radius - shape.rim_width;
    std::vector<Ring> rings;
    if (shape.ribs.count == 0) {
        rings = {plain_ring(flat, 0), plain_ring(shape.radius, shape.rim_rise)};
    } else {
        const double h = shape.ribs.height, begin = shape.rib_start * shape.radius;
        const double slope = std::atan2(shape.rim_rise, shape.rim_width * std::cos(rib_facet(shape)));
        // A rib begins and ends in a ramp of 45 degrees, the last one on the rim.
        const double last = 1 - h / std::hypot(shape.rim_width, shape.rim_rise);
        rings = {disc_ring(shape, begin, 0, {}), disc_ring(shape, begin + h, 0, {0, h}),
                 disc_ring(shape, flat, 0, {-h * std::tan(slope / 2), h}),
                 disc_ring(shape, flat + last * shape.rim_width, last * shape.rim_rise,
                           {-h * std::sin(slope), h * std::cos(slope)}),
                 disc_ring(shape, shape.radius, shape.rim_rise, {})};
    }
    MeshShape mesh = stacked(rings, shape.centre);
    const Ring& inner = rings.front();
    for (std::size_t i = 0; i < inner.size(); ++i)
        mesh.triangles.push_back({shape.centre, shape.centre + inner[(i + 1) % inner.size()], shape.centre + inner[i]});
    return mesh;
}

} // namespace tumble::scene
