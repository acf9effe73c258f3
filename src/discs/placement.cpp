#include "discs/placement.h"

#include <cmath>

namespace tumble::discs {

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

} // namespace tumble::discs
