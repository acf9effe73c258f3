#include "sim2d/crowd.h"

#include "scene/period.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim2d {

using Eigen::Vector2d;

std::vector<Disc> discs_of(const World& world, const Placement& body) {
    const ShapeConstants& shape = world.shape_constants[static_cast<std::size_t>(body.shape)];
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    std::vector<Disc> discs;
    for (int k = 0; k < shape.exposed_count; ++k) {
        const double* disc = shape.exposed + 3 * static_cast<std::ptrdiff_t>(k);
        discs.push_back({body.position + Vector2d(c * disc[0] - s * disc[1], s * disc[0] + c * disc[1]), disc[2]});
    }
    return discs;
}

bool in_wall(const World& world, const std::vector<Disc>& discs) {
    std::vector<int> pieces;
    for (const WallState& wall : world.walls)
        for (const Disc& disc : discs) {
            wall.line.pieces_near(wall.frame.to_wall(disc.centre), disc.radius, pieces);
            if (!pieces.empty())
                return true;
        }
    return false;
}

Crowd::Crowd(const World& world, std::int64_t more) : world_(world) {
    double width = std::max(2 * world.largest_radius, 1e-9);
    const Vector2d length = (world.scene.domain.box.hi - world.scene.domain.box.lo).head<2>();
    const double room = cells_per_point * (static_cast<double>(more) + world.tags) + 64;
    while ((length / width).array().floor().max(1).prod() > room)
        width *= 1.41;
    for (int k = 0; k < 2; ++k)
        size_[static_cast<std::size_t>(k)] = std::max(static_cast<int>(length[k] / width), 1);
    first_.assign(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]), -1);
    for (int slot = 0; slot < world.bodies(); ++slot)
        add(discs_of(world, {world.shape[static_cast<std::size_t>(slot)],
                             {world.row(slot).x, world.row(slot).y},
                             world.angle[static_cast<std::size_t>(slot)]}));
}

void Crowd::add(const std::vector<Disc>& discs) {
    for (Disc disc : discs) {
        disc.centre = into_box(disc.centre);
        int& first = first_[index(place(disc.centre))];
        next_.push_back(first);
        first = static_cast<int>(discs_.size());
        discs_.push_back(disc);
    }
}

bool Crowd::leaves_room_for(const std::vector<Disc>& discs) const {
    for (Disc disc : discs) {
        disc.centre = into_box(disc.centre);
        const auto home = place(disc.centre);
        for (int x = home[0] - 1; x <= home[0] + 1; ++x)
            for (int y = home[1] - 1; y <= home[1] + 1; ++y)
                if (!cell_leaves_room(disc, {x, y}))
                    return false;
    }
    return true;
}

bool Crowd::cell_leaves_room(const Disc& disc, std::array<int, 2> at) const {
    const scene::Domain& domain = world_.scene.domain;
    Vector2d shift = Vector2d::Zero();
    for (std::size_t k = 0; k < 2; ++k) {
        if (at[k] >= 0 && at[k] < size_[k])
            continue;
        if (!domain.periodic[k])
            return true;
        const auto axis = static_cast<Eigen::Index>(k);
        const int turn = at[k] < 0 ? -1 : 1;
        shift[axis] = turn * (domain.box.hi[axis] - domain.box.lo[axis]);
        at[k] -= turn * size_[k];
    }
    for (int k = first_[index(at)]; k >= 0; k = next_[static_cast<std::size_t>(k)]) {
        const Disc& other = discs_[static_cast<std::size_t>(k)];
        const double reach = disc.radius + other.radius;
        if ((other.centre + shift - disc.centre).squaredNorm() < reach * reach)
            return false;
    }
    return true;
}

Vector2d Crowd::into_box(Vector2d centre) const {
    const scene::Domain& domain = world_.scene.domain;
    for (int axis = 0; axis < 2; ++axis)
        centre[axis] -= scene::periods_past(domain, axis, centre[axis]) * (domain.box.hi[axis] - domain.box.lo[axis]);
    return centre;
}

std::array<int, 2> Crowd::place(const Vector2d& centre) const {
    const scene::Box& box = world_.scene.domain.box;
    std::array<int, 2> at{};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double part = (centre[axis] - box.lo[axis]) / (box.hi[axis] - box.lo[axis]);
        at[k] = std::clamp(static_cast<int>(std::floor(part * size_[k])), 0, size_[k] - 1);
    }
    return at;
}

std::size_t Crowd::index(const std::array<int, 2>& at) const {
    return static_cast<std::size_t>(at[0]) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(at[1]);
}

} // namespace tumble::sim2d
