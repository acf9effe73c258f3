#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

constexpr double foot = 5e-3; // m, radius of a foot

Result<Outcome> perform(const Values& values) {
    const double mu = values["friction"], first = values["spin_rad_s"];
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = mu;
    scene::Scene scene = bench(material, pair, foot);
    place(scene, add_body(scene, tripod(foot)), {0, foot, 0}, Vector3d::Zero(), {0, first, 0});
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY());
    // Three spheres of mass m/3 on a circle of radius c: I = m (c^2 + 2/5 r^2).
    const double reach = tripod_reach * foot;
    const double slowing = mu * gravity * reach / (reach * reach + 0.4 * foot * foot), stops = first / slowing;
    const Result<Track> track = watch(scene, 1.3 * stops, 1 / values["rate_Hz"]);
    if (!track)
        return track.problems();

    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say("A tripod is spun up on a plate and let go. The shape of the slowing names what slows it: dry friction a "
              "straight "
              "line, a viscous film an exponential, air a hyperbola.");
    sheet.formula("ω' = −μ m g c / I,   I = m (c² + 2/5 r²)");
    sheet::Figure figure{.name = "spin-down",
                         .title = "Spin of a tripod on a plate",
                         .x = {"time", "s"},
                         .y = {"spin", "rad/s"},
                         .curves = {{"solver", sheet::Style::points}, {"closed form", sheet::Style::line}}};
    Recording record{"spin-down", {"t_s", "spin_rad_s"}};
    std::vector<double> time, rate;
    double stopped = track->back().time;
    for (const Seen& seen : *track) {
        record.rows.push_back({seen.time, seen.spin.y()});
        figure.curves[0].add(seen.time, seen.spin.y());
        figure.curves[1].add(seen.time, std::max(0.0, first - slowing * seen.time));
        if (seen.spin.y() > 0.1 * first) {
            time.push_back(seen.time);
            rate.push_back(seen.spin.y());
        } else if (seen.spin.y() < 1e-3 * first) {
            stopped = std::min(stopped, seen.time);
        }
    }
    if (time.size() < 5)
        return Problem{.key = "--rate_Hz",
                       .what = "fewer than five looks before it stood still",
                       .fix = "give a higher --rate_Hz, a higher --spin_rad_s or less friction"};
    const Line line = line_through(time, rate);
    sheet.parts.emplace_back(sheet::Grid{{{""}, {"solver", "", 5}, {"closed form", "", 5}, {"unit"}},
                                         {{"slowing", -line.slope, slowing, "rad/s2"},
                                          {"stands still at", stopped, stops, "s"},
                                          {"friction from it", mu * -line.slope / slowing, mu, "-"}}});
    sheet.parts.emplace_back(figure);
    const Slowing shape = slowing_of(time, rate, "ω");
    sheet.parts.emplace_back(shape.grid);
    sheet.say(fmt::format("Straightest: {}.", shape.best));
    sheet.fact("slowing", -line.slope, "rad/s2");
    sheet.fact("slowing_theory", slowing, "rad/s2");
    sheet.fact("friction", mu * -line.slope / slowing);
    sheet.fact("dry_is_best", shape.best == "dry friction" ? 1 : 0);
    outcome.recordings.push_back(std::move(record));
    return outcome;
}

} // namespace

Experiment spin_down() {
    return {.name = "spin-down",
            .title = "Spin-down: what slows a spinning body",
            .parameters = {{"spin_rad_s", "rad/s", 40, {.lo = 1, .hi = 500}, "First spin about the vertical"},
                           friction_parameter(0.3),
                           density_parameter(),
                           modulus_parameter(),
                           poisson_parameter(),
                           restitution_parameter(),
                           {"rate_Hz", "Hz", 500, {.lo = 50, .hi = 1e5}, "Samples a second of the record"}},
            .perform = perform};
}

} // namespace tumble::lab
