#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

constexpr double foot = 5e-3;                      // m, radius of a foot
constexpr double first = 1e-4, second = 8 * first; // m slid: cube roots in the ratio 1 to 2
constexpr double rate = 500;                       // looks a second

struct Slip {
    double angle = 0; // rad, at which it began
    Recording record;
};

/// How far the body has slid on a plane through the origin that is tilted by now.
double slid(const Seen& seen) {
    return seen.position.x() * std::cos(seen.wall_angle) + seen.position.y() * std::sin(seen.wall_angle);
}

/// When the track passed a distance, by straight lines between looks.
double time_at(const Track& track, double distance) {
    for (std::size_t k = 1; k < track.size(); ++k) {
        const double before = std::abs(slid(track[k - 1]) - slid(track[0])),
                     now = std::abs(slid(track[k]) - slid(track[0]));
        if (now >= distance)
            return track[k - 1].time + (track[k].time - track[k - 1].time) * (distance - before) / (now - before);
    }
    return track.back().time;
}

/// Tilts the plane at a constant speed until the tripod has slid. `way` 1: the +x side goes up; -1: the other.
Result<Slip> tilt(double friction, double way, const Values& values) {
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = friction;
    scene::Scene scene = bench(material, pair, foot);
    const double bench_tilt = values["bench_tilt_deg"] / degrees, speed = values["tilt_deg_s"] / degrees;
    scene.gravity = gravity * Vector3d(std::sin(bench_tilt), -std::cos(bench_tilt), 0);
    place(scene, add_body(scene, tripod(foot)), {0, foot, 0});
    scene::Rotation turning;
    turning.active.start = 0.05; // s, in which the tripod settles
    turning.axis = Vector3d::UnitZ();
    turning.angular_velocity = way * speed;
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY()).motion.rotations.push_back(turning);
    const double longest = turning.active.start + (std::atan(friction) + std::abs(bench_tilt) + 0.2) / speed;
    const Result<Track> track = watch(scene, longest, 1 / rate, [](const Track& so_far) {
        return std::abs(slid(so_far.back()) - slid(so_far.front())) > second;
    });
    if (!track)
        return track.problems();
    if (std::abs(slid(track->back()) - slid(track->front())) < second)
        return Problem{.what =
                           fmt::format("with friction {:.3g} the body did not slide before the plane had passed the "
                                       "angle of friction by 10 degrees",
                                       friction),
                       .fix = "tilt more slowly"};
    Slip slip;
    // s'' = g sin(tilt - phi) / cos phi grows from nothing, so s begins as a cube of time: two distances in the ratio 1
    // to 8 lie equally far apart in time, and as far again before them lies the beginning.
    const double began = 2 * time_at(*track, first) - time_at(*track, second);
    slip.angle = speed * (began - turning.active.start);
    slip.record = {fmt::format("slide-{:.2f}-{}", friction, way > 0 ? "forth" : "back"),
                   {"t_s", "angle_deg", "slid_m"}};
    for (const Seen& seen : *track)
        slip.record.rows.push_back(
            {seen.time, degrees * std::abs(seen.wall_angle), std::abs(slid(seen) - slid(track->front()))});
    return slip;
}

Result<Outcome> perform(const Values& values) {
    const auto count = static_cast<int>(values["frictions"]);
    const double lowest = values["lowest"], highest = values["highest"];
    if (count > 1 && lowest >= highest)
        return Problem{.key = "--highest",
                       .what = "the highest friction is not above the lowest",
                       .fix = "give --highest above --lowest, or --frictions 1"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "A tripod stands on a plane that is tilted slowly until it slides; friction is the tangent of that angle. The "
        "thesis made its calibration curve in this way (figure 4.7): friction from 0.1 to 1, one run each. Here the "
        "plane is tilted both ways: where the bench itself is not level, the two angles differ by twice its tilt and "
        "their mean is still right.");
    sheet.formula("tan α = μ", "thesis 4.2.2");
    sheet::Grid grid{{{"friction"},
                      {"slides at", "deg", 5},
                      {"other way", "deg", 5},
                      {"arctan μ", "deg", 5},
                      {"mean's tangent", "", 5},
                      {"bench tilt", "deg", 2}}};
    sheet::Figure figure{.name = "slide",
                         .title = "Angle at which a body begins to slide",
                         .x = {"friction"},
                         .y = {"angle", "deg"},
                         .curves = {{"arctan μ", sheet::Style::line, {}, {}, 0},
                                    {"solver, mean of both ways", sheet::Style::points, {}, {}, 1}}};
    Recording table{"slide", {"friction", "angle_forth_deg", "angle_back_deg"}};
    double worst = 0;
    for (int k = 0; k < count; ++k) {
        const double mu = count == 1 ? lowest : lowest + (highest - lowest) * k / (count - 1);
        Result<Slip> forth = tilt(mu, 1, values), back = tilt(mu, -1, values);
        if (!forth || !back)
            return (forth ? back : forth).problems();
        const double mean = 0.5 * (forth->angle + back->angle), seen = std::tan(mean);
        grid.rows.push_back({mu, degrees * forth->angle, degrees * back->angle, degrees * std::atan(mu), seen,
                             0.5 * degrees * (forth->angle - back->angle)});
        figure.curves[1].add(mu, degrees * mean);
        table.rows.push_back({mu, degrees * forth->angle, degrees * back->angle});
        worst = std::max(worst, std::abs(seen - mu));
        outcome.recordings.push_back(std::move(forth->record));
        outcome.recordings.push_back(std::move(back->record));
    }
    for (int k = 0; k <= 60; ++k)
        figure.curves[0].add(1.1 * highest * k / 60, degrees * std::atan(1.1 * highest * k / 60));
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.say(fmt::format("Friction read from the angles is off by at most {:.1g}.", worst));
    sheet.fact("worst_friction", worst);
    sheet.fact("bench_tilt", std::get<double>(grid.rows.front()[5]), "deg");
    outcome.recordings.push_back(std::move(table));
    return outcome;
}

} // namespace

Experiment slide() {
    return {
        .name = "slide",
        .title = "Inclined plane: sliding angle to friction",
        .parameters = {{"frictions", "", 10, {.lo = 1, .hi = 30}, "How many frictions, evenly spaced (whole number)"},
                       {"lowest", "", 0.1, {.lo = 0.02, .hi = 1.5}, "Lowest friction"},
                       {"highest", "", 1.0, {.lo = 0.02, .hi = 1.5}, "Highest friction"},
                       {"tilt_deg_s", "deg/s", 20, {.lo = 1, .hi = 60}, "Speed at which the plane is tilted"},
                       {"bench_tilt_deg", "deg", 0, {.lo = -10, .hi = 10}, "How far the bench itself is off level"},
                       density_parameter(),
                       modulus_parameter(1e7),
                       poisson_parameter(),
                       restitution_parameter()},
        .perform = perform};
}

} // namespace tumble::lab
