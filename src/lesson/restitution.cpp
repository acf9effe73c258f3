#include "lesson/each.h"
#include "lesson/impact.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int steps_per_contact = 1000;
constexpr double fastest = 4; // times the speed asked for
// That of Chung and Ooi 2011, test 1: as stiff as it is, so that at four times the default speed a ball sinks in by
// less than a hundredth of its radius (1.5 % at four times 2 m/s) and Hertz' law, which takes the contact to be small,
// holds.
const contact::Material glass{"glass", 2800, 4.8e10, 0.2};

struct Setup {
    double e = 0, speed = 0, k = 0, mass = 0, radius = 0; // -, m/s, N/m, kg, m

    explicit Setup(const Values& values)
        : e(values["restitution"]), speed(values["speed_m_s"]), k(values["normal_stiffness_N_per_m"]),
          mass(values["mass_kg"]), radius(values["radius_mm"] * 1e-3) {}

    [[nodiscard]] double omega() const { return std::sqrt(k / mass); }
    [[nodiscard]] double step() const { return pi / omega() / steps_per_contact; }
    [[nodiscard]] Result<Impact> linear(double restitution, double at_speed, bool limit_force = false) const {
        return strike_disc(linear_pair(k, 1, restitution, 0), mass, at_speed, step(), limit_force);
    }
    [[nodiscard]] HertzImpact elastic(double at_speed) const {
        const double E_eff = contact::derive(glass, glass, {}).E_eff;
        return hertz_impact(E_eff, radius, 4.0 / 3 * pi * std::pow(radius, 3) * glass.density, at_speed);
    }
    [[nodiscard]] Result<Impact> hertz(double restitution, double at_speed) const {
        contact::PairProperties pair;
        pair.restitution = restitution;
        return strike_sphere(glass, pair, radius, at_speed, elastic(at_speed).duration / steps_per_contact);
    }
};

/// Restitution of a linear contact that may not pull (Schwager and Pöschel 2007): it ends when the force is zero,
/// before the overlap is.
double restitution_without_pull(double zeta) {
    const double root = std::sqrt(1 - zeta * zeta);
    return std::exp(-zeta / root * (pi - std::atan2(2 * zeta * root, 1 - 2 * zeta * zeta)));
}

std::optional<Problem> one_impact(Walk& walk, const Setup& s) {
    const Result<Impact> hit = s.linear(s.e, s.speed);
    if (!hit)
        return hit.problems().front();
    const double zeta = damping_ratio(s.e), w = s.omega(), damped = w * std::sqrt(1 - zeta * zeta);
    const double deepest = s.speed / w * std::exp(-zeta * w * std::acos(zeta) / damped);
    walk.head("A spring and a dashpot");
    walk.say("A disc strikes a wall. The spring gives back what it took; only the dashpot, a force against the rate of "
             "the overlap, takes energy for good. Together they are the damped oscillator, and an impact is half a "
             "swing of it:");
    walk.formula("m n'' + c n' + κ n = 0,   c = 2 ζ √(κ m),   ω = √(κ / m)");
    walk.formula("e = exp(−π ζ / √(1 − ζ²)),   so   ζ = −ln e / √(π² + ln² e)");
    walk.say(
        fmt::format("For e = {:.4g} that is ζ = {:.4g}. Half a swing then says how deep, and how long:", s.e, zeta));
    walk.parts.emplace_back(
        Grid{{{""}, {"solver", "", 5}, {"closed form", "", 5}, {"unit"}, {"formula"}},
             {{"restitution", hit->restitution, s.e, "", "speed away / speed towards"},
              {"deepest overlap", 1e6 * hit->overlap_max, 1e6 * deepest, "um", "v/ω exp(−ζ arccos ζ / √(1 − ζ²))"},
              {"contact time", 1e6 * hit->duration, 1e6 * pi / damped, "us", "π / (ω √(1 − ζ²))"},
              {"energy lost", 100 * (1 - hit->restitution * hit->restitution), 100 * (1 - s.e * s.e), "%", "1 − e²"}}});
    walk.fact("restitution", hit->restitution);
    walk.fact("overlap", hit->overlap_max, "m");
    walk.fact("duration", hit->duration, "s");
    return std::nullopt;
}

std::optional<Problem> loops(Walk& walk, const Setup& s) {
    Figure figure{.name = "loops",
                  .title = "One impact, linear law: what is inside the loop is lost",
                  .x = {"overlap", "um"},
                  .y = {"normal force", "N"},
                  .curves = {}};
    constexpr double dull = 0.3;
    double pull = 0; // of the last
    for (const double e : {1.0, s.e, dull}) {
        const Result<Impact> hit = s.linear(e, s.speed);
        if (!hit)
            return hit.problems().front();
        pull = -hit->force_min / hit->force_max;
        if (e == s.e && (e == 1.0 || e == dull)) // has its curve
            continue;
        Curve curve{fmt::format("e = {:.3g}", e), Style::line, {}, {}};
        for (std::size_t k = 1; k < hit->force.size(); k += 5)
            if (hit->overlap[k] > 0)
                curve.add(1e6 * hit->overlap[k], hit->force[k]);
        figure.curves.push_back(std::move(curve));
    }
    const Result<Impact> limited = s.linear(dull, s.speed, true);
    if (!limited)
        return limited.problems().front();
    const double expected = restitution_without_pull(damping_ratio(dull));
    walk.say("In the plane of force and overlap an impact without a dashpot goes out on the line it went in on. With "
             "one it begins with a jump, since the dashpot feels the full speed at the first touch, and goes round a "
             "loop whose area is the loss.");
    walk.parts.emplace_back(figure);
    walk.say(fmt::format("Look at the end: just before they part, the bodies separate faster than the spring pushes, "
                         "and the contact pulls, at e = {} with up to {:.0f} % of the largest push. Dry grains do not "
                         "stick. `limit_force = true` cuts the pull off; then the contact ends sooner, loses less, and "
                         "{} becomes {:.4g} (closed form of Schwager and Pöschel 2007: {:.4g}).",
                         dull, 100 * pull, dull, limited->restitution, expected));
    walk.fact("pull", pull);
    walk.fact("limited_restitution", limited->restitution);
    walk.fact("limited_restitution_predicted", expected);
    return std::nullopt;
}

std::optional<Problem> in_and_out(Walk& walk, const Setup& s) {
    walk.head("What goes in comes out");
    walk.say("The same with a sphere and Hertz' law, whose dashpot grows with the contact so that restitution stays "
             "what it is (Tsuji et al. 1992):");
    Grid grid{{{"e asked for"}, {"ζ", "", 4}, {"linear", "", 5}, {"Hertz", "", 5}}, {}};
    for (const double e : {1.0, 0.9, 0.7, 0.5, 0.3, 0.1}) {
        const Result<Impact> linear = s.linear(e, s.speed), hertz = s.hertz(e, s.speed);
        if (!linear || !hertz)
            return (linear ? hertz : linear).problems().front();
        grid.rows.push_back({e, damping_ratio(e), linear->restitution, hertz->restitution});
        walk.fact(fmt::format("linear_restitution_{}", e), linear->restitution);
        walk.fact(fmt::format("hertz_restitution_{}", e), hertz->restitution);
    }
    walk.parts.emplace_back(grid);
    return std::nullopt;
}

std::optional<Problem> speeds(Walk& walk, const Setup& s) {
    walk.head("Fast and slow");
    walk.say(fmt::format(
        "A linear contact lasts equally long at every speed. Hertz' contact is stiffer the deeper it goes, so a "
        "fast impact is shorter. A sphere of glass, {:.3g} mm in radius (E = {:.3g} Pa, ν = {:.3g}, {:.0f} kg/m3), "
        "strikes a wall of glass at 0.01 to {:.0f} times the speed above, beside the disc with its spring of {:.3g} "
        "N/m:",
        1e3 * s.radius, glass.youngs_modulus, glass.poisson_ratio, glass.density, fastest, s.k));
    walk.formula("δ_max = (15 m v² / (16 E* √R))^(2/5),   T = 2.9433 δ_max / v ~ v^(−1/5)", "Johnson 1985");
    walk.formula("1/E* = 2 (1 − ν²) / E");
    Grid grid{{{"speed", "m/s"},
               {"linear, time", "us"},
               {"Hertz, time", "us"},
               {"closed form", "us"},
               {"overlap / R", "%", 3},
               {"e (1)", "", 5}},
              {}};
    Figure figure{.name = "duration",
                  .title = "How long an elastic impact lasts (sphere, Hertz)",
                  .x = {"speed", "m/s", true},
                  .y = {"contact time", "us"},
                  .curves = {{"Hertz, closed form", Style::line, {}, {}}, {"solver", Style::points, {}, {}}}};
    for (const double factor : {0.01, 0.1, 1.0, fastest}) {
        const double v = factor * s.speed;
        const Result<Impact> linear = s.linear(1, v), hertz = s.hertz(1, v);
        if (!linear || !hertz)
            return (linear ? hertz : linear).problems().front();
        const HertzImpact theory = s.elastic(v);
        grid.rows.push_back({v, 1e6 * linear->duration, 1e6 * hertz->duration, 1e6 * theory.duration,
                             100 * hertz->overlap_max / s.radius, hertz->restitution});
        figure.curves[1].add(v, 1e6 * hertz->duration);
        walk.fact(fmt::format("hertz_duration_{}", factor), hertz->duration, "s");
        walk.fact(fmt::format("hertz_overlap_{}", factor), hertz->overlap_max, "m");
    }
    constexpr int points = 60; // smooth on its logarithmic axis
    for (int k = 0; k <= points; ++k) {
        const double v = s.speed * 0.01 * std::pow(400.0, static_cast<double>(k) / points);
        figure.curves[0].add(v, 1e6 * s.elastic(v).duration);
    }
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(figure);
    const double share = s.elastic(fastest * s.speed).overlap / s.radius;
    walk.say(
        fmt::format("Hertz takes the circle of contact to be small against the sphere. Its radius is √(R δ): at an "
                    "overlap of {:.2g} % of R, the deepest above, it has {:.2g} % of R. Softer grains, which save "
                    "steps, sink in further; the law then still gives back the e that was asked for, but what it "
                    "says of forces and times is no longer what such a ball would do.",
                    100 * share, 100 * std::sqrt(share)));
    return std::nullopt;
}

/// Values of which no impact can be made: the disc would sink half into the wall.
std::optional<Problem> refuse(const Setup& s) {
    const double speed = fastest * s.speed, deepest = speed / s.omega(), most = struck_radius / 2;
    if (deepest <= most)
        return std::nullopt;
    return Problem{
        .key = "--normal_stiffness_N_per_m",
        .what = fmt::format(
            "a disc of {:.4g} kg on a spring of {:.4g} N/m sinks {:.3g} m into the wall at {:.3g} "
            "m/s, the fastest impact of this lesson; it is a disc {:.3g} m in radius (--radius_mm is the sphere's)",
            s.mass, s.k, deepest, speed, struck_radius),
        .fix = fmt::format("give a spring of at least {:.3g} N/m, less mass or less speed",
                           s.mass * std::pow(speed / most, 2))};
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    if (const auto problem = refuse(s))
        return *problem;
    Walk walk;
    walk.say("Nobody owns a gauge for a dashpot. What can be measured is how high a ball comes back: the coefficient "
             "of restitution e, whose square is the ratio of rebound height to drop height. How does the law get from "
             "e to its dashpot?");
    for (const auto add : {one_impact, loops, in_and_out, speeds})
        if (const auto problem = add(walk, s))
            return *problem;
    const double left = std::pow(s.e, 2 * 5);
    walk.question = fmt::format("With e = {:.4g}, what part of its energy does a ball have left after five bounces? "
                                "And would a stiffer spring change that?",
                                s.e);
    walk.answer =
        fmt::format("e to the power 10: {:.3g}. Stiffness changes overlap and contact time, not restitution: c is made "
                    "from ζ and grows with √κ. That holds for an impact of two bodies alone. In a bed soft grains "
                    "touch longer, contacts overlap in time, and what several of them give back together does depend "
                    "on κ.",
                    left);
    return walk;
}

} // namespace

Lesson restitution() {
    return {
        .name = "restitution",
        .title = "Restitution and damping: from a measured rebound to a dashpot",
        .parameters = {{"restitution",
                        "",
                        0.667,
                        {.lo = 0.05, .hi = 1},
                        "Coefficient of restitution e (thesis, table 4.4: media on media)"},
                       {"speed_m_s", "m/s", 1, {.lo = 1e-3, .hi = 2}, "Speed of the impact, v"},
                       {"normal_stiffness_N_per_m", "N/m", 1e7, {.lo = 1e4, .hi = 1e9}, "Spring of the linear law, κ"},
                       {"mass_kg",
                        "kg",
                        1.466e-3,
                        {.lo = 1e-6, .hi = 10},
                        "Mass of the disc, m; the sphere's follows from its radius"},
                       {"radius_mm", "mm", 5, {.lo = 0.1, .hi = 100}, "Radius of the sphere, R"}},
        .teach = teach};
}

} // namespace tumble::lesson
