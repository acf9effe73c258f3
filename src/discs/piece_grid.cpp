#include "discs/piece_grid.h"

#include <algorithm>
#include <cmath>

namespace tumble::discs {

using Eigen::Vector2d;

PieceGrid::PieceGrid(const std::vector<scene::OutlinePiece>& pieces) : bounds_(scene::bounds_of(pieces)) {
    const Vector2d length = bounds_.hi - bounds_.lo;
    // About as many cells as pieces, square where both sides are long enough.
    const double width = std::max({std::sqrt(length.x() * length.y() / static_cast<double>(pieces.size())),
                                   length.maxCoeff() / static_cast<double>(pieces.size()), 1e-12});
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        size_[at] = std::max(1, static_cast<int>(length[k] / width));
        per_cell_[k] = length[k] > 0 ? size_[at] / length[k] : 0;
    }
    cells_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]));
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        const scene::Rectangle box = scene::bounds_of({pieces[piece]});
        const auto lo = place_of(box.lo), hi = place_of(box.hi);
        for (int x = lo[0]; x <= hi[0]; ++x)
            for (int y = lo[1]; y <= hi[1]; ++y)
                cells_[static_cast<std::size_t>(x * size_[1] + y)].push_back(static_cast<int>(piece));
    }
}

std::array<int, 2> PieceGrid::place_of(const Vector2d& point) const {
    std::array<int, 2> place{};
    for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const double cell = std::floor((point[k] - bounds_.lo[k]) * per_cell_[k]);
        place[at] = static_cast<int>(std::clamp(cell, 0.0, size_[at] - 1.0));
    }
    return place;
}

void PieceGrid::near(const Vector2d& point, double reach, std::vector<int>& out) const {
    out.clear();
    if (((point - bounds_.lo).array() < -reach).any() || ((point - bounds_.hi).array() > reach).any())
        return;
    const auto lo = place_of(point.array() - reach), hi = place_of(point.array() + reach);
    for (int x = lo[0]; x <= hi[0]; ++x)
        for (int y = lo[1]; y <= hi[1]; ++y) {
            const auto& cell = cells_[static_cast<std::size_t>(x * size_[1] + y)];
            out.insert(out.end(), cell.begin(), cell.end());
        }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
}

} // namespace tumble::discs
