#pragma once

#include "base/archive.h"
#include "base/problem.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Worlds as bytes and back; what of a world is kept, its own carry() says.
namespace tumble::solver {

/// The bytes, and in front of them their layout.
template <class World> std::string state_of(const World& world) {
    ArchiveWriter writer;
    writer(archive_layout_of(world), world);
    return writer.take();
}

Problem unusable_state(const scene::Scene& scene, const std::string& what);

/// What contacts remember beside their springs, as the pairs' laws of now need it, which may be others than those of
/// the state: nothing where none does, for each of `size` contacts where one does. Returns the energy forgotten, J.
template <class Further> double adapt_further(std::vector<Further>& further, std::size_t size, bool remembers_more) {
    double forgotten = 0;
    if (!remembers_more) {
        for (const Further& one : further)
            forgotten += one.rolling_energy;
        further.clear();
    } else if (further.empty()) {
        further.resize(size);
    }
    return forgotten;
}

/// Reads them into a world that was prepared for the same scene; adapt(world) lets follow what its laws ask for, and
/// flaw_of(world) tells what does not fit together.
template <class World>
std::optional<Problem> read_state(World& world, std::string_view state, void (*adapt)(World&),
                                  std::string (*flaw_of)(const World&)) {
    std::uint64_t layout = 0;
    ArchiveReader reader(state);
    reader(layout);
    if (layout != archive_layout_of(world))
        return unusable_state(world.scene,
                              "the state was saved by another version of the program or by the other solver");
    reader(world);
    if (!reader.whole())
        return unusable_state(world.scene,
                              "the saved state does not fit the scene: it has other walls or fills, or is damaged");
    adapt(world);
    if (const std::string flaw = flaw_of(world); !flaw.empty())
        return unusable_state(world.scene, "the saved state does not fit the scene: " + flaw);
    return std::nullopt;
}

// For those who look for flaws.

inline bool below(int index, std::size_t end) {
    return index >= 0 && static_cast<std::size_t>(index) < end;
}
/// begin .. begin + count lies in 0 .. end.
inline bool range_in(int begin, int count, std::size_t end) {
    return begin >= 0 && count >= 0 &&
           static_cast<std::size_t>(begin) + static_cast<std::size_t>(count) <= end; // of ints: no overflow
}
/// What is wrong with the bodies' ids and shapes, empty if nothing: each of 0 .. n must come once, each shape exist.
std::string flaw_of_bodies(const std::vector<std::int64_t>& id, const std::vector<int>& shape, std::size_t shapes);

} // namespace tumble::solver
