#include "support/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <sys/resource.h>

namespace tumble::bench {

void print_block(const std::string& name, std::int64_t steps, std::int64_t bodies, double seconds) {
    fmt::print(R"({{"block": "{}", "steps": {}, "bodies": {}, "seconds": {:.6g}, "rate": {:.6g}}})"
               "\n",
               name, steps, bodies, seconds, static_cast<double>(bodies * steps) / seconds);
    std::fflush(stdout);
}

void print_summary(const Books& books, const std::vector<PhaseTime>& times) {
    std::string phases;
    for (const PhaseTime& phase : times)
        phases += fmt::format(R"({}"{}": {:.6g})", phases.empty() ? "" : ", ", phase.name, phase.seconds);
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
