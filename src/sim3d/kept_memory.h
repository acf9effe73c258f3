#pragma once

#include "sim3d/kernels.h"
#include "solver/grouped.h"
#include "solver/wall_memory.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tumble::sim3d {

struct World;
using WallMemory = solver::WallMemory<3, MemoryLanes>;

/// What one touching contact remembers, named by body ids, so that it outlives lists and slots.
struct KeptPair {
    std::int64_t first = 0; // the smaller id; `memory` is from its side
    std::int64_t second = 0;
    int sphere_of_first = 0;
    int sphere_of_second = 0;
    int image = 0;    // of the second, seen from the first
    int further = -1; // index of its further memory, from the same side; -1: none
    MemoryLanes memory{};
};

struct KeptWall {
    std::int64_t body = 0;
    int wall = 0;
    int sphere = 0;
    int further = -1;
    WallMemory memory;
};

/// The image through which a sees b, when b sees a through `image`.
constexpr int mirrored(int image) {
    return 26 - image;
}

/// Every touching contact of the world, findable by body. Keeps its room from one use to the next.
class KeptMemory {
public:
    /// `wraps`: per slot, how many periods the body has just been moved back along each axis; empty for none.
    void take(const World& world, const std::vector<std::array<int, 3>>& wraps);

    /// Calls each(kept, straight) for what the bodies a and b remember of each other, b seen through `image`; straight:
    /// a is the first of the entry.
    template <class Each> void of_pair(std::int64_t a, std::int64_t b, int image, Each&& each) const {
        const bool straight = a < b;
        const int seen = straight ? image : mirrored(image);
        for (const KeptPair& old : pairs_.of(static_cast<std::size_t>(straight ? a : b)))
            if (old.second == (straight ? b : a) && old.image == seen)
                each(old, straight);
    }
    [[nodiscard]] std::span<const KeptWall> of_wall(std::int64_t body) const;
    /// What an entry of that index remembers beside its spring.
    [[nodiscard]] FurtherLanes further(int index) const {
        return index < 0 ? FurtherLanes{} : further_[static_cast<std::size_t>(index)];
    }

private:
    solver::Grouped<KeptPair> pairs_; // by id of the first
    solver::Grouped<KeptWall> walls_; // by id
    std::vector<FurtherLanes> further_;
};

/// The same memory seen from the other body.
inline MemoryLanes mirrored(const MemoryLanes& memory) {
    return {{-memory.spring[0], -memory.spring[1], -memory.spring[2]}, memory.energy};
}
inline FurtherLanes mirrored(const FurtherLanes& further) {
    FurtherLanes mirror = further;
    for (double& angle : mirror.rolling)
        angle = -angle;
    return mirror;
}

} // namespace tumble::sim3d
