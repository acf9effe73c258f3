#pragma once

#include "base/carried.h"
#include "sim2d/kernels.h"
#include "solver/grouped.h"
#include "solver/wall_memory.h"

#include <span>
#include <vector>

namespace tumble::sim2d {

struct World;
using WallMemory = solver::WallMemory<2, Memory>;

/// What one touching pair remembers, named by the tags of its discs, so that it outlives lists, slots and rows. Two
/// discs meet through one image of the periodic box at most (build.cpp asks for periods that long), and both sides
/// remember the same, so neither image nor order is kept.
struct KeptPair {
    int first = 0; // the smaller tag
    int second = 0;
    int further = -1; // index of its further memory; -1: none
    Memory memory{};
};

struct KeptWall {
    int disc = 0; // tag
    int wall = 0;
    int further = -1;
    WallMemory memory;
};

/// Every touching contact of the world, findable by disc. Keeps its room from one use to the next.
class KeptMemory {
public:
    void take(const World& world);
    void forget();

    /// What the discs of these tags remember of each other, or null.
    [[nodiscard]] const KeptPair* of_pair(int a, int b) const;
    [[nodiscard]] std::span<const KeptWall> of_wall(int disc) const;
    /// What an entry of that index remembers beside its spring.
    [[nodiscard]] FurtherMemory further(int index) const {
        return index < 0 ? FurtherMemory{} : further_[static_cast<std::size_t>(index)];
    }

    /// Of one that was read: whether it leads nowhere outside of itself.
    [[nodiscard]] bool sound() const;
    template <class Archive, As<KeptMemory> K> friend void carry(Archive& archive, K& kept) {
        archive(kept.pairs_, kept.walls_, kept.further_);
    }

private:
    solver::Grouped<KeptPair> pairs_; // by tag of the first
    solver::Grouped<KeptWall> walls_; // by tag
    std::vector<FurtherMemory> further_;
};

} // namespace tumble::sim2d
