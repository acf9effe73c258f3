#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "support/arguments.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// Timing of either solver's world; `advance`, `books_of` and `phase_times` are found by the world's namespace.
namespace tumble::bench {

/// Prints {"block": name, "steps", "bodies", "seconds", "rate"} on a line, rate in body-steps/s.
void print_block(const std::string& name, std::int64_t steps, std::int64_t bodies, double seconds);

/// Prints {"phases": {name: s}, "steps", "bodies", "contacts", "closure_J", "booked_J", "overlap_ratio_max",
/// "kinetic_J", "peak_rss_MB"} as the last line; phases count from the world's start, booked is the largest energy
/// booked.
void print_summary(const Books& books, const std::vector<PhaseTime>& phases);

/// `advance` that ends the program when the state stops being sane.
template <class World> void advance_or_refuse(World& world, std::int64_t steps) {
    if (const auto problem = advance(world, steps))
        refuse(to_string(*problem));
}

/// Takes `blocks` times `steps` steps and prints a line for each.
template <class World>
void timed_blocks(World& world, const std::string& name, std::int64_t blocks, std::int64_t steps) {
    for (std::int64_t block = 0; block < blocks; ++block) {
        const auto start = std::chrono::steady_clock::now();
        advance_or_refuse(world, steps);
        print_block(name, steps, books_of(world).bodies,
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
}

template <class World> void print_summary(const World& world) {
    print_summary(books_of(world), phase_times(world));
}

} // namespace tumble::bench
