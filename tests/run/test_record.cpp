#include "about.h"
#include "base/text.h"
#include "run/record.h"
#include "scene/load.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>

namespace test_record {

using namespace tumble;
using tumble::test::about;

namespace {

scene::Scene bounce(const std::vector<std::string>& sets) {
    std::vector<scene::Override> overrides{{"observe.measures=[\"centre_of_mass_y\"]"}, {"observe.every_s=0.001"}};
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene(std::filesystem::path(TUMBLE_ROOT) / "scenes" / "bounce.toml", overrides);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return *scene;
}

/// The ball of scenes/lane.toml thrown at its lane from 0.3 m above, seen every two milliseconds.
scene::Scene thrown(const std::vector<std::string>& sets) {
    std::vector<scene::Override> overrides{{"observe.measures=[\"centre_of_mass_y\", \"angular_speed_max\"]"},
                                           {"observe.every_s=0.002"},
                                           {"duration_s=0.6"},
                                           {"fill.0.position_m.1=0.35"}};
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene(std::filesystem::path(TUMBLE_ROOT) / "scenes" / "lane.toml", overrides);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return *scene;
}

/// Between two rows, straight.
double height_at(const observe::Series& series, double t) {
    const std::vector<double>& time = series.values[0];
    const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
    REQUIRE(above > 0);
    REQUIRE(above < time.size());
    const double x = (t - time[above - 1]) / (time[above] - time[above - 1]);
    return (1 - x) * series.values[1][above - 1] + x * series.values[1][above];
}

} // namespace

TEST_CASE("a sphere recorded on its own falls as a stone does, and its rows rise in time") {
    const auto series = run::record(bounce({}));
    REQUIRE_MESSAGE(series, to_string(series.problems()));
    for (std::size_t row = 0; row < series->rows(); ++row) {
        const double t = series->values[0][row];
        if (row > 0)
            CHECK(t > series->values[0][row - 1]);
        if (t < 0.44) // 1 m takes 0.452 s; leapfrog with velocities half a step off is exact under constant force
            CHECK(series->values[1][row] == about(1.12 - 0.5 * 9.81 * t * t, 1e-9));
    }
}

TEST_CASE("strides in which a ball would go farther than its radius are cut, its rows stay as far apart as asked for") {
    const auto series = run::record(bounce({"duration_s=0.44", "observe.every_s=0.04"})); // 12 cm at 3 m/s
    REQUIRE_MESSAGE(series, to_string(series.problems()));
    CHECK(series->rows() == 12);
    for (std::size_t row = 0; row < series->rows(); ++row) {
        const double t = series->values[0][row];
        CHECK(t == about(0.04 * static_cast<double>(row), 1e-9));
        CHECK(series->values[1][row] == about(1.12 - 0.5 * 9.81 * t * t, 1e-9));
    }
}

TEST_CASE("recorded in strides and fine impacts, a bounce is the one that small steps give") {
    const auto strides = run::record(bounce({"duration_s=1.1"}));
    scene::Scene steady = bounce({"duration_s=1.1", "time_step_s=2e-6"});
    steady.fills.push_back(steady.fills[0]); // a second ball, out of the way: no longer alone
    steady.fills[0].position->x() = -1;
    steady.fills[1].position->x() = 1;
    REQUIRE(!run::flies_alone(steady));
    const auto small = run::record(steady);
    REQUIRE(strides);
    REQUIRE(small);
    // Dashpots act on velocities half a step late: a step of 1e-5 s of a contact of 1e-2 s changes restitution by
    // some 1e-4, 0.634 m of rebound by a tenth of a millimetre.
    for (const double t : {0.6, 0.8, 1.0})
        CHECK(std::abs(height_at(*strides, t) - height_at(*small, t)) < 3e-4);
}

TEST_CASE("a ball that comes to rest is recorded to the end, at rest where its weight holds it") {
    const auto series =
        run::record(bounce({"fill.0.position_m.1=0.14", "duration_s=1", "pair.leather-wood.restitution=0.3"}));
    REQUIRE_MESSAGE(series, to_string(series.problems()));
    CHECK(series->values[0].back() == about(1, 2e-3));
    // Hertz: m g = 4/3 E* sqrt(R) d^1.5, E* = 1.27e6 / (1 - 0.3^2) with a floor 10^4 times as stiff.
    const double modulus = 1 / ((1 - 0.09) / 1.27e6 + (1 - 0.09) / 1e10);
    const double depth = std::pow(0.6 * 9.81 / (4.0 / 3 * modulus * std::sqrt(0.12)), 2.0 / 3);
    CHECK(series->values[1].back() == about(0.12 - depth, 1e-4));
}

TEST_CASE("heights follow restitution smoothly: where in a step an impact begins leaves no trace") {
    for (const double t : {1.0, 1.6, 2.1}) {
        std::vector<double> heights;
        for (int k = 0; k < 8; ++k)
            heights.push_back(
                height_at(*run::record(bounce({"pair.leather-wood.restitution=" + shortest(0.8 + 2e-4 * k)})), t));
        for (std::size_t k = 2; k < heights.size(); ++k)
            CHECK(std::abs(heights[k] - 2 * heights[k - 1] + heights[k - 2]) < 2e-5);
    }
}

TEST_CASE("spins are seen while an impact makes them: its rows are as close as it is short") {
    // Hertz: 2.87 (m^2 / (R E*^2 v))^0.2 = 3.9 ms at 2.43 m/s, two rows of those asked for. At 6 m/s along the lane it
    // slides throughout, so spin and normal momentum grow together, by 5/2 mu (1 + e) v_n / R = 47 rad/s; nearly
    // elastic, for a dashpot that pulls at the end presses on friction, too.
    const auto series =
        run::record(thrown({"fill.0.velocity_m_s.0=6", "duration_s=0.4", "pair.rubber-wood.restitution=0.95"}));
    REQUIRE_MESSAGE(series, to_string(series.problems()));
    const std::vector<double>& spin = *series->find("angular_speed_max");
    CHECK(spin.back() == about(2.5 * 0.2 * 1.95 * std::sqrt(2 * 9.81 * 0.3) / 0.05, 0.03));
    const auto inside = std::count_if(spin.begin(), spin.end(),
                                      [&](double w) { return w > 0.02 * spin.back() && w < 0.98 * spin.back(); });
    CHECK(inside > 12);
}

TEST_CASE("ways follow friction smoothly, too: how many steps of an impact stick or slide leaves no trace") {
    // 40, 60 and 68 degrees from the normal: it sticks, and begins or ends to. With steps as long as for a drop the
    // ways jump by a millimetre.
    for (const char* speed : {"2.04", "4.2", "6.1"}) {
        std::vector<double> ways;
        for (int k = 0; k < 8; ++k) {
            const auto series = run::record(thrown({"observe.measures=[\"centre_of_mass_x\"]", "observe.every_s=0.001",
                                                    std::string("fill.0.velocity_m_s.0=") + speed,
                                                    "pair.rubber-wood.friction=" + shortest(0.2 + 1e-3 * k)}));
            REQUIRE_MESSAGE(series, to_string(series.problems()));
            ways.push_back(height_at(*series, 0.59));
        }
        for (std::size_t k = 2; k < ways.size(); ++k)
            CHECK(std::abs(ways[k] - 2 * ways[k - 1] + ways[k - 2]) < 3e-4);
    }
}

TEST_CASE("a ball thrown steeply or nearly along its wall is recorded to the end") {
    for (const double degrees : {10.0, 45.0, 70.0, 80.0, 85.0, 88.0})
        for (const double gap : {1e-4, 1e-3, 5e-3, 0.02}) {
            const double angle = degrees / 57.29577951308232;
            const auto series = run::record(
                thrown({"fill.0.position_m.1=" + shortest(0.05 + gap), "duration_s=0.3",
                        fmt::format("fill.0.velocity_m_s=[{}, {}, 0]", 3 * std::sin(angle), -3 * std::cos(angle))}));
            CAPTURE(degrees);
            CAPTURE(gap);
            CHECK_MESSAGE(series, to_string(series.problems()));
            if (series)
                CHECK(series->values[0].back() == about(0.3, 0.01));
        }
}

} // namespace test_record
