#pragma once

#include "base/carried.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <type_traits>

namespace tumble::solver {

/// What one touch with a wall remembers; it belongs to the feature touched.
template <int dimensions, class Memory> struct WallMemory {
    int feature = 0;
    Eigen::Matrix<double, dimensions, 1> normal =
        Eigen::Matrix<double, dimensions, 1>::Zero(); // wall's frame, a step ago
    Memory memory{};
};

template <class> inline constexpr bool is_wall_memory = false;
template <int dimensions, class Memory> inline constexpr bool is_wall_memory<WallMemory<dimensions, Memory>> = true;
template <class T>
concept AnyWallMemory = is_wall_memory<std::remove_const_t<T>>;

template <class Archive, AnyWallMemory M> void carry(Archive& archive, M& wall_memory) {
    auto& [feature, normal, memory] = wall_memory;
    archive(feature, normal, memory);
}

// Pieces or facets that meet at less than this stand for one curved line or surface.
inline const double cos_smooth_joint = std::cos(30 * std::numbers::pi / 180);

/// The touch that goes on with what `old` remembers: the one with the same feature, else, over a smooth joint, one that
/// was not there before and faces nearly the same way. Null if there is none.
template <AnyWallMemory M> M* heir_of(const M& old, std::span<M> now, std::span<const M> before) {
    for (M& memory : now)
        if (memory.feature == old.feature)
            return &memory;
    for (M& memory : now) {
        const bool fresh =
            std::none_of(before.begin(), before.end(), [&](const M& other) { return other.feature == memory.feature; });
        if (fresh && memory.memory.energy == 0 && memory.normal.dot(old.normal) > cos_smooth_joint)
            return &memory;
    }
    return nullptr;
}

/// Hands the memory of the `count` touches a step ago to those of now; what finds no heir is given to forget(), and
/// what is new starts at rest. `further` holds what the touches remember beside it, or is null.
template <AnyWallMemory M, std::size_t room, class Count, class Further, class Touch, class Forget>
void match_features(std::array<M, room>& memory, Count& count, Further* further, std::span<const Touch> touches,
                    Forget&& forget) {
    if (touches.size() == 1 && count == 1 && memory[0].feature == touches[0].feature) {
        memory[0].normal = touches[0].normal; // as before; the rest would find the same
        return;
    }
    std::array<M, room> now;
    std::array<Further, room> further_now{};
    for (std::size_t t = 0; t < touches.size(); ++t)
        now[t] = {touches[t].feature, touches[t].normal, {}};
    const std::span<M> before(memory.data(), static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < before.size(); ++t) {
        M& old = before[t];
        M* heir = heir_of<M>(old, {now.data(), touches.size()}, before);
        if (heir)
            heir->memory = old.memory;
        else
            forget(old.memory);
        if (further && heir)
            further_now[static_cast<std::size_t>(heir - now.data())] = further[t];
        else if (further)
            forget(further[t]);
    }
    if (further)
        std::copy(further_now.begin(), further_now.end(), further);
    memory = now;
    count = static_cast<Count>(touches.size());
}

} // namespace tumble::solver
