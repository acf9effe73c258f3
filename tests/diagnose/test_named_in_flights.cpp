// Causes of flights and of cameras, hidden in closed forms and named; conditions that differ.
#include "about.h"
#include "base/rng.h"
#include "base/text.h"
#include "diagnose/verdict.h"
#include "floor_and_ball.h"
#include "gauss.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace test_named_in_flights {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::floor_and_ball;
using tumble::test::gauss;

namespace {

/// A point that falls, bounces at once and is pulled sideways; impacts take nothing from its way along the floor.
struct Path {
    double height = 1, along = 0;     // m, m/s
    double g = 9.81, sideways = 0;    // m/s2
    double e = 0.8, p = 0, stick = 0; // restitution e v^-p sqrt(1 - stick / v^2), stick in m2/s2
    double turned = 0;                // rad, of the axes it is read along

    [[nodiscard]] double height_at(double t) const {
        double flight = std::sqrt(2 * height / g), speed = g * flight;
        if (t < flight)
            return height - 0.5 * g * t * t;
        t -= flight;
        for (int k = 0; k < 100; ++k) {
            speed *= e * std::pow(speed, -p) * std::sqrt(std::max(0.0, 1 - stick / (speed * speed)));
            flight = 2 * speed / g;
            if (t < flight)
                return speed * t - 0.5 * g * t * t;
            t -= flight;
        }
        return 0;
    }
    /// x and y.
    [[nodiscard]] std::pair<double, double> at(double t) const {
        const double x = along * t + 0.5 * sideways * t * t, y = height_at(t);
        return {x * std::cos(turned) + y * std::sin(turned), y * std::cos(turned) - x * std::sin(turned)};
    }
};

Result<observe::Series> closed_form(const scene::Scene& scene) {
    observe::Series series;
    series.columns = {"time_s", "centre_of_mass_x_m", "centre_of_mass_y_m"};
    series.values.resize(3);
    const contact::PairProperties& pair = scene.pair(0, 0);
    const Path path{.height = scene.fills[0].position->y(),
                    .along = scene.fills[0].velocity.x(),
                    .g = -scene.gravity.y(),
                    .sideways = scene.gravity.x(),
                    .e = pair.restitution,
                    .p = pair.restitution_exponent,
                    .stick = pair.sticking_speed * pair.sticking_speed,
                    .turned = scene.observe.axes_turned};
    for (double t = 0; t < scene.duration; t += scene.observe.every) {
        const auto [x, y] = path.at(t);
        series.append({t, x, y});
    }
    return series;
}

constexpr double sigma = 1e-3; // m

/// Drops from four heights, thrown along at `along`; x is read where `both`.
Measurement filmed(Path path, bool both, std::vector<std::string> causes, double odd_restitution = 0) {
    Rng rng(3);
    Measurement all;
    all.title = "drops";
    all.causes = std::move(causes);
    all.nuisances = {{.key = "pair.rubber-rubber.restitution", .instrument = "", .spread = 0.05},
                     {.key = "", .instrument = "clock_offset", .per_record = true, .spread = 0.005}};
    for (const double height : {0.4, 0.7, 1.1, 1.5}) {
        path.height = height;
        Path now = path;
        now.e += height == 0.7 ? odd_restitution : 0;
        Record record{
            .name = shortest(height),
            .condition = shortest(height),
            .file = "none.csv",
            .sets = {"fill.0.position_m.1=" + shortest(height), "fill.0.velocity_m_s.0=" + shortest(path.along)},
            .time = {},
            .channels = {}};
        Channel x{.head = "x_m", .measure = "centre_of_mass_x", .unit = "m", .value = {}, .sigma = sigma};
        Channel y{.head = "y_m", .measure = "centre_of_mass_y", .unit = "m", .value = {}, .sigma = sigma};
        for (int k = 0; k < 200; ++k) {
            record.time.push_back(k / 120.0);
            const auto [right, up] = now.at(record.time.back());
            x.value.push_back(right + sigma * gauss(rng));
            y.value.push_back(up + sigma * gauss(rng));
        }
        if (both)
            record.channels.push_back(std::move(x));
        record.channels.push_back(std::move(y));
        all.records.push_back(std::move(record));
    }
    return all;
}

Diagnosis diagnosed(const Measurement& measurement) {
    auto result = diagnose::diagnose({floor_and_ball, "ball.toml"}, measurement, closed_form);
    REQUIRE_MESSAGE(result, to_string(result.problems()));
    return std::move(*result);
}

void check_named(const Diagnosis& diagnosis, const std::string& id, double amplitude) {
    REQUIRE_MESSAGE(diagnosis.decision.outcome == Outcome::named, verdict_of(diagnosis));
    CHECK_MESSAGE(diagnosis.decision.sure, verdict_of(diagnosis));
    CHECK(!diagnosis.decision.one_class);
    const Refit& best = *diagnosis.decision.best;
    CHECK(diagnosis.causes[static_cast<std::size_t>(best.causes[0])].id == id);
    CHECK(std::abs(best.amplitude[0] - amplitude) < 4 * best.error[0]);
}

} // namespace

TEST_CASE("surfaces that stick are named, beside a restitution that falls with speed") {
    const Diagnosis diagnosis =
        diagnosed(filmed({.e = 0.79, .stick = 0.3}, false,
                         {"rest.velocity", "rest.cutoff", "gravity", "clock", "sensor scale", "filter"}));
    check_named(diagnosis, "rest.cutoff", 0.3);
    REQUIRE(diagnosis.extended);
    CHECK(diagnosis.extended->pair(0, 0).sticking_speed == about(std::sqrt(0.3), 0.05));
}

TEST_CASE("a camera that leans by a tenth of a degree is named where both coordinates were read, ground that leans "
          "beside it") {
    const double tenth = 0.1 / 57.29577951308232;
    const std::vector<std::string> causes{"sensor axes", "tilt", "gravity", "clock", "sensor scale"};
    const Diagnosis camera = diagnosed(filmed({.along = 0.4, .turned = tenth}, true, causes));
    check_named(camera, "ins.align", 0.1);
    const Diagnosis ground = diagnosed(filmed({.along = 0.4, .sideways = 9.81 * tenth}, true, causes));
    check_named(ground, "grav.tilt_x", 0.1);
}

TEST_CASE("a camera that leans is no suspect where one coordinate was read, and is refused if it is asked for") {
    for (const Cause& cause : diagnosed(filmed({.along = 0.4}, false, {})).causes)
        CHECK(cause.id != "ins.align");
    const auto refused = diagnose::diagnose({floor_and_ball, "ball.toml"},
                                            filmed({.along = 0.4}, false, {"ins.align", "clock"}), closed_form);
    REQUIRE(!refused);
    CHECK(refused.problems()[0].what ==
          "ins.align shows only where one series has all of centre_of_mass_x, centre_of_mass_y");
}

TEST_CASE("a restitution that is another one in one condition is no cause: conditions differ, and it is told in what") {
    const std::vector<std::string> causes{"gravity", "clock", "sensor scale", "filter", "rest.velocity"};
    const Diagnosis odd = diagnosed(filmed({.e = 0.79}, false, causes, 0.01));
    REQUIRE_MESSAGE(odd.decision.outcome == Outcome::none_known, verdict_of(odd));
    REQUIRE_MESSAGE(odd.differing, verdict_of(odd));
    CHECK(odd.differing->what == "pair.rubber-rubber.restitution");
    CHECK(odd.differing->numbers == 4); // beside the one for all, of which something is known beforehand
    CHECK(verdict_of(odd).find("conditions differ (het.condition)") != std::string::npos);
    CHECK(next_step(odd).starts_with("Find out what changed between the conditions"));
    CHECK(!diagnosed(filmed({.e = 0.79}, false, causes)).differing); // alike, they agree
}

} // namespace test_named_in_flights
