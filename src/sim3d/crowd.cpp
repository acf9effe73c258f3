#include "sim3d/crowd.h"

#include "base/cell_width.h"
#include "solver/cell_grid.h"

#include <algorithm>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

double bounding_radius(const World& world, const Placement& body) {
    return world.shape_constants[static_cast<std::size_t>(body.shape)].bounding_radius;
}

/// Cells in which two bodies that overlap are neighbours, m.
double width_of_cells(const World& world, std::int64_t more) {
    double largest = 0;
    for (const ShapeConstants& shape : world.shape_constants)
        largest = std::max(largest, 2 * shape.bounding_radius);
    const Vector3d length = world.scene.domain.box.hi - world.scene.domain.box.lo;
    return cell_width_for(length, largest, solver::cells_per_point * (static_cast<double>(more) + world.bodies()) + 64);
}

} // namespace

Crowd::Crowd(const World& world, std::int64_t more)
    : world_(world), cells_(world.scene.domain, width_of_cells(world, more)) {
    for (int slot = 0; slot < world.bodies(); ++slot)
        add(placement_of(world, slot));
}

void Crowd::add(const Placement& body) {
    const Placement inside = into_box(body);
    cells_.add(bounding_centre(world_, inside));
    bodies_.push_back(inside);
}

bool Crowd::leaves_room_for(const Placement& body) const {
    const Placement inside = into_box(body);
    const Vector3d centre = bounding_centre(world_, inside);
    return !cells_.any_near(centre, [&](std::size_t number, const Vector3d& shift) {
        const Placement& other = bodies_[number];
        const double reach = bounding_radius(world_, inside) + bounding_radius(world_, other);
        return (bounding_centre(world_, other) + shift - centre).squaredNorm() < reach * reach &&
               overlap(world_, inside, other, shift);
    });
}

Placement Crowd::into_box(Placement body) const {
    body.position += cells_.way_into_box(bounding_centre(world_, body));
    return body;
}

} // namespace tumble::sim3d
