#include "sim2d/crowd.h"

#include "scene/period.h"
#include "sim2d/cells.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim2d {

using Eigen::Vector2d;

std::vector<Disc> discs_of(const std::vector<ShapeData>& shapes, const Placement& body) {
    const std::vector<double>& exposed = shapes[static_cast<std::size_t>(body.shape)].exposed;
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    std::vector<Disc> discs;
    for (std::size_t k = 0; k < exposed.size(); k += 3) {
        const double x = exposed[k], y = exposed[k + 1];
        discs.push_back({body.position + Vector2d(c * x - s * y, s * x + c * y), exposed[k + 2]});
    }
    return discs;
}

std::optional<std::size_t> wall_met(const std::vector<StandingWall>& walls, const std::vector<Disc>& discs) {
    std::vector<int> pieces;
    for (std::size_t w = 0; w < walls.size(); ++w)
        for (const Disc& disc : discs) {
            walls[w].line->pieces_near(walls[w].frame.to_wall(disc.centre), disc.radius, pieces);
            if (!pieces.empty())
                return w;
        }
    return std::nullopt;
}

Crowd::Crowd(const scene::Domain& domain, const std::vector<ShapeData>& shapes, const std::vector<Placement>& bodies,
             std::int64_t more)
    : domain_(domain) {
    double largest = 0;
    for (const ShapeData& data : shapes)
        for (std::size_t k = 2; k < data.exposed.size(); k += 3)
            largest = std::max(largest, data.exposed[k]);
    double points = static_cast<double>(more);
    for (const Placement& body : bodies)
        points += static_cast<double>(shapes[static_cast<std::size_t>(body.shape)].exposed.size()) / 3;
    double width = std::max(2 * largest, 1e-9);
    const Vector2d length = (domain.box.hi - domain.box.lo).head<2>();
    while ((length / width).array().floor().max(1).prod() > cells_per_point * points + 64)
        width *= 1.41;
    for (int k = 0; k < 2; ++k)
        size_[static_cast<std::size_t>(k)] = std::max(static_cast<int>(length[k] / width), 1);
    first_.assign(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]), -1);
    for (const Placement& body : bodies)
        add(discs_of(shapes, body));
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
    Vector2d shift = Vector2d::Zero();
    for (std::size_t k = 0; k < 2; ++k) {
        if (at[k] >= 0 && at[k] < size_[k])
            continue;
        if (!domain_.periodic[k])
            return true;
        const auto axis = static_cast<Eigen::Index>(k);
        const int turn = at[k] < 0 ? -1 : 1;
        shift[axis] = turn * (domain_.box.hi[axis] - domain_.box.lo[axis]);
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
    const scene::Box& box = domain_.box;
    for (int axis = 0; axis < 2; ++axis)
        centre[axis] -= scene::periods_past(domain_, axis, centre[axis]) * (box.hi[axis] - box.lo[axis]);
    return centre;
}

std::array<int, 2> Crowd::place(const Vector2d& centre) const {
    const scene::Box& box = domain_.box;
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
