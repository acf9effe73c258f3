#include "support/report.h"

#include "support/media.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <sys/resource.h>

namespace tumble::bench {

void timed_blocks(sim3d::World& world, const std::string& name, std::int64_t blocks, std::int64_t steps) {
    for (std::int64_t block = 0; block < blocks; ++block) {
        const auto start = std::chrono::steady_clock::now();
        advance_or_refuse(world, steps);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const std::int64_t bodies = sim3d::books_of(world).bodies;
        fmt::print(R"({{"block": "{}", "steps": {}, "bodies": {}, "seconds": {:.6g}, "rate": {:.6g}}})"
                   "\n",
                   name, steps, bodies, seconds, static_cast<double>(bodies * steps) / seconds);
        std::fflush(stdout);
    }
}

void print_summary(const sim3d::World& world) {
    std::string phases;
    for (const auto& phase : sim3d::phase_times(world))
        phases += fmt::format(R"({}"{}": {:.6g})", phases.empty() ? "" : ", ", phase.name, phase.seconds);
    const Books books = sim3d::books_of(world);
    const double kinetic = books.kinetic_translation + books.kinetic_rotation;
    const double booked = std::max({kinetic, std::abs(books.gravity), books.stored_normal, books.lost_normal_damping,
                                    books.lost_sliding, std::abs(books.wall_work), std::abs(books.inserted)});
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print(
        R"({{"phases": {{{}}}, "steps": {}, "bodies": {}, "contacts": {}, "closure_J": {:.6g}, "booked_J": {:.6g}, )"
        R"("overlap_ratio_max": {:.4g}, "kinetic_J": {:.6g}, "peak_rss_MB": {:.1f}}})"
        "\n",
        phases, books.step, books.bodies, books.contacts, books.closure, booked, books.overlap_ratio_max, kinetic,
        static_cast<double>(usage.ru_maxrss) / 1024);
}

} // namespace tumble::bench
