#include "base/text.h"
#include "scene/keys.h"
#include "scene/read_stl.h"
#include "scene/resolve.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace tumble::scene {
namespace {

PlaneShape plane(const View& view, const Resolving& to) {
    return {view.vector("point_m"), direction_of(view, "normal", to)};
}

BoxShape box(const View& view, const Resolving& to) {
    BoxShape shape;
    shape.box = box_of(view, "lo_m", "hi_m", to);
    if (view.given("lo_m") && view.given("hi_m") && !has_volume(shape.box))
        to.refuse(
            view, "hi_m",
            fmt::format("the box from {} to {} has no volume", in_words(shape.box.lo, to), in_words(shape.box.hi, to)),
            "each value of hi_m must be above that of lo_m");
    for (const std::string& face : view.words("open"))
        shape.open[static_cast<std::size_t>(2 * (face[1] - 'x') + (face[0] == '+'))] = true;
    return shape;
}

DiscShape disc(const View& view, const Resolving& to) {
    DiscShape shape{view.vector("centre_m"), direction_of(view, "normal", to), view.number("radius_m"),
                    view.number("hole_radius_m")};
    if (view.given("hole_radius_m") && view.given("radius_m") && shape.hole_radius >= shape.radius)
        to.refuse(view, "hole_radius_m",
                  fmt::format("a hole of radius {} m leaves nothing of a disc of {} m", plain(shape.hole_radius),
                              plain(shape.radius)),
                  "make it smaller than radius_m");
    return shape;
}

TroughShape trough(const View& view, const Resolving& to) {
    TroughShape shape;
    shape.radius = view.number("radius_m");
    shape.floor = view.number("floor_m");
    shape.rim = view.number("rim_m");
    shape.flare = view.number("flare_deg");
    shape.x_lo = view.given("x_lo_m") ? view.number("x_lo_m") : to.scene.domain.box.lo.x();
    shape.x_hi = view.given("x_hi_m") ? view.number("x_hi_m") : to.scene.domain.box.hi.x();
    if (view.given("radius_m") && view.given("floor_m") && view.given("rim_m") &&
        shape.rim < shape.floor + shape.radius)
        to.refuse(view, "rim_m",
                  fmt::format("the rim at {} m is below the end of the round bottom at {} m", plain(shape.rim),
                              plain(shape.floor + shape.radius)),
                  "the sides begin at floor_m + radius_m; raise the rim");
    if (shape.x_lo >= shape.x_hi)
        to.refuse(view, view.written("x_lo_m") ? "x_lo_m" : "x_hi_m", "the trough has no length along x",
                  "give x_lo_m below x_hi_m");
    return shape;
}

MeshShape mesh(const View& view, const Resolving& to) {
    MeshShape shape;
    if (!view.given("stl"))
        return shape;
    shape.file = to.file(view.text("stl"));
    auto read = read_stl(shape.file);
    if (!read) {
        for (const Problem& problem : read.problems())
            if (problem.line > 0)
                to.report.add(Problems{problem});
            else
                to.refuse(view, "stl", fmt::format("STL file {}: {}", problem.file, problem.what), problem.fix);
        return shape;
    }
    shape.triangles = std::move(*read);
    shape.scale = view.number("scale");
    for (auto& triangle : shape.triangles)
        for (Vector3d& corner : triangle)
            corner *= shape.scale;
    return shape;
}

WallShape resolve_shape(const View& view, const Resolving& to) {
    const std::string kind = view.kind();
    if (kind == "box")
        return box(view, to);
    if (kind == "cylinder")
        return CylinderShape{view.vector("base_m"), direction_of(view, "axis", to), view.number("length_m"),
                             view.number("radius_m")};
    if (kind == "disc")
        return disc(view, to);
    if (kind == "trough")
        return trough(view, to);
    if (kind == "mesh")
        return mesh(view, to);
    return plane(view, to);
}

constexpr double endless = std::numeric_limits<double>::infinity();

/// Extent of a lateral surface or rim: a circle of `radius` about unit `axis`.
Vector3d circle_reach(const Vector3d& axis, double radius) {
    return radius * (Vector3d::Ones() - axis.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
}

struct Extent {
    Box operator()(const PlaneShape&) const { return {Vector3d::Constant(-endless), Vector3d::Constant(endless)}; }
    Box operator()(const BoxShape& shape) const { return shape.box; }
    Box operator()(const CylinderShape& shape) const {
        const Vector3d end = shape.base + shape.axis * shape.length;
        const Vector3d reach = circle_reach(shape.axis, shape.radius);
        return {shape.base.cwiseMin(end) - reach, shape.base.cwiseMax(end) + reach};
    }
    Box operator()(const DiscShape& shape) const {
        const Vector3d reach = circle_reach(shape.normal, shape.radius);
        return {shape.centre - reach, shape.centre + reach};
    }
    Box operator()(const TroughShape& shape) const {
        return {{-endless, shape.floor, -shape.radius}, {endless, shape.rim, shape.radius}};
    }
    Box operator()(const MeshShape& shape) const {
        Box all{Vector3d::Constant(endless), Vector3d::Constant(-endless)};
        for (const auto& triangle : shape.triangles)
            for (const Vector3d& corner : triangle) {
                all.lo = all.lo.cwiseMin(corner);
                all.hi = all.hi.cwiseMax(corner);
            }
        return all;
    }
};

/// Whether any of the plane lies in the box: its corners are not all on one side.
bool crosses(const PlaneShape& plane, const Box& box) {
    const Vector3d middle = (box.lo + box.hi) / 2;
    const double reach = plane.normal.cwiseAbs().dot((box.hi - box.lo) / 2);
    return std::abs(plane.normal.dot(middle - plane.point)) <= reach * (1 + 1e-9);
}

bool in_domain(const WallShape& shape, const Box& domain) {
    if (const auto* flat = std::get_if<PlaneShape>(&shape))
        return crosses(*flat, domain);
    const Box extent = std::visit(Extent{}, shape);
    return (extent.lo.array() <= domain.hi.array()).all() && (extent.hi.array() >= domain.lo.array()).all();
}

/// A closed face of a box wall that no body can reach.
std::string lost_face(const WallShape& shape, const Box& domain) {
    const auto* box = std::get_if<BoxShape>(&shape);
    const char* names[6] = {"-x", "+x", "-y", "+y", "-z", "+z"};
    for (std::size_t face = 0; box && face < 6; ++face) {
        const auto axis = static_cast<Eigen::Index>(face / 2);
        const double at = face % 2 ? box->box.hi[axis] : box->box.lo[axis];
        if (!box->open[face] && (at < domain.lo[axis] || at > domain.hi[axis]))
            return names[face];
    }
    return "";
}

void check_place(const NamedView& wall, const WallShape& shape, const Resolving& to) {
    const Box& domain = to.scene.domain.box;
    const View& view = wall.view;
    const bool readable = !std::holds_alternative<MeshShape>(shape) || !std::get<MeshShape>(shape).triangles.empty();
    if (!has_volume(domain) || !readable || !view.whole())
        return; // a wall or a domain that is already wrong is in no place
    if (!in_domain(shape, domain))
        to.report.add(view.place(), view.path(), fmt::format("wall '{}' lies outside the domain", view.text("name")),
                      fmt::format("no body can ever touch it: move it into {} to {}, or enlarge the domain",
                                  in_words(domain.lo, to), in_words(domain.hi, to)));
    else if (const std::string face = lost_face(shape, domain); !face.empty())
        to.report.add(view.place(), view.path(),
                      fmt::format("face {} of wall '{}' lies outside the domain", face, view.text("name")),
                      fmt::format("no body can ever touch it: add \"{}\" to open, or enlarge the domain", face));
}

} // namespace

void resolve_walls(const View& root, const Resolving& to) {
    std::set<std::string> names;
    for (const NamedView& named : root.children("wall")) {
        const View& view = named.view;
        Wall wall;
        wall.name = view.text("name");
        if (view.given("name") && (wall.name.empty() || wall.name.find('.') != std::string::npos))
            to.refuse(view, "name", fmt::format("a wall cannot be called '{}'", excerpt(wall.name)),
                      "use a name without dots");
        else if (view.given("name") && !names.insert(wall.name).second)
            to.refuse(view, "name", fmt::format("there are two walls '{}'", excerpt(wall.name)),
                      "give each its own name");
        wall.material = material_of(view, to).value_or(0);
        wall.opacity = view.number("opacity");
        wall.motion = resolve_motion(view, to);
        if (to.scene.dimension == 2) {
            wall.outline = resolve_outline(view, to);
            check_outline(view, wall.outline, to);
        } else {
            wall.shape = resolve_shape(view, to);
            check_place(named, wall.shape, to);
        }
        to.scene.walls.push_back(std::move(wall));
    }
}

} // namespace tumble::scene
