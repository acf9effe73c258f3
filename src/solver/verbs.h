#pragma once

#include "base/phases.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

/// A step is a list of verbs; each accounts for its time.
namespace tumble::solver {

/// The verbs of a step with soft contacts.
enum class Phase {
    move_walls,
    list_neighbours,
    find_candidates,
    push_gravity,
    push_air,
    touch_candidates,
    push_contacts,
    collect_pushes,
    integrate,
    book_energy
};
constexpr std::array<const char*, 10> phase_names{"move_walls", "list_neighbours",  "find_candidates", "push_gravity",
                                                  "push_air",   "touch_candidates", "push_contacts",   "collect_pushes",
                                                  "integrate",  "book_energy"};
using PhaseSeconds = std::array<double, phase_names.size()>;

/// Adds the wall time from its making to its end to a number of seconds.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : seconds_(seconds) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Runs one verb of the step on the whole world, or on one chunk, and accounts for its time. `Verbs` numbers them.
template <class Verbs, class World> void timed(Verbs phase, void (*verb)(World&), World& world) {
    const Stopwatch watch(world.seconds[static_cast<std::size_t>(phase)]);
    verb(world);
}
template <class Verbs, class World, class Chunk>
void timed(Verbs phase, void (*verb)(World&, Chunk&), World& world, Chunk& chunk) {
    const Stopwatch watch(chunk.seconds[static_cast<std::size_t>(phase)]);
    verb(world, chunk);
}

/// Seconds per phase since the world was built, summed over threads.
template <class World> std::vector<PhaseTime> phase_times(const World& world) {
    std::vector<PhaseTime> phases;
    for (std::size_t k = 0; k < phase_names.size(); ++k) {
        double seconds = world.seconds[k];
        for (const auto& chunk : world.chunks)
            seconds += chunk.seconds[k];
        phases.push_back({phase_names[k], seconds});
    }
    return phases;
}

} // namespace tumble::solver
