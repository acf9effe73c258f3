#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

/// After the impact, for speeds before of `normal` and `tangential` (m/s): tangential speed, spin times radius.
struct Rebound {
    double normal = 0, tangential = 0, surface = 0; // m/s
};

/// Rigid body, Coulomb friction (Walton 1993): slides throughout, or leaves rolling; a real contact that sticks also
/// winds up its tangential spring, which this leaves out.
Rebound rigid(double normal, double tangential, double e, double mu) {
    const double slid = mu * (1 + e) * normal;
    if (slid <= 2.0 / 7 * tangential)
        return {e * normal, tangential - slid, 2.5 * slid};
    return {e * normal, 5.0 / 7 * tangential, 5.0 / 7 * tangential};
}

Result<Rebound> strike(double normal, double tangential, const Values& values) {
    const double radius = 1e-3 * values["radius_mm"];
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = values["friction"];
    scene::Scene scene = bench(material, pair, radius, 0.02);
    scene.gravity = Vector3d::Zero();
    const double gap = 0.01 * radius;
    place(scene, add_round(scene, radius), {0, radius + gap, 0}, {tangential, -normal, 0});
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY());
    const double until = 20 * gap / (normal * std::max(0.05, values["restitution"])) + 2000 * scene.time_step;
    const Result<Track> track = watch(scene, until, 10 * scene.time_step, [&](const Track& so_far) {
        return so_far.back().velocity.y() > 0 && so_far.back().position.y() > radius + gap;
    });
    if (!track)
        return track.problems();
    const Seen& last = track->back();
    if (last.velocity.y() <= 0)
        return Problem{.what = "the ball did not leave the plate", .fix = "give a higher restitution or speed"};
    return Rebound{last.velocity.y(), last.velocity.x(), -radius * last.spin.z()};
}

Result<Outcome> perform(const Values& values) {
    const double speed = values["speed_m_s"], e = values["restitution"], mu = values["friction"];
    const auto angles = static_cast<int>(values["angles"]);
    const double lowest = values["lowest_deg"], highest = values["highest_deg"];
    if (angles > 1 && lowest >= highest)
        return Problem{.key = "--highest_deg",
                       .what = "the highest angle is not above the lowest",
                       .fix = "give --highest_deg above --lowest_deg, or --angles 1"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    const double slides_from = degrees * std::atan(3.5 * mu * (1 + e));
    sheet.say(
        "A ball without spin strikes a plate at several angles, measured from the normal, without gravity. At grazing "
        "angles it slides throughout and what friction takes does not depend on the angle; at steep ones it leaves "
        "rolling, or, where its tangential spring has wound up, with more spin than that.");
    sheet.formula("slides:  v_t' = v_t − μ (1 + e) v_n,   R ω' = 5/2 μ (1 + e) v_n", "Walton 1993");
    sheet.formula(
        fmt::format("rolls:  v_t' = R ω' = 5/7 v_t;   slides from arctan(7/2 μ (1 + e)) = {:.4g} deg on", slides_from));
    sheet::Grid grid{{{"angle", "deg"},
                      {"e", "", 5},
                      {"v_t'", "m/s", 5},
                      {"rigid", "m/s", 5},
                      {"R ω'", "m/s", 5},
                      {"rigid", "m/s", 5},
                      {"contact"}}};
    sheet::Figure figure{
        .name = "oblique",
        .title = "Oblique impact: share of the tangential speed that is kept",
        .x = {"angle from the normal", "deg"},
        .y = {"v_t' / v_t"},
        .curves = {{"rigid body", sheet::Style::line, {}, {}, 0}, {"solver", sheet::Style::points, {}, {}, 1}}};
    Recording record{"oblique", {"angle_deg", "normal_restitution", "tangential_speed_m_s", "spin_rad_s"}};
    double worst = 0;
    for (int k = 0; k < angles; ++k) {
        const double angle = angles == 1 ? lowest : lowest + (highest - lowest) * k / (angles - 1);
        const double normal = speed * std::cos(angle / degrees), tangential = speed * std::sin(angle / degrees);
        const Result<Rebound> seen = strike(normal, tangential, values);
        if (!seen)
            return seen.problems();
        const Rebound theory = rigid(normal, tangential, e, mu);
        const bool slides = angle > slides_from;
        grid.rows.push_back({angle, seen->normal / normal, seen->tangential, theory.tangential, seen->surface,
                             theory.surface, slides ? "slides" : "sticks"});
        figure.curves[1].add(angle, seen->tangential / tangential);
        record.rows.push_back(
            {angle, seen->normal / normal, seen->tangential, seen->surface / (1e-3 * values["radius_mm"])});
        if (slides)
            worst = std::max(worst, std::abs(seen->tangential - theory.tangential) / speed);
    }
    for (int k = 1; k <= 89; ++k) {
        const double t = speed * std::sin(k / degrees);
        figure.curves[0].add(k, rigid(speed * std::cos(k / degrees), t, e, mu).tangential / t);
    }
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.say(
        fmt::format("Where it slides, solver and closed form differ by at most {:.1g} of the speed: at the end "
                    "of a rebound the law pulls, the harder the lower e, and Coulomb's limit counts that too. Where it "
                    "sticks they differ by the spring: the contact gives back part of what it stored.",
                    worst));
    sheet.fact("worst_sliding", worst);
    outcome.recordings.push_back(std::move(record));
    return outcome;
}

} // namespace

Experiment oblique() {
    return {.name = "oblique",
            .title = "Oblique impact: friction and tangential restitution over the angle",
            .parameters = {{"angles", "", 6, {.lo = 1, .hi = 30}, "How many angles, evenly spaced (whole number)"},
                           {"lowest_deg", "deg", 10, {.lo = 1, .hi = 89}, "Steepest impact, from the normal"},
                           {"highest_deg", "deg", 80, {.lo = 1, .hi = 89}, "Most grazing impact"},
                           {"speed_m_s", "m/s", 2, {.lo = 0.01, .hi = 50}, "Speed of approach"},
                           {"radius_mm", "mm", 12.75, {.lo = 0.1, .hi = 500}, "Radius of the ball"},
                           density_parameter(),
                           modulus_parameter(4.6e9),
                           poisson_parameter(),
                           restitution_parameter(),
                           friction_parameter(0.2)},
            .perform = perform};
}

} // namespace tumble::lab
