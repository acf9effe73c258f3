#include "discs/crowd.h"

#include "solver/cell_grid.h"

#include <algorithm>

namespace tumble::discs {

using Eigen::Vector2d;

namespace {

/// Cells in which two discs that overlap are neighbours, m.
double cell_width(const scene::Domain& domain, const std::vector<ShapeData>& shapes,
                  const std::vector<Placement>& bodies, std::int64_t more) {
    double largest = 0;
    for (const ShapeData& data : shapes)
        for (std::size_t k = 2; k < data.exposed.size(); k += 3)
            largest = std::max(largest, data.exposed[k]);
    auto discs = static_cast<double>(more);
    for (const Placement& body : bodies)
        discs += static_cast<double>(shapes[static_cast<std::size_t>(body.shape)].exposed.size()) / 3;
    double width = std::max(2 * largest, 1e-9);
    const Vector2d length = (domain.box.hi - domain.box.lo).head<2>();
    while ((length / width).array().floor().max(1).prod() > solver::cells_per_point * discs + 64)
        width *= 1.41;
    return width;
}

} // namespace

Crowd::Crowd(const scene::Domain& domain, const std::vector<ShapeData>& shapes, const std::vector<Placement>& bodies,
             std::int64_t more)
    : cells_(domain, cell_width(domain, shapes, bodies, more)) {
    for (const Placement& body : bodies)
        add(discs_of(shapes, body));
}

void Crowd::add(const std::vector<Disc>& discs) {
    for (Disc disc : discs) {
        disc.centre += cells_.way_into_box(disc.centre);
        cells_.add(disc.centre);
        discs_.push_back(disc);
    }
}

bool Crowd::leaves_room_for(const std::vector<Disc>& discs) const {
    return std::none_of(discs.begin(), discs.end(), [&](const Disc& disc) {
        const Vector2d centre = disc.centre + cells_.way_into_box(disc.centre);
        return cells_.any_near(centre, [&](std::size_t number, const Vector2d& shift) {
            const double reach = disc.radius + discs_[number].radius;
            return (discs_[number].centre + shift - centre).squaredNorm() < reach * reach;
        });
    });
}

} // namespace tumble::discs
