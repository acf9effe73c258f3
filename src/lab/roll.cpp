#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

/// A ball on a slope: distance over time, downhill positive.
struct Ride {
    std::vector<double> time, moved, speed; // s, m, m/s
    /// Of the second half, m/s2, with its standard error.
    [[nodiscard]] Line acceleration() const {
        const auto half = static_cast<std::ptrdiff_t>(time.size() / 2);
        return line_through({time.begin() + half, time.end()}, {speed.begin() + half, speed.end()});
    }
};

/// Let go at rest on a plane that falls by `slope` (rad) towards +x, or towards -x when it is negative.
Result<Ride> ride(double slope, const Values& values) {
    const double radius = 1e-3 * values["radius_mm"], bench_tilt = values["bench_tilt_deg"] / degrees;
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = values["friction"];
    scene::Scene scene = bench(material, pair, radius);
    scene.gravity = gravity * Vector3d(std::sin(bench_tilt), -std::cos(bench_tilt), 0);
    const Vector3d normal(std::sin(slope), std::cos(slope), 0), down(std::cos(slope), -std::sin(slope), 0);
    place(scene, add_round(scene, radius), radius * normal);
    add_plane(scene, Vector3d::Zero(), normal);
    const Result<Track> track = watch(scene, values["duration_s"], 1 / values["rate_Hz"]);
    if (!track)
        return track.problems();
    const double way = slope < 0 ? -1 : 1;
    Ride ride;
    for (const Seen& seen : *track) {
        ride.time.push_back(seen.time);
        ride.moved.push_back(way * down.dot(seen.position - track->front().position));
        ride.speed.push_back(way * down.dot(seen.velocity));
    }
    return ride;
}

double theory(double slope, double mu) {
    return std::max(5.0 / 7 * gravity * std::sin(slope), gravity * (std::sin(slope) - mu * std::cos(slope)));
}

Result<Outcome> perform(const Values& values) {
    const auto angles = static_cast<int>(values["angles"]);
    const double lowest = values["lowest_deg"], highest = values["highest_deg"], mu = values["friction"];
    if (angles > 1 && lowest >= highest)
        return Problem{.key = "--highest_deg",
                       .what = "the highest slope is not above the lowest",
                       .fix = "give --highest_deg above --lowest_deg, or --angles 1"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "A ball is let go on a slope, which then is turned to fall the other way. It rolls while friction can hold its "
        "lowest point; beyond that it slips, and gets faster than a rolling ball would.");
    sheet.formula(
        fmt::format("rolls:  a = 5/7 g sin α   while tan α ≤ 7/2 μ, α ≤ {:.4g} deg", degrees * std::atan(3.5 * mu)));
    sheet.formula("slips:  a = g (sin α − μ cos α)");
    sheet::Grid grid{{{"slope", "deg"},
                      {"acceleration", "m/s2", 5},
                      {"other way", "m/s2", 5},
                      {"closed form", "m/s2", 5},
                      {"5/7 g sin α", "m/s2", 5},
                      {"bench tilt", "deg", 2}}};
    sheet::Figure figure{.name = "roll",
                         .title = "A ball on a slope",
                         .x = {"slope", "deg"},
                         .y = {"acceleration", "m/s2"},
                         .curves = {{"closed form", sheet::Style::line, {}, {}, 0},
                                    {"solver, mean of both ways", sheet::Style::points, {}, {}, 1}}};
    Recording table{"roll", {"slope_deg", "acceleration_forth_m_s2", "acceleration_back_m_s2"}};
    double worst = 0;
    for (int k = 0; k < angles; ++k) {
        const double slope = (angles == 1 ? lowest : lowest + (highest - lowest) * k / (angles - 1)) / degrees;
        const Result<Ride> forth = ride(slope, values), back = ride(-slope, values);
        if (!forth || !back)
            return (forth ? back : forth).problems();
        const double a = forth->acceleration().slope, b = back->acceleration().slope, mean = 0.5 * (a + b);
        // Rolling: the two differ by 5/7 g (sin(slope + tilt) - sin(slope - tilt)).
        const double sine = 0.5 * (a - b) / (5.0 / 7 * gravity * std::cos(slope));
        grid.rows.push_back({degrees * slope, a, b, theory(slope, mu), 5.0 / 7 * gravity * std::sin(slope),
                             degrees * std::asin(std::clamp(sine, -1.0, 1.0))});
        figure.curves[1].add(degrees * slope, mean);
        table.rows.push_back({degrees * slope, a, b});
        worst = std::max(worst, std::abs(mean - theory(slope, mu)) / gravity);
        for (const auto& [name, one] : {std::pair{"forth", &*forth}, std::pair{"back", &*back}}) {
            Recording record{fmt::format("roll-{:.1f}deg-{}", degrees * slope, name), {"t_s", "moved_m", "speed_m_s"}};
            for (std::size_t j = 0; j < one->time.size(); ++j)
                record.rows.push_back({one->time[j], one->moved[j], one->speed[j]});
            outcome.recordings.push_back(std::move(record));
        }
    }
    for (int k = 0; k <= 80; ++k)
        figure.curves[0].add(1.05 * highest * k / 80, theory(1.05 * highest * k / 80 / degrees, mu));
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.say(fmt::format(
        "Closed form and the mean of both ways differ by at most {:.1g} g. An acceleration that the two ways "
        "do not share is the bench's tilt; one below 5/7 g sin α that they share is rolling resistance.",
        worst));
    sheet.fact("worst_acceleration", worst);
    sheet.fact("bench_tilt", std::get<double>(grid.rows.front()[5]), "deg");
    outcome.recordings.push_back(std::move(table));
    return outcome;
}

} // namespace

Experiment roll() {
    return {.name = "roll",
            .title = "Ball on an inclined plane, both ways",
            .parameters = {{"angles", "", 6, {.lo = 1, .hi = 30}, "How many slopes, evenly spaced (whole number)"},
                           {"lowest_deg", "deg", 5, {.lo = 0.1, .hi = 80}, "Least slope"},
                           {"highest_deg", "deg", 55, {.lo = 0.1, .hi = 80}, "Steepest slope"},
                           {"duration_s", "s", 0.3, {.lo = 0.02, .hi = 3}, "How long it is watched"},
                           {"bench_tilt_deg", "deg", 0, {.lo = -5, .hi = 5}, "How far the bench itself is off level"},
                           {"radius_mm", "mm", 12.75, {.lo = 0.5, .hi = 500}, "Radius of the ball"},
                           density_parameter(),
                           modulus_parameter(),
                           poisson_parameter(),
                           restitution_parameter(),
                           friction_parameter(0.2),
                           {"rate_Hz", "Hz", 500, {.lo = 50, .hi = 1e5}, "Samples a second of the records"}},
            .perform = perform};
}

} // namespace tumble::lab
