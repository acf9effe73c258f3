#include "lesson/contrast.h"
#include "lesson/each.h"
#include "lesson/impact.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

using namespace contrast;

constexpr double pi = std::numbers::pi;
constexpr double slop = 0.005; // of the radius; docs/hard-contacts.md
struct Setup {
    double e = 0, mu = 0, k = 0, speed = 0; // -, -, N/m, m/s

    explicit Setup(const Values& values)
        : e(values["restitution"]), mu(values["friction"]), k(values["normal_stiffness_N_per_m"]),
          speed(values["speed_m_s"]) {}

    [[nodiscard]] double omega() const { return std::sqrt(k / mass); }
    [[nodiscard]] double soft_step() const { return pi / omega() / steps_a_contact; }
    [[nodiscard]] scene::Scene stage() const {
        scene::Scene scene = plane_stage(linear_pair(k, 0.7, e, mu), soft_step());
        scene.box2d = box2d;
        return scene;
    }
};

/// Largest force of an impact on spring and dashpot, over m v omega: where n''' = 0, at w_d t = 3 acos(zeta) - pi; from
/// zeta = 1/2 on the dashpot alone, at the first touch.
double largest_force(double zeta) {
    if (zeta >= 0.5)
        return 2 * zeta;
    return std::exp(-zeta * (3 * std::acos(zeta) - pi) / std::sqrt(1 - zeta * zeta));
}

/// A curve of steps: a force that lasts from one instant of the step's end back to the one before.
Curve stairs(const std::string& label, const Push& push) {
    Curve curve{label, Style::line, {}, {}};
    for (std::size_t k = 1; k < push.time.size(); ++k)
        for (const double time : {push.time[k - 1], push.time[k]})
            curve.add(1e3 * time, push.force[k]);
    return curve;
}

std::optional<Problem> one_impact(Walk& walk, const Setup& s) {
    walk.head("One impact");
    walk.say("A soft contact is a spring and a dashpot: an impact takes time, and there is a force at every instant of "
             "it. A hard contact knows neither overlap nor stiffness. It has one rule for the speeds before and after, "
             "and an impulse J that makes it true; Box2D finds the impulses of all contacts of a step together.");
    walk.formula("soft:  m n'' = −κ n − c n'", "(3.25), Cundall and Strack 1979");
    walk.formula("hard:  v_after = −e v_before,   J = m (1 + e) v,   |J_t| ≤ μ J", "Newton, Coulomb");
    const Result<Push> soft = strike(s.stage(), raft(1), s.speed), whole = strike(hard(s.stage()), raft(1), s.speed);
    scene::Scene finer = hard(s.stage());
    finer.box2d.time_step /= 2;
    const Result<Push> half = strike(finer, raft(1), s.speed);
    for (const Result<Push>* push : {&soft, &whole, &half})
        if (!*push)
            return push->problems().front();
    const double zeta = damping_ratio(s.e), damped = s.omega() * std::sqrt(1 - zeta * zeta);
    const double force = mass * s.speed * s.omega() * largest_force(zeta); // N
    const double deepest = s.speed / s.omega() * std::exp(-zeta * s.omega() * std::acos(zeta) / damped);
    walk.say(fmt::format("A disc of {:.4g} g strikes a floor at {:.4g} m/s, once with κ = {:.4g} N/m and once hard, in "
                         "steps of 1 ms and of 0.5 ms:",
                         1e3 * mass, s.speed, s.k));
    walk.parts.emplace_back(
        Grid{{{""}, {"soft"}, {"closed form"}, {"hard, 1 ms"}, {"hard, 0.5 ms"}, {"unit"}},
             {{"step", 1e3 * s.soft_step(), std::string("-"), 1.0, 0.5, "ms"},
              {"restitution", soft->restitution, s.e, whole->restitution, half->restitution, ""},
              {"contact lasts", 1e3 * soft->lasted, 1e3 * pi / damped, "one step", "one step", "ms"},
              {"deepest overlap", 1e3 * soft->deepest, 1e3 * deepest, 1e3 * whole->deepest, 1e3 * half->deepest, "mm"},
              {"largest force", soft->strongest, force, whole->strongest, half->strongest, "N"}}});
    Figure figure{
        .name = "force",
        .title = "The force of one impact, soft and hard",
        .x = {"time since the first touch", "ms", false, {{-1, 3}}},
        .y = {"force", "N"},
        .curves = {stairs("soft", *soft), stairs("hard, step 1 ms", *whole), stairs("hard, step 0.5 ms", *half)}};
    walk.parts.emplace_back(figure);
    walk.say(
        "All three leave with the same speed, and the area under all three curves is the same J. But the hard "
        "force is J over the step: halve the step and it doubles. It acts over the whole of the step in which Box2D "
        "finds the touch, the part before it included (here the touch falls into the middle of a step of 1 ms). It "
        "says nothing about the contact. What the "
        "soft one says, contact time, overlap and peak force, is as true as its stiffness.");
    walk.fact("soft_restitution", soft->restitution);
    walk.fact("hard_restitution", whole->restitution);
    walk.fact("soft_contact_time", soft->lasted, "s");
    walk.fact("soft_contact_time_predicted", pi / damped, "s");
    walk.fact("soft_force", soft->strongest, "N");
    walk.fact("soft_force_predicted", force, "N");
    walk.fact("hard_force_ratio", half->strongest / whole->strongest);
    walk.fact("hard_impulse", whole->strongest * hard_step, "N s");
    walk.fact("hard_impulse_predicted", mass * (1 + s.e) * s.speed, "N s");
    return std::nullopt;
}

std::optional<Problem> several_at_once(Walk& walk, const Setup& s) {
    walk.head("Several contacts at once");
    walk.say(
        "The same body lands flat on n discs. Soft, n contacts are n springs and n dashpots, and the body rebounds "
        "less than one contact would (`tumble lesson clumps`). Hard, each contact asks for e times its own speed, "
        "and all of them together ask for the same:");
    Grid grid{{{"discs"}, {"e, soft"}, {"closed form"}, {"e, hard"}}, {}};
    for (const int n : {1, 2, 4}) {
        const Result<Push> soft = strike(s.stage(), raft(n), s.speed),
                           whole = strike(hard(s.stage()), raft(n), s.speed);
        if (!soft || !whole)
            return (soft ? whole : soft).problems().front();
        const double zeta = std::sqrt(n) * damping_ratio(s.e);
        const double expected = zeta < 1 ? std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)) : 0;
        grid.rows.push_back({static_cast<double>(n), soft->restitution, expected, whole->restitution});
        walk.fact(fmt::format("soft_landing_{}", n), soft->restitution);
        walk.fact(fmt::format("hard_landing_{}", n), whole->restitution);
    }
    walk.parts.emplace_back(grid);
    return std::nullopt;
}

std::optional<Problem> in_a_row(Walk& walk, const Setup& s) {
    walk.head("One strikes two");
    walk.say(
        "Two discs lie in a row; a third strikes the first of them, e = 1, no friction. Momentum and energy leave the "
        "answer open: which of the two contacts acts first? Springs answer it, since the first disc must move "
        "before it can press the second. Hard contacts that touch act at once: the first asks for the striker's "
        "speed back, the second only that nothing closes in. With a gap of a millionth of a radius, which no "
        "eye would see, they act one after the other, and the last disc takes it all:");
    walk.formula("touching:  v₂ − v₁ = v,   v₃ = v₂,   v₁ + v₂ + v₃ = v   →   −1/3, 2/3, 2/3");
    Grid grid{{{"speed after / before"},
               {"striker", "", 3, 1},
               {"first", "", 3, 1},
               {"second", "", 3, 1},
               {"energy", "", 4, 1}},
              {}};
    for (const bool springs : {true, false})
        for (const double gap : {0.0, 1e-6 * radius}) {
            const auto after = cradle(springs ? s.stage() : hard(s.stage()), s.speed, gap);
            if (!after)
                return after.problems().front();
            const auto [a, b, c] = *after;
            const std::string name = fmt::format("{}, {}", springs ? "soft" : "hard", gap > 0 ? "apart" : "touching");
            grid.rows.push_back({name, a, b, c, a * a + b * b + c * c});
            const std::string fact = fmt::format("{}_{}", springs ? "soft" : "hard", gap > 0 ? "apart" : "touching");
            walk.fact(fact + "_striker", a);
            walk.fact(fact + "_last", c);
        }
    walk.parts.emplace_back(grid);
    walk.say(
        "All keep momentum and energy, and they disagree: what hard contacts answer here is a matter of which of them "
        "the program finds in a step. In a dense bed bodies are struck that touch others already.");
    return std::nullopt;
}

std::optional<Problem> sliding(Walk& walk, const Setup& s) {
    walk.head("What stays the same");
    const double expected = s.speed * s.speed / (2 * s.mu * g);
    const Result<double> soft = slides(s.stage(), s.mu, s.speed), whole = slides(hard(s.stage()), s.mu, s.speed);
    if (!soft || !whole)
        return (soft ? whole : soft).problems().front();
    walk.say(
        fmt::format("Coulomb's law is one law for both: the force, or the impulse, across a contact that slides is μ "
                    "times that along its normal. A block set on the floor at {:.4g} m/s slides v² / (2 μ g) = "
                    "{:.4g} m; soft {:.4g} m, hard {:.4g} m.",
                    s.speed, expected, *soft, *whole));
    walk.fact("slide_predicted", expected, "m");
    walk.fact("soft_slide", *soft, "m");
    walk.fact("hard_slide", *whole, "m");
    return std::nullopt;
}

std::optional<Problem> at_rest(Walk& walk, const Setup& s) {
    walk.head("What lies");
    walk.say(fmt::format("A column of {} discs stands between two walls. Springs carry the weight above them by their "
                         "overlap, so the column is shorter by an amount that a measured stiffness would predict:",
                         stacked));
    walk.formula("Σ (weight above) / κ = n (n + 1) / 2 · m g / κ");
    const double expected = stacked * (stacked + 1) / 2.0 * mass * g / s.k;
    const Result<double> soft = sunk(s.stage()), whole = sunk(hard(s.stage()));
    if (!soft || !whole)
        return (soft ? whole : soft).problems().front();
    walk.say(fmt::format(
        "{:.4g} um here ({:.4g} um in the solver). Hard discs do not sink. Box2D lets each contact "
        "overlap by up to its slop of {:.3g} of the radius, {:.3g} um, however heavy what lies on it is: {:.4g} "
        "um in all. That is a number of the program, not of the material.",
        1e6 * expected, 1e6 * *soft, slop, 1e6 * slop * radius, 1e6 * *whole));
    walk.fact("soft_sunk", *soft, "m");
    walk.fact("soft_sunk_predicted", expected, "m");
    walk.fact("hard_sunk", *whole, "m");
    return std::nullopt;
}

std::optional<Problem> cost(Walk& walk, const Setup& s) {
    walk.head("What it costs");
    const scene::Scene scene = pour(s.stage());
    const double passes = box2d.velocity_iterations + box2d.position_iterations;
    const Result<Poured> soft = watch_pour(scene, "soft", 1), whole = watch_pour(hard(scene), "hard", passes);
    if (!soft || !whole)
        return (soft ? whole : soft).problems().front();
    walk.say(
        fmt::format("{} discs fall into a box. The soft step must be a small part of the contact time; the hard one "
                    "only has to be short beside what the bodies do. But its impulses depend on each other, and "
                    "Box2D finds them by going over all contacts again and again, here {:.0f} times a step.",
                    *scene.fills[0].count, passes));
    walk.parts.emplace_back(Grid{{{""}, {"soft"}, {"hard"}, {"unit"}},
                                 {{"step", 1e6 * scene.time_step, 1e6 * hard_step, "us"},
                                  {"steps", static_cast<double>(soft->steps), static_cast<double>(whole->steps), ""},
                                  {"passes over contacts", soft->passes, whole->passes, ""},
                                  {"centre of mass at the end", 1e3 * soft->height, 1e3 * whole->height, "mm"}}});
    walk.parts.emplace_back(Figure{.name = "pour",
                                   .title = "Kinetic energy of discs that fall into a box",
                                   .x = {"time", "s"},
                                   .y = {"kinetic energy", "mJ"},
                                   .curves = {soft->energy, whole->energy}});
    Film film{.name = "soft-beside-hard",
              .title = "The same discs fall, soft and hard",
              .reels = {},
              .every = 0.01,
              .range = {0, 2}};
    for (const auto& [label, one] : {std::pair{"soft", scene}, std::pair{"hard", hard(scene)}}) {
        Result<Reel> reel = lesson::film(one, label, poured_for, film.every);
        if (!reel)
            return reel.problems().front();
        film.reels.push_back(std::move(*reel));
    }
    film.poster = 25;
    walk.show(std::move(film));
    walk.say("So a hard step is longer and dearer, and who wins depends on the stiffness that the soft side has to "
             "resolve. Stiffer contacts shorten the soft step by the root of κ and leave the hard one as it is.");
    walk.fact("soft_steps", static_cast<double>(soft->steps));
    walk.fact("hard_steps", static_cast<double>(whole->steps));
    walk.fact("soft_height", soft->height, "m");
    walk.fact("hard_height", whole->height, "m");
    return std::nullopt;
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    Walk walk;
    walk.say("Games move bodies with hard contacts, engineers mostly with soft ones. The same scene runs under both "
             "here: `solver = \"soft\"` is Cundall and Strack's, `solver = \"box2d\"` hands discs and walls to the "
             "game engine Box2D. What is won, what is lost?");
    for (const auto add : {one_impact, several_at_once, in_a_row, at_rest, sliding, cost})
        if (const auto problem = add(walk, s))
            return *problem;
    const double impulse = walk.fact("hard_impulse_predicted");
    walk.question =
        "A sensor inside a particle records the largest acceleration of an impact. Which of the two can predict "
        "its reading, and what would the other one say?";
    walk.answer = fmt::format(
        "Only the soft one, if its stiffness is the material's. The hard one has J = {:.4g} N s and divides it by the "
        "step: "
        "{:.4g} m/s2 at 1 ms, {:.4g} at 0.1 ms, without end. What both can predict are the speeds after an impact of "
        "two bodies, and "
        "how far things slide.",
        impulse, impulse / mass / hard_step, impulse / mass / (0.1 * hard_step));
    return walk;
}

} // namespace

Lesson soft_and_hard() {
    return {
        .name = "soft-and-hard",
        .title = "Soft and hard contacts: what a spring knows and an impulse does not",
        .parameters = {{"restitution", "", 0.667, {.lo = 0.05, .hi = 1}, "Restitution of one contact, e"},
                       {"friction", "", 0.4, {.lo = 0.05, .hi = 1}, "Coulomb's coefficient μ"},
                       {"normal_stiffness_N_per_m", "N/m", 1e5, {.lo = 2e4, .hi = 1e6}, "Spring κ of the soft contact"},
                       {"speed_m_s", "m/s", 1, {.lo = 0.1, .hi = 2}, "Speed of the impacts"}},
        .teach = teach};
}

} // namespace tumble::lesson
