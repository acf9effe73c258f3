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

/// A step of a world of one chunk is over before a clock could be looked at twice for each of its verbs: its verbs are
/// timed in one step of so many, which then counts for all of them. A prime, for nothing that recurs to keep pace with.
constexpr int steps_per_timing = 67;

/// How many steps this step's times stand for; 0: it is not timed.
template <class World> int steps_timed(const World& world) {
    if constexpr (requires { world.chunks; })
        if (world.chunks.size() == 1)
            return world.step % steps_per_timing == 0 ? steps_per_timing : 0;
    return 1;
}

/// Adds the wall time from its making to its end, as many times as that, to a number of seconds.
class Stopwatch {
public:
    Stopwatch(double& seconds, int times) : seconds_(seconds), times_(times) {
        if (times_ > 0)
            start_ = std::chrono::steady_clock::now();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        if (times_ > 0)
            seconds_ += times_ * std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    double& seconds_;
    int times_;
    std::chrono::steady_clock::time_point start_;
};

/// Runs one verb of the step on the whole world, or on one chunk, and accounts for its time. `Verbs` numbers them.
template <class Verbs, class World> void timed(Verbs phase, void (*verb)(World&), World& world) {
    const Stopwatch watch(world.seconds[static_cast<std::size_t>(phase)], steps_timed(world));
    verb(world);
}
template <class Verbs, class World, class Chunk>
void timed(Verbs phase, void (*verb)(World&, Chunk&), World& world, Chunk& chunk) {
    const Stopwatch watch(chunk.seconds[static_cast<std::size_t>(phase)], steps_timed(world));
    verb(world, chunk);
}

/// Seconds per phase since the world was built, summed over threads; estimated where not every step is timed.
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
