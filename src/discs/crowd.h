#pragma once

#include "discs/placement.h"
#include "solver/cell_chains.h"

#include <cstdint>
#include <vector>

namespace tumble::discs {

/// Discs by cell, growing as bodies are placed.
class Crowd {
public:
    /// The discs of `bodies`, and room for `more`.
    Crowd(const scene::Domain& domain, const std::vector<ShapeData>& shapes, const std::vector<Placement>& bodies,
          std::int64_t more);

    void add(const std::vector<Disc>& discs);
    [[nodiscard]] bool leaves_room_for(const std::vector<Disc>& discs) const;

private:
    solver::CellChains<2> cells_;
    std::vector<Disc> discs_; // in the box
};

} // namespace tumble::discs
