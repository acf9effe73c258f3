#pragma once

#include "sim3d/placement.h"
#include "solver/cell_chains.h"

#include <cstdint>
#include <vector>

namespace tumble::sim3d {

/// Bodies by the cell of their bounding sphere, growing as bodies are placed.
class Crowd {
public:
    /// The world's bodies, and room for `more`.
    Crowd(const World& world, std::int64_t more);

    void add(const Placement& body);
    [[nodiscard]] bool leaves_room_for(const Placement& body) const;

private:
    /// With its bounding centre in the box along periodic axes, wherever its centre of mass may be then.
    [[nodiscard]] Placement into_box(Placement body) const;

    const World& world_;
    solver::CellChains<3> cells_;
    std::vector<Placement> bodies_; // in the box
};

} // namespace tumble::sim3d
