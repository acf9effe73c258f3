#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

/// A ball that rolls along a level plane without being pushed, from `speed` (m/s, either way) on.
Result<Track> roll_away(double speed, const Values& values) {
    const double radius = 1e-3 * values["radius_mm"], bench_tilt = values["bench_tilt_deg"] / degrees;
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = values["friction"];
    pair.rolling_friction = values["rolling_friction"];
    scene::Scene scene = bench(material, pair, radius);
    scene.contact.additions.rolling = contact::RollingLaw::cdt;
    scene.air = {values["air_density_kg_m3"], 0, values["drag_coefficient"]};
    scene.gravity = gravity * Vector3d(std::sin(bench_tilt), -std::cos(bench_tilt), 0);
    place(scene, add_round(scene, radius), {0, radius, 0}, {speed, 0, 0}, {0, 0, -speed / radius});
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY());
    return watch(scene, values["longest_s"], 1 / values["rate_Hz"],
                 [&](const Track& so_far) { return std::abs(so_far.back().velocity.x()) < 0.02 * std::abs(speed); });
}

Result<Outcome> perform(const Values& values) {
    const double speed = values["speed_m_s"], mu = values["rolling_friction"];
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say("A ball rolls along a level plane until it has all but stopped, once each way. Rolling resistance slows "
              "it at a "
              "constant rate; a viscous film would let it creep for ever, air would hardly slow it towards the end.");
    sheet.formula("a = −5/7 μ_r g,   stops after v² / (2 a)");
    sheet::Grid grid{
        {{"way"}, {"slowing", "m/s2", 5}, {"5/7 μ_r g", "m/s2", 5}, {"from it μ_r", "", 4}, {"straightest"}}};
    sheet::Figure figure{
        .name = "roll-out", .title = "A ball that rolls out", .x = {"time", "s"}, .y = {"speed", "m/s"}};
    const double theory = 5.0 / 7 * mu * gravity;
    double sum = 0;
    std::string best;
    for (const auto& [name, way] : {std::pair{"forth", 1.0}, std::pair{"back", -1.0}}) {
        const Result<Track> track = roll_away(way * speed, values);
        if (!track)
            return track.problems();
        std::vector<double> time, rate;
        Recording record{fmt::format("roll-out-{}", name), {"t_s", "moved_m", "speed_m_s"}};
        sheet::Curve curve{name};
        for (const Seen& seen : *track) {
            const double v = way * seen.velocity.x();
            record.rows.push_back({seen.time, way * seen.position.x(), v});
            curve.add(seen.time, v);
            if (v > 0.1 * speed) {
                time.push_back(seen.time);
                rate.push_back(v);
            }
        }
        if (time.size() < 5)
            return Problem{.key = "--rate_Hz",
                           .what = "fewer than five looks before it stood still",
                           .fix = "give a higher --rate_Hz or --speed_m_s, or less --rolling_friction"};
        const double slowing = -line_through(time, rate).slope;
        best = slowing_of(time, rate, "v").best;
        grid.rows.push_back({name, slowing, theory, 1.4 * slowing / gravity, best});
        sum += 0.5 * slowing;
        figure.curves.push_back(std::move(curve));
        outcome.recordings.push_back(std::move(record));
    }
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    const double tilt =
        0.5 * (std::get<double>(grid.rows[1][1]) - std::get<double>(grid.rows[0][1])) / (5.0 / 7 * gravity);
    sheet.say(fmt::format(
        "The mean of both ways gives a rolling resistance of {:.4g}; half their difference a bench that is off "
        "level by {:.2g} deg.",
        1.4 * sum / gravity, degrees * tilt));
    sheet.fact("rolling_friction", 1.4 * sum / gravity);
    sheet.fact("bench_tilt", degrees * tilt, "deg");
    sheet.fact("dry_is_best", best == "dry friction" ? 1 : 0);
    return outcome;
}

} // namespace

Experiment roll_out() {
    return {.name = "roll-out",
            .title = "Roll-out: rolling resistance, both ways",
            .parameters = {{"rolling_friction", "", 0.02, {.lo = 0, .hi = 0.5}, "Rolling resistance of the law"},
                           {"speed_m_s", "m/s", 0.3, {.lo = 0.01, .hi = 10}, "First speed; the ball begins rolling"},
                           {"longest_s", "s", 3, {.lo = 0.05, .hi = 20}, "Watched no longer than this"},
                           {"bench_tilt_deg", "deg", 0, {.lo = -2, .hi = 2}, "How far the bench itself is off level"},
                           {"air_density_kg_m3", "kg/m3", 0, {.lo = 0, .hi = 2000}, "Density of the air; 0: none"},
                           drag_parameter(),
                           {"radius_mm", "mm", 12.75, {.lo = 0.5, .hi = 500}, "Radius of the ball"},
                           density_parameter(),
                           modulus_parameter(1e7),
                           poisson_parameter(),
                           restitution_parameter(0.3),
                           friction_parameter(),
                           {"rate_Hz", "Hz", 100, {.lo = 20, .hi = 1e5}, "Samples a second of the records"}},
            .perform = perform};
}

} // namespace tumble::lab
