#include "about.h"
#include "claims.h"
#include "sim2d/solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace test_flat_beds {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("shaken-bed-2d: the bed flies as high as an inelastic block, and stays down below one g") {
    const auto rises = [](const Ran& bed, double from) {
        const std::vector<double>& time = bed.column("time");
        const std::vector<double>& height = bed.column("centre_of_mass_y");
        const double rest = bed.mean("centre_of_mass_y", 0.9, 1.0);
        std::vector<double> tops;
        for (double begin = from; begin + 1 / 12.0 < time.back() + 1e-3; begin += 1 / 12.0) {
            double top = -1;
            for (std::size_t row = 0; row < time.size(); ++row)
                if (time[row] >= begin && time[row] < begin + 1 / 12.0)
                    top = std::max(top, height[row] - rest);
            tops.push_back(top);
        }
        return tops;
    };
    const auto mean = [](const std::vector<double>& tops) {
        return std::accumulate(tops.begin(), tops.end(), 0.0) / static_cast<double>(tops.size());
    };
    const double a = 0.004314, w = 2 * std::numbers::pi * 12, g = 9.81;
    const double lift = g / (a * w * w); // sin of the phase at take-off
    const double block = a * lift + std::pow(a * w, 2) * (1 - lift * lift) / (2 * g);
    CHECK(block == about(0.0063, 0.01));
    double sum = 0;
    const std::array<int, 4> seeds{4, 5, 6, 7};
    for (const int seed : seeds) {
        CAPTURE(seed);
        const Ran flying(loaded("shaken-bed-2d.toml", {"duration_s=2.5", "seed=" + std::to_string(seed)}));
        const std::vector<double> tops = rises(flying, 1.5);
        CHECK(tops.size() == 12);
        for (const double top : tops) {
            CHECK(top > 0.8 * block);
            CHECK(top < 1.6 * block);
        }
        sum += mean(tops) / static_cast<double>(seeds.size());
    }
    // Means of eight seeds scatter by 0.5 mm, so those of four by 0.25.
    CHECK(sum == about(0.0069, 0.08));
    const Ran lying(loaded("shaken-bed-2d.toml", {"duration_s=1.8", "wall.plate.motion.0.amplitude_m=0.00138"}));
    CHECK(mean(rises(lying, 1.5)) == about(0.00138, 0.1));
}

TEST_CASE(
    "hopper-2d: as many discs leave the slot a second when half the filling is gone, and as Beverloo's law says") {
    const auto left_until = [](const scene::Scene& hopper, const std::vector<double>& times) {
        auto world = sim2d::build_world(hopper, 1);
        REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
        std::vector<int> left;
        for (const double time : times) {
            REQUIRE(!sim2d::advance(**world, std::llround(time / hopper.time_step) - sim2d::steps_of(**world)));
            const auto discs = sim2d::bodies_of(**world);
            left.push_back(static_cast<int>(std::count_if(
                discs.begin(), discs.end(), [](const sim2d::BodyState& disc) { return disc.position.y() < -0.01; })));
        }
        return left;
    };
    // Beverloo's law for a slot, 1.03 phi sqrt(g) (B - k d)^1.5 of area per second (Nedderman 1992), with the solid
    // fraction 0.82 of discs at rest, over the mean area of the two sizes; k lies between 1.2 and 1.6.
    const auto beverloo = [](double slot, double k) {
        const double disc = std::numbers::pi * (0.0036 * 0.0036 + 0.0044 * 0.0044) / 2;
        return 1.03 * 0.82 * std::sqrt(9.81) * std::pow(slot - k * 0.008, 1.5) / disc;
    };
    const std::vector<int> left = left_until(loaded("hopper-2d.toml"), {1.44, 2.04, 2.64});
    const double first = (left[1] - left[0]) / 0.6, second = (left[2] - left[1]) / 0.6; // 1/s
    CHECK(first > beverloo(0.07, 1.6));
    CHECK(first < beverloo(0.07, 1.2));
    CHECK(second > 0.88 * first);
    CHECK(second < 1.05 * first);
    // The exponent: through a slot of 50 mm flows 0.54 of that (0.52 to 0.55 by k); with the exponent 1 it would be
    // 0.66, with 2 0.44.
    const std::vector<int> narrow =
        left_until(loaded("hopper-2d.toml", {"wall.left.points_m=[[-0.13, 0.78], [-0.13, 0.0], [-0.025, 0.0]]",
                                             "wall.right.points_m=[[0.13, 0.78], [0.13, 0.0], [0.025, 0.0]]"}),
                   {1.44, 2.04});
    CHECK((narrow[1] - narrow[0]) / 0.6 / first == about(beverloo(0.05, 1.4) / beverloo(0.07, 1.4), 0.1));
}

TEST_CASE(
    "repose-2d: discs that roll heap up far below their angle of friction, alike on both sides and in every heap") {
    double sum = 0, skew = 0;
    const std::array<int, 3> seeds{3, 4, 5};
    for (const int seed : seeds) {
        CAPTURE(seed);
        const Ran heap(loaded("repose-2d.toml", {"duration_s=2.6", "seed=" + std::to_string(seed)})); // at rest by then
        const double left = heap.column("surface_slope_left").back(),
                     right = -heap.column("surface_slope_right").back();
        CHECK(heap.summary.unfilled.empty());
        CHECK(heap.column("kinetic_energy").back() < 1e-9);
        for (const double slope : {left, right}) {
            CHECK(slope > 13);
            CHECK(slope < 19);
        }
        sum += left + right;
        skew += left - right;
    }
    // Six slopes scatter by 1.1 degrees: their mean by 0.45, the mean difference of two sides by 0.9.
    CHECK(sum / 6 == about(15.9, 0.08));
    CHECK(std::abs(skew / 3) < 2);
}

TEST_CASE("trough-2d: moved round a circle, the trough makes its flat load circulate clockwise and its surface slope") {
    // Slopes of single seeds scatter by 2.4 degrees about 9, circulations by 0.06 about 0.51 rad/s: means of two seeds
    // lie within three standard errors, 5 and 0.13.
    double turns = 0, slope = 0;
    for (const char* seed : {"seed=7", "seed=12"}) {
        CAPTURE(seed);
        const Ran flat(loaded("trough-2d.toml", {seed}));
        CHECK(flat.summary.bodies == 500);
        CHECK(flat.summary.unfilled.empty());
        for (const double from : {1.4, 1.8, 2.2, 2.6}) {
            CAPTURE(from);
            CHECK(flat.mean("circulation", from, from + 0.4) < -0.25);
            CHECK(flat.mean("circulation", from, from + 0.4) > -0.9);
        }
        const double turned = flat.mean("circulation", 2.0, 3.0), sloped = flat.mean("surface_slope", 2.0, 3.0);
        if (turns == 0) { // the scene's own seed
            CHECK(turned == about(-0.53, 0.25));
            CHECK(sloped == about(-9.2, 0.25));
        }
        turns += 0.5 * turned;
        slope += 0.5 * sloped;
        CHECK(std::abs(flat.summary.books.closure) < 0.01 * flat.summary.energy_turnover);
    }
    CHECK(std::abs(turns + 0.51) < 0.13);
    CHECK(slope < -4);
    CHECK(slope > -14);
}

TEST_CASE("trough-2d: in phase it turns the other way and lies level; with the thesis' amplitude across it turns a "
          "quarter as fast; with both nothing is left") {
    // From 2 to 3 s as claimed, each held to what three seeds have shown and about as much again on either side.
    struct Means {
        double turns, slope; // rad/s, degrees
    };
    const auto shaken = [](const std::vector<std::string>& sets) {
        const Ran ran(loaded("trough-2d.toml", sets));
        return Means{ran.mean("circulation", 2, 3), ran.mean("surface_slope", 2, 3)};
    };
    const std::string in_phase = "wall.0.motion.1.phase_deg=0", thesis = "wall.0.motion.1.amplitude_m=0.0004038";
    const Means line = shaken({in_phase});
    CHECK(line.turns > 0.07);
    CHECK(line.turns < 0.15);
    CHECK(std::abs(line.slope) < 3.5);
    const Means ellipse = shaken({thesis});
    CHECK(ellipse.turns > -0.17);
    CHECK(ellipse.turns < -0.11);
    CHECK(ellipse.slope > -6);
    CHECK(ellipse.slope < -3);
    const Means both = shaken({in_phase, thesis});
    CHECK(both.turns > -0.03);
    CHECK(both.turns < 0.07);
    CHECK(both.slope > -5);
    CHECK(both.slope < 3);
}

TEST_CASE("drum-2d: the surface of a slowly turning drum keeps its dynamic angle") {
    // The mean of two seeds, whose single ones scatter by 0.54 degrees about 22.6: three standard errors to either
    // side.
    double mean = 0;
    for (const char* seed : {"seed=2", "seed=5"}) {
        const Ran drum(loaded("drum-2d.toml", {seed}));
        CHECK(drum.summary.unfilled.empty());
        mean += 0.5 * drum.mean("surface_slope", 2.0, 5.0);
        for (double from = 2.2; from < 4.5; from += 0.4) {
            CAPTURE(from);
            CHECK(drum.mean("surface_slope", from, from + 0.4) > 18);
            CHECK(drum.mean("surface_slope", from, from + 0.4) < 27.5);
        }
    }
    CHECK(mean == about(22.6, 0.05));
}

} // namespace test_flat_beds
