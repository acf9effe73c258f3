// What swings at one frequency: found with its frequency and its size, not seen in noise, and mains told from it.
#include "base/rng.h"
#include "diagnose/swings.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_swings {

using namespace tumble;
using namespace tumble::diagnose;

namespace {

/// Four records of unequal length, every thirtieth frame lost.
std::vector<Course> courses(double rate) {
    std::vector<Course> all;
    Eigen::Index first = 0;
    for (const int readings : {300, 240, 270, 200}) {
        Course course{"centre_of_mass_x", first, {}};
        for (int k = 0; k < readings; ++k)
            if (k % 30 != 7)
                course.time.push_back(k / rate);
        first += static_cast<Eigen::Index>(course.time.size());
        all.push_back(std::move(course));
    }
    return all;
}

VectorXd noise(const std::vector<Course>& all, Rng& rng) {
    VectorXd residual(all.back().first + static_cast<Eigen::Index>(all.back().time.size()));
    for (double& one : residual)
        one = std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(2 * std::numbers::pi * rng.uniform());
    return residual;
}

void shake(VectorXd& residual, const std::vector<Course>& all, double amplitude, double frequency) {
    for (std::size_t r = 0; r < all.size(); ++r)
        for (std::size_t k = 0; k < all[r].time.size(); ++k)
            residual[all[r].first + static_cast<Eigen::Index>(k)] +=
                amplitude * std::sin(2 * std::numbers::pi * frequency * all[r].time[k] + 1.7 * static_cast<double>(r));
}

} // namespace

TEST_CASE("noise swings as much as its probability says, no oftener") {
    const std::vector<Course> all = courses(120);
    Rng rng(3);
    int seen = 0;
    for (int k = 0; k < 200; ++k)
        seen += strongest_swing(noise(all, rng), all)->p < 0.05;
    MESSAGE(seen << " of 200 below 0.05");
    CHECK(seen <= 22); // 10 are the most to be expected, and four standard deviations more
}

TEST_CASE(
    "a swing of half a standard error is found with its frequency and its size, whatever its phase in each record") {
    const std::vector<Course> all = courses(120);
    Rng rng(4);
    for (const double frequency : {3.1, 7.3, 41.0}) {
        VectorXd residual = noise(all, rng);
        shake(residual, all, 0.5, frequency);
        const auto swing = strongest_swing(residual, all);
        REQUIRE(swing);
        CHECK(std::abs(swing->frequency - frequency) < 0.5); // 1 / 2.5 s
        CHECK(std::abs(swing->amplitude - 0.5) < 0.15);
        CHECK(swing->p < 1e-6);
    }
}

TEST_CASE("mains are told apart, at 50 Hz and where they fold to") {
    Rng rng(5);
    for (const auto& [rate, shown] : {std::pair{120.0, 50.0}, {80.0, 30.0}}) {
        const std::vector<Course> all = courses(rate);
        int seen = 0;
        for (int k = 0; k < 40; ++k) {
            VectorXd residual = noise(all, rng);
            shake(residual, all, 0.5, 50);
            seen += strongest_swing(residual, all)->p < 0.05;
            const auto hum = mains_hum(residual, all);
            REQUIRE(hum);
            CHECK(std::abs(hum->frequency - shown) < 0.5);
            CHECK(hum->p < 1e-6);
        }
        CHECK(seen <= 8); // 2 are the most to be expected of noise, and four standard deviations more
    }
}

TEST_CASE("a spectrum has its highest line where a swing is, and noise alone seldom reaches its gate") {
    const std::vector<Course> all = courses(120);
    Rng rng(6);
    int reached = 0;
    for (int k = 0; k < 100; ++k) {
        const auto quiet = spectra_of(noise(all, rng), all);
        REQUIRE(quiet.size() == 1);
        REQUIRE(quiet[0].amplitude.size() == quiet[0].frequency.size());
        reached += *std::max_element(quiet[0].amplitude.begin(), quiet[0].amplitude.end()) > quiet[0].gate;
    }
    CHECK(reached <= 3); // 0.27 are the most to be expected
    VectorXd residual = noise(all, rng);
    shake(residual, all, 0.5, 7.3);
    const auto loud = spectra_of(residual, all)[0];
    const auto highest = std::max_element(loud.amplitude.begin(), loud.amplitude.end());
    CHECK(std::abs(loud.frequency[static_cast<std::size_t>(highest - loud.amplitude.begin())] - 7.3) < 0.5);
    CHECK(std::abs(*highest - 0.5) < 0.15);
    CHECK(*highest > loud.gate);
    CHECK(spectra_of(VectorXd::Ones(8), {}).empty());
}

TEST_CASE("records of a few readings have no swings") {
    const std::vector<Course> brief{{"centre_of_mass_x", 0, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}}};
    CHECK(!strongest_swing(VectorXd::Ones(8), brief));
    CHECK(!mains_hum(VectorXd::Ones(8), {}));
}

} // namespace test_swings
