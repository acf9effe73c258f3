#include "discs/body_shape.h"

#include "base/disc_union.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::discs {

using Eigen::Vector2d;
using scene::Sphere;

namespace {

Problems faults_of(const scene::BodyTemplate& body, const contact::Material& material, double depth) {
    Problems problems;
    const auto say = [&](std::string what, std::string fix) {
        problems.push_back(
            {.key = "body." + body.name, .what = fmt::format("body '{}': {}", body.name, what), .fix = std::move(fix)});
    };
    if (body.spheres.empty())
        say("there are no discs in it", "give it one disc or more");
    for (std::size_t i = 0; i < body.spheres.size(); ++i) {
        const Sphere& disc = body.spheres[i];
        if (!disc.centre.allFinite() || !std::isfinite(disc.radius) || disc.radius <= 0)
            say(fmt::format("disc {} has radius {} m", i + 1, disc.radius),
                "a radius must be positive and every number finite");
    }
    if (!body.mass && !(material.density > 0 && std::isfinite(material.density)))
        say(fmt::format("the density is {} kg/m3", material.density), "give a positive density, or the body's mass");
    if (!body.mass && !(depth > 0 && std::isfinite(depth)))
        say(fmt::format("the depth is {} m", depth), "give a positive depth, or the body's mass");
    if (body.mass && !(*body.mass > 0 && std::isfinite(*body.mass)))
        say(fmt::format("the mass is {} kg", *body.mass), "a mass must be positive");
    if (body.principal_inertia && !(body.principal_inertia->z() > 0 && std::isfinite(body.principal_inertia->z())))
        say(fmt::format("the inertia is {} kg m2", body.principal_inertia->z()), "an inertia must be positive");
    return problems;
}

/// The free part of a disc's rim, the union of all others hiding the rest; false when there is none.
bool outline(const std::vector<UnionDisc>& discs, std::size_t own, AngleCover& cover) {
    cover.clear();
    for (std::size_t other = 0; other < discs.size(); ++other)
        if (other != own && !hide_inside(discs[own], discs[other], cover))
            return false;
    return !cover.all_hidden();
}

std::vector<UnionDisc> about(const std::vector<Sphere>& discs, const Vector2d& origin) {
    std::vector<UnionDisc> moved;
    for (const Sphere& disc : discs)
        moved.push_back(
            {disc.centre.x() - origin.x(), disc.centre.y() - origin.y(), disc.radius, static_cast<int>(moved.size())});
    return moved;
}

/// Area, centre (m) and polar second moment about the centre (m4) of the union.
struct UnionArea {
    double area = 0;
    Vector2d centre = Vector2d::Zero();
    double polar = 0;
};

UnionArea union_area(const std::vector<Sphere>& discs) {
    if (discs.size() == 1) {
        const double r2 = discs[0].radius * discs[0].radius;
        return {std::numbers::pi * r2, discs[0].centre.head<2>(), std::numbers::pi * r2 * r2 / 2};
    }
    // Sums about a point near the centre lose no digits where the template lies far from its origin.
    const Vector2d origin = discs[0].centre.head<2>();
    const std::vector<UnionDisc> near = about(discs, origin);
    AreaMoments sums{};
    AngleCover cover;
    for (std::size_t i = 0; i < near.size(); ++i)
        if (outline(near, i, cover))
            cover.free_arcs([&](double from, double to) { add_arc(near[i], from, to, sums); });
    const auto [area, x, y, xx, yy, xy] = sums;
    const Vector2d centre(x / area, y / area);
    return {area, origin + centre, xx + yy - area * centre.squaredNorm()};
}

} // namespace

Result<BodyShape> make_body_shape(const scene::BodyTemplate& body, const contact::Material& material, double depth) {
    if (Problems problems = faults_of(body, material, depth); !problems.empty())
        return problems;
    const UnionArea whole = union_area(body.spheres);
    BodyShape shape;
    shape.name = body.name;
    shape.area = whole.area;
    shape.mass = body.mass.value_or(material.density * whole.area * depth);
    shape.inertia = body.principal_inertia ? body.principal_inertia->z() : shape.mass * whole.polar / whole.area;
    shape.written_centre = whole.centre;
    for (const Sphere& disc : body.spheres) {
        shape.discs.push_back({disc.centre.head<2>() - whole.centre, disc.radius});
        shape.bounding_radius = std::max(shape.bounding_radius, shape.discs.back().centre.norm() + disc.radius);
    }
    return shape;
}

std::vector<int> contact_discs(const BodyShape& shape) {
    std::vector<UnionDisc> discs;
    for (const Disc& disc : shape.discs)
        discs.push_back({disc.centre.x(), disc.centre.y(), disc.radius, static_cast<int>(discs.size())});
    std::vector<int> kept;
    AngleCover cover;
    for (std::size_t i = 0; i < discs.size(); ++i)
        if (outline(discs, i, cover))
            kept.push_back(static_cast<int>(i));
    return kept;
}

Result<std::vector<ShapeData>> shapes_for(const scene::Scene& scene) {
    std::vector<ShapeData> shapes;
    Problems problems;
    for (const scene::BodyTemplate& body : scene.bodies) {
        const auto shape = make_body_shape(body, scene.materials[static_cast<std::size_t>(body.material)], scene.depth);
        if (!shape) {
            const Problems more = shape.problems();
            problems.insert(problems.end(), more.begin(), more.end());
            continue;
        }
        ShapeData data{*shape, body.material, {}};
        for (const int k : contact_discs(*shape)) {
            const Disc& disc = shape->discs[static_cast<std::size_t>(k)];
            data.exposed.insert(data.exposed.end(), {disc.centre.x(), disc.centre.y(), disc.radius});
        }
        shapes.push_back(std::move(data));
    }
    if (!problems.empty())
        return problems;
    return shapes;
}

} // namespace tumble::discs
