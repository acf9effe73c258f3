#include "about.h"
#include "solver/leashes.h"

#include <doctest/doctest.h>
#include <numeric>

namespace test_leashes {

using namespace tumble;
using tumble::test::about;

TEST_CASE("leashes are half a skin in the mean, and all moving bodies' own parts last equally long") {
    const std::vector<double> speeds{0, 0.5, 1, 1.5}; // m/s
    const double skin = 0.2;                          // m
    std::vector<double> odometers = speeds;
    solver::start_odometers(odometers, skin);
    const double mean = -std::accumulate(odometers.begin(), odometers.end(), 0.0) / 4;
    CHECK(mean == about(skin / 2, 1e-12));
    const double rest = -odometers[0]; // what a body at rest gets for collisions to come, and so all others
    CHECK(rest > 0);
    for (std::size_t k = 1; k < speeds.size(); ++k)
        CHECK((-odometers[k] - rest) / speeds[k] == about((-odometers[1] - rest) / speeds[1], 1e-12));
}

TEST_CASE("one body that is far faster than the rest gets no leash beyond the longest") {
    std::vector<double> odometers(100, 0.0);
    odometers[0] = 1e3;
    solver::start_odometers(odometers, 0.2);
    CHECK(odometers[0] == about(-solver::longest_leash * 0.1, 1e-12));
    CHECK(odometers[1] < 0);
}

} // namespace test_leashes
