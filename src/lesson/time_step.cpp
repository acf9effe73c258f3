#include "sim2d/time_step.h"

#include "lesson/each.h"
#include "lesson/impact.h"
#include "lesson/stage.h"
#include "sim3d/time_step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double radius = 0.1;   // m
constexpr double squeeze = 1e-3; // m, overlap with either wall while the disc rests

/// A disc held between two walls: a mass on two springs and two dashpots that never lose touch.
struct Setup {
    double k = 0, mass = 0, restitution = 0;
    double omega = 0; // rad/s, of both springs
    double zeta = 0;  // of both springs and both dashpots

    explicit Setup(const Values& values)
        : k(values["normal_stiffness_N_per_m"]), mass(values["mass_kg"]), restitution(values["restitution"]),
          omega(std::sqrt(2 * k / mass)), zeta(std::numbers::sqrt2 * damping_ratio(restitution)) {}

    [[nodiscard]] double critical_step() const { return 2 / omega * (std::sqrt(1 + zeta * zeta) - zeta); }
    [[nodiscard]] scene::Scene scene(double dt) const {
        scene::Scene scene = plane_stage(linear_pair(k, 1, restitution, 0), dt);
        add_round(scene, radius, mass);
        for (const double side : {-1.0, 1.0}) {
            const double x = side * (radius - squeeze);
            add_wall(scene, scene::Outline(scene::SegmentShape{{x, -1}, {x, 1}}));
        }
        return scene;
    }
};

/// Where the disc was after every step, m from the middle; and why the solver stopped, if it did.
struct Course {
    std::vector<double> x;
    std::string stopped;
};

Result<Course> run(const Setup& setup, double dt, double start_at, int steps, double speed = 0) {
    sim2d::BodyState disc;
    disc.position = {start_at, 0};
    disc.velocity = {speed, 0};
    Result<sim2d::WorldPtr> world = start(setup.scene(dt), {disc});
    if (!world)
        return world.problems();
    Course course{{start_at}, ""};
    for (int k = 0; k < steps && course.stopped.empty(); ++k) {
        if (const auto problem = sim2d::advance(**world, 1))
            course.stopped = problem->what;
        else
            course.x.push_back(sim2d::bodies_of(**world)[0].position.x());
    }
    return course;
}

/// x_k+1 = p x_k - q x_k-1, which a mass on springs stepped by leapfrog obeys exactly.
struct Recurrence {
    double p = 0, q = 0;

    static Recurrence of(const Setup& s, double dt) {
        const double w = s.omega * dt, c = 2 * s.zeta * w;
        return {2 - w * w - c, 1 - c};
    }
    /// The best fit to a course, as far as it is in touch with both walls.
    static Recurrence fit(const std::vector<double>& x) {
        Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
        Eigen::Vector2d b = Eigen::Vector2d::Zero();
        for (std::size_t k = 2; k + 1 < x.size() && std::abs(x[k + 1]) < 0.5 * squeeze; ++k) {
            const Eigen::Vector2d row(x[k], -x[k - 1]);
            a += row * row.transpose();
            b += row * x[k + 1];
        }
        const Eigen::Vector2d best = a.fullPivLu().solve(b);
        return {best[0], best[1]};
    }
    /// By what the swing grows in a step, at most.
    [[nodiscard]] double growth() const {
        const std::complex<double> root = std::sqrt(std::complex<double>(p * p / 4 - q));
        return std::max(std::abs(p / 2 + root), std::abs(p / 2 - root));
    }
    /// Steps in a swing; 0 where it does not swing.
    [[nodiscard]] double period() const {
        return p * p < 4 * q ? 2 * std::numbers::pi / std::acos(p / (2 * std::sqrt(q))) : 0;
    }
};

/// Whether a tiny push has grown ten thousandfold within four thousand steps.
Result<bool> explodes(const Setup& setup, double dt) {
    const double push = 1e-6 * squeeze;
    const Result<Course> course = run(setup, dt, push, 4000);
    if (!course)
        return course.problems();
    return !course->stopped.empty() ||
           std::any_of(course->x.begin(), course->x.end(), [&](double x) { return std::abs(x) > 1e4 * push; });
}

/// The longest step that does not explode, by halving the interval.
Result<double> limit_seen(const Setup& setup) {
    double stable = 0.6 * setup.critical_step(), wild = 1.5 * setup.critical_step();
    for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (stable + wild);
        const Result<bool> answer = explodes(setup, middle);
        if (!answer)
            return answer.problems();
        (*answer ? wild : stable) = middle;
    }
    return stable;
}

/// Without dashpots both roots meet in -1 at the limit: bounded from rest, growing by the same length a step else.
std::optional<Problem> at_the_limit(Walk& walk, const Setup& s) {
    constexpr int steps = 20;
    const double dt = s.critical_step(), way = 1e-5 * squeeze; // m, that it flies in a step at first
    const Result<Course> course = run(s, dt, 0, steps, way / dt);
    if (!course)
        return course.problems().front();
    const double far = course->x.size() > steps ? std::abs(course->x[steps]) / way : 0;
    walk.say(fmt::format(
        "Without a dashpot the two roots meet there: λ = −1 twice, and x(k) = (a + b k) (−1)^k. A disc that "
        "is pushed aside and let go jumps between the same two places (b = 0). One that gets a speed at "
        "the middle comes further by the same way in every step: in the solver {:.5g} times the first "
        "after {} steps. So the limit itself is not stable.",
        far, steps));
    walk.fact("ways_at_the_limit", far);
    return std::nullopt;
}

std::optional<Problem> around_the_limit(Walk& walk, const Setup& s) {
    Grid grid{{{"step / limit"},
               {"ω Δt"},
               {"growth a step, predicted", "", 6},
               {"seen", "", 6},
               {"period / true, predicted", "", 5},
               {"seen", "", 5}},
              {}};
    Figure growth{.name = "growth",
                  .title = "Growth of a swing in one step",
                  .x = {"time step / limit", ""},
                  .y = {"growth per step", ""},
                  .curves = {{"predicted", Style::line, {}, {}}, {"solver", Style::points, {}, {}}}};
    const double limit = s.critical_step();
    const double swing = 2 * std::numbers::pi / (s.omega * std::sqrt(1 - std::min(0.999, s.zeta * s.zeta))); // s
    for (const double factor : {0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 1.01, 1.05, 1.1, 1.2}) {
        const double dt = factor * limit;
        const Result<Course> course = run(s, dt, 1e-5 * squeeze, 12);
        if (!course)
            return course.problems().front();
        const Recurrence predicted = Recurrence::of(s, dt), seen = Recurrence::fit(course->x);
        const auto ratio = [&](const Recurrence& r) -> Cell {
            return r.period() > 0 ? Cell(r.period() * dt / swing) : Cell("-");
        };
        grid.rows.push_back({factor, s.omega * dt, predicted.growth(), seen.growth(), ratio(predicted), ratio(seen)});
        growth.curves[1].add(factor, seen.growth());
        walk.fact(fmt::format("growth_at_{}", factor), seen.growth());
    }
    for (int k = 20; k <= 240; ++k)
        growth.curves[0].add(k / 200.0, Recurrence::of(s, k / 200.0 * limit).growth());
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(growth);
    return std::nullopt;
}

/// Draws three courses; gives back the last, which is beyond the limit.
Result<Course> swings(Walk& walk, const Setup& s) {
    Figure figure{.name = "swings",
                  .title = "The same push, three time steps",
                  .x = {"step number", ""},
                  .y = {"displacement / first displacement", "", false, std::array{-12.0, 12.0}},
                  .curves = {}};
    Course last;
    for (const double factor : {0.3, 1.0, 1.05}) {
        const Result<Course> course = run(s, factor * s.critical_step(), 1e-4 * squeeze, 400);
        if (!course)
            return course.problems();
        last = *course;
        Curve curve{fmt::format("{} of the limit", factor), Style::line, {}, {}};
        for (std::size_t k = 0; k < std::min<std::size_t>(course->x.size(), 25); ++k)
            curve.add(static_cast<double>(k), course->x[k] / course->x[0]);
        figure.curves.push_back(std::move(curve));
    }
    walk.parts.emplace_back(figure);
    return last;
}

/// A heap of discs whose weight presses the lowest together by a thousandth of a radius, in steps of `dt`.
scene::Scene heap(const Setup& s, double dt) {
    constexpr int rows = 6, columns = 8;
    const double width = columns * radius, row = std::sqrt(3.0) * radius * (1 + 1e-6);
    scene::Scene scene = plane_stage(linear_pair(s.k, 1, s.restitution, 0.3), dt);
    scene.gravity = {0, -1e-3 * radius * s.k / s.mass / rows, 0};
    const int disc = add_round(scene, radius, s.mass);
    add_wall(scene, scene::Outline(scene::PolylineShape{{{-width - 0.51 * radius, 2 * width},
                                                         {-width - 0.51 * radius, 0},
                                                         {width + 0.51 * radius, 0},
                                                         {width + 0.51 * radius, 2 * width}},
                                                        false}));
    for (int k = 0; k < rows * columns; ++k) {
        const double shift = (k / columns) % 2 == 0 ? -0.5 : 0.5;
        put(scene, disc,
            {(2 * (k % columns) - columns + 1 + shift) * radius * (1 + 1e-6), radius * (1 + 1e-6) + k / columns * row},
            {0, 0});
    }
    return scene;
}

/// The longest step that `tumble check` lets a flat scene have, s.
Result<double> checked_limit(const scene::Scene& scene) {
    const Result<sim2d::WorldPtr> world = start(scene, std::vector<sim2d::BodyState>{});
    if (!world)
        return world.problems();
    return sim2d::time_step_report(scene, sim2d::shapes_of(**world)).limit;
}

/// A heap has its own limit, which is far below the caged disc's: each disc has more contacts, turns, and touches what
/// is as free as itself.
std::optional<Problem> film_of_heap(Walk& walk, const Setup& s) {
    constexpr int pictures = 75;
    constexpr double width = 8 * radius, short_enough = 0.7, too_long = 2.8;
    const double cage = s.critical_step(), until = 100 * cage;
    const Result<double> own = checked_limit(heap(s, cage));
    if (!own)
        return own.problems().front();
    walk.say(
        fmt::format("Here is a heap of such discs, with friction, in steps of {} and {} times its own limit. That is "
                    "{:.4g} s, as `tumble check` reckons (below), {:.0f} % of what the caged disc bears: the "
                    "second heap takes steps of {:.2g} of the cage's limit.",
                    short_enough, too_long, *own, 100 * *own / cage, too_long * *own / cage));
    Film shown{.name = "exploding-heap",
               .title = "A heap in steps that are short enough, and too long",
               .reels = {},
               .every = one_digit(until / pictures),
               .range = {0, 0.5 * radius * s.omega},
               .view = scene::Box{{-width, -0.5 * radius, -0.5}, {width, 2 * width, 0.5}},
               .poster = std::size_t{30}};
    for (const double share : {short_enough, too_long}) {
        Result<Reel> reel =
            film(heap(s, share * *own), fmt::format("step {} of the heap's limit", share), until, shown.every);
        if (!reel)
            return reel.problems().front();
        shown.reels.push_back(std::move(*reel));
    }
    walk.show(std::move(shown));
    walk.fact("heap_limit", *own, "s");
    return std::nullopt;
}

/// How the course beyond the limit went on.
std::string ending(const Course& course) {
    if (!course.stopped.empty())
        return fmt::format("It goes on until the solver notices. The third run ended so: \"{}\".", course.stopped);
    double widest = 0;
    for (const double x : course.x)
        widest = std::max(widest, std::abs(x));
    return fmt::format(
        "In this cage the explosion ends itself: once the swing is wider than the squeeze, one contact opens, and on "
        "one spring the same step is short enough again. The disc then rattles, up to {:.3g} times the squeeze from "
        "the middle, with energy from nowhere. In a heap there is always another contact, and grains fly.",
        widest / squeeze);
}

/// Least and most of an undamped impact's peak force and restitution, over where in a step the surfaces meet.
std::optional<Problem> accuracy(Walk& walk, const Setup& s) {
    Grid grid{{{"steps a contact"},
               {"step / (2/ω₁)"},
               {"restitution (1), least", "", 6},
               {"most", "", 6},
               {"peak force / true, least", "", 6},
               {"most", "", 6}},
              {}};
    const double omega = std::sqrt(s.k / s.mass);
    const double speed = 0.01 * struck_radius * omega; // sinks a hundredth of its radius, however soft the spring
    constexpr int places = 16;                         // in a step
    for (const int steps : {4, 10, 20, 50, 100}) {
        const double dt = std::numbers::pi / omega / steps;
        std::vector<double> restitutions, forces;
        for (int k = 0; k < places; ++k) {
            const Result<Impact> impact =
                strike_disc(linear_pair(s.k, 1, 1, 0), s.mass, speed, dt, false, speed * dt * k / places);
            if (!impact)
                return impact.problems().front();
            restitutions.push_back(impact->restitution);
            forces.push_back(impact->force_max / (speed * omega * s.mass));
        }
        const auto [dull, lively] = std::minmax_element(restitutions.begin(), restitutions.end());
        const auto [weak, strong] = std::minmax_element(forces.begin(), forces.end());
        grid.rows.push_back({static_cast<double>(steps), dt * omega / 2, *dull, *lively, *weak, *strong});
        walk.fact(fmt::format("force_error_of_{}_steps", steps), std::max(1 - *weak, *strong - 1));
        walk.fact(fmt::format("least_restitution_of_{}_steps", steps), *dull);
        walk.fact(fmt::format("most_restitution_of_{}_steps", steps), *lively);
    }
    walk.parts.emplace_back(grid);
    return std::nullopt;
}

/// Plastic beads of Hertz' law that come at `speed` (m/s) with that many times the mass of a solid one.
Result<scene::TimeStepReport> report_of_beads(double speed, double heavier) {
    const contact::Material plastic{"plastic", 1665.71, 4.6e8, 0.2887}; // the thesis' media, section 4.3, B.6
    constexpr double bead = 2e-3;                                       // m
    contact::PairProperties pair;
    pair.restitution = 0.67;
    pair.friction = 0.58;
    scene::Scene scene = space_stage(plastic, pair, 1e-6);
    const int body = add_round(scene, bead, heavier * plastic.density * 4 / 3 * std::numbers::pi * bead * bead * bead);
    for (const double x : {-1.0, 1.0})
        scene::place(scene, body, {x, 0, 0}, {speed, 0, 0});
    const Result<sim3d::WorldPtr> world = start(scene, std::vector<sim3d::BodyState>{});
    if (!world)
        return world.problems();
    return sim3d::time_step_report(scene, sim3d::shapes_of(**world));
}

/// The rule of thumb that other codes print, beside the limit.
std::optional<Problem> rayleigh(Walk& walk) {
    walk.head("The Rayleigh time");
    walk.say("Codes for spheres often print another time: how long a wave takes over the surface of the smallest one. "
             "A step "
             "of 10 to 30 % of it is the usual rule.");
    walk.formula("T_R = π R √(ρ / G) / (0.1631 ν + 0.8766)", "Li, Xu and Thornton 2005; docs/bodies.md");
    walk.say(
        "It needs an elastic modulus, so the linear law's discs have none. And it asks for a wave in one sphere, where "
        "leapfrog asks for a body on its springs: it knows neither the body's mass nor how hard it is struck, though "
        "Hertz' contact is the stiffer the deeper. Beads of 2 mm radius of the thesis' plastic (E = 0.46 GPa as it "
        "simulates it, ν = 0.2887, 1665.71 kg/m3), and the same beads weighted to ten times their mass:");
    Grid grid{{{"impact", "m/s"},
               {"T_R", "us"},
               {"limit", "us"},
               {"limit / T_R", "", 3},
               {"ten times the mass", "us"},
               {"limit / T_R", "", 3}},
              {}};
    for (const double speed : {0.1, 1.0, 10.0}) {
        const Result<scene::TimeStepReport> bead = report_of_beads(speed, 1), heavy = report_of_beads(speed, 10);
        if (!bead || !heavy)
            return (bead ? heavy : bead).problems().front();
        grid.rows.push_back({speed, 1e6 * bead->rayleigh, 1e6 * bead->limit, bead->limit / bead->rayleigh,
                             1e6 * heavy->limit, heavy->limit / heavy->rayleigh});
        walk.fact(fmt::format("bead_limit_at_{:g}", speed), bead->limit, "s");
        walk.fact(fmt::format("heavy_bead_limit_at_{:g}", speed), heavy->limit, "s");
        if (speed == 1)
            walk.fact("rayleigh_time", bead->rayleigh, "s");
    }
    walk.parts.emplace_back(grid);
    walk.say("The limit bounds the step; a fraction of the Rayleigh time is a habit (docs/bodies.md). `tumble check` "
             "prints both, and refuses by the limit.");
    return std::nullopt;
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    const double limit = s.critical_step();
    Walk walk;
    walk.say("A disc is squeezed between two walls, a little, so that it never loses touch with either. Pushed aside "
             "by much less than the squeeze it is the simplest oscillator there is: one mass on two springs. What may "
             "its time step be?");
    walk.formula(fmt::format("ω = √(2 κ / m) = {:.5g} rad/s,   one swing takes {:.4g} s", s.omega,
                             2 * std::numbers::pi / s.omega));
    walk.say("The solver takes the force of the moment, and carries the disc along with it for a whole step (3.13, "
             "3.14). Put together, three places in a row are bound to each other:");
    walk.formula("x(k+1) = p x(k) − q x(k−1),   p = 2 − (ω Δt)² − 2 ζ ω Δt,   q = 1 − 2 ζ ω Δt");
    walk.say(
        "ζ is the damping ratio of both dashpots together, 0 for a restitution of 1. Swings of such a rule stay "
        "bounded as long as no root of λ² = p λ − q is larger than 1, and none of size 1 is a double one. The first "
        "root to leave does so at λ = −1: the disc jumps from one side to the other in every step, a little further "
        "each time.");
    walk.formula(fmt::format("Δt_max = 2/ω (√(1 + ζ²) − ζ) = {:.6g} s   (ζ = {:.4g})", limit, s.zeta),
                 "docs/bodies.md");
    const Result<double> seen = limit_seen(s);
    if (!seen)
        return seen.problems();
    walk.say(fmt::format(
        "Tried out on the solver, by halving the interval between a step that stays calm and one that "
        "explodes: {:.6g} s, the prediction to better than {}.{}",
        *seen, at_most(std::abs(*seen / limit - 1)),
        s.zeta > 0 ? " With dashpots a swing just beyond the limit grows by very little in a step, which so many "
                     "steps as are tried do not show; without them the growth sets in at once."
                   : ""));
    walk.fact("limit_predicted", limit, "s");
    walk.fact("limit_seen", *seen, "s");
    if (s.zeta == 0)
        if (const auto problem = at_the_limit(walk, s))
            return *problem;

    walk.head("Below, at, beyond");
    const Result<Course> wild = swings(walk, s);
    if (!wild)
        return wild.problems();
    walk.say(
        "Below the limit the disc swings as it should. Near the limit it jumps to and fro. Beyond, every jump is "
        "larger "
        "than the last. Nothing in nature does that: in one step the spring's force, right where the step began, acts "
        "on over the middle and far to the other side, where a true spring would long have turned round. The step ends "
        "further out than it began, so the next force is larger. Energy is not conserved, it is made.");
    walk.say(fmt::format(
        "The table fits the rule above to the places that the solver went through, and holds the roots beside the "
        "predicted ones. {} A period shorter than the true one is the first sign of too long a step.{}",
        s.zeta > 0 ? "Below 1 a swing dies, as dashpots will have it; above it grows."
                   : "Growth 1 is a swing that neither grows nor dies.",
        s.zeta > 0 ? " Near the limit both roots are real: there the disc no longer swings, and no period stands."
                   : ""));
    if (const auto problem = around_the_limit(walk, s))
        return *problem;
    walk.say(ending(*wild));
    if (const auto problem = film_of_heap(walk, s))
        return *problem;

    walk.head("Stable is not yet accurate");
    walk.say("Now an impact: the same disc strikes one wall, without a dashpot. It should come back as fast as it "
             "came. There is "
             "one spring instead of two, and in what follows ω₁ = √(κ / m).");
    if (const auto problem = accuracy(walk, s))
        return *problem;
    walk.say(fmt::format(
        "With 20 steps in a contact the peak force is off by up to {:.2g} %, with 50 by {:.2g} %. A contact "
        "lasts π/ω₁, so each of 50 steps is π/100 of the limit 2/ω₁: the usual few percent of it. What an "
        "impact of few steps gives back depends on where between two of them the surfaces meet: with four, "
        "from {:.3g} to {:.3g} times the speed. The force of the step in which they meet acts for all of it "
        "or not at all, and so does that of the step in which they part; in a bed this is noise, some of it "
        "energy from nowhere.",
        100 * walk.fact("force_error_of_20_steps"), 100 * walk.fact("force_error_of_50_steps"),
        walk.fact("least_restitution_of_4_steps"), walk.fact("most_restitution_of_4_steps")));
    const Result<double> checked = checked_limit(s.scene(limit));
    if (!checked)
        return checked.problems();
    walk.say(
        fmt::format("A disc in a heap has more than two contacts, and what it touches is as free to move as it is. "
                    "`tumble check` reckons with four springs at once in place of two, between two discs in place "
                    "of a disc and a wall. Without dashpots each shortens the step by √2. It refuses a step above "
                    "{:.4g} s in this scene, {:.0f} % of the limit here. With friction discs also turn, which "
                    "without dashpots is another √3: the heap's limit above.",
                    *checked, 100 * *checked / limit));
    walk.fact("check_limit", *checked, "s");
    if (const auto problem = rayleigh(walk))
        return *problem;
    const double ratio = 1 / std::sqrt(2.0);
    walk.question = "The springs become twice as stiff, the disc as heavy as before. By what factor must the step "
                    "shrink, and what does a ten times softer material save?";
    walk.answer =
        fmt::format("By 1/√2 = {:.4g}: ω grows with the root of the stiffness. Ten times softer allows a step √10 = "
                    "{:.4g} times longer, and that many fewer steps. That is why simulations use grains softer than "
                    "real ones; the price is overlaps that are too deep and contacts that last too long.",
                    ratio, std::sqrt(10.0));
    return walk;
}

} // namespace

Lesson time_step() {
    return {
        .name = "time-step",
        .title = "How long a step may be: stable, at the limit, beyond",
        .parameters =
            {{"restitution", "", 1, {.lo = 0.3, .hi = 1}, "Restitution of one contact; below 1 its dashpot is in play"},
             {"normal_stiffness_N_per_m", "N/m", 1e5, {.lo = 1, .hi = 1e9}, "Spring of each contact, κ"},
             {"mass_kg", "kg", 1, {.lo = 1e-6, .hi = 1e3}, "Mass of the disc, m"}},
        .teach = teach};
}

} // namespace tumble::lesson
