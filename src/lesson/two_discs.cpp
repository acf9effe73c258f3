#include "lesson/each.h"
#include "lesson/stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lesson {

namespace {

constexpr int cycles = 40;

struct Setup {
    double k = 0, v = 0, dt = 0, m_x = 0, m_y = 0; // N/m, m/s, s, kg

    explicit Setup(const Values& values)
        : k(values["normal_stiffness_N_per_m"]), v(values["wall_speed_m_s"]), dt(values["time_step_s"]),
          m_x(values["mass_x_kg"]), m_y(values["mass_y_kg"]) {}

    /// 2 / omega of the faster of the two modes: x'' = (A - B) / m_x, y'' = (B - C) / m_y with one spring each.
    [[nodiscard]] double critical_step() const {
        const double a = k / m_x, b = k / m_y;
        return 2 / std::sqrt(a + b + std::sqrt((a + b) * (a + b) - 3 * a * b));
    }
};

/// Displacements at t_0, t_1, ..., m to the right.
struct Path {
    std::vector<double> left, x, y, right;

    [[nodiscard]] double n_a(std::size_t k) const { return left[k] - x[k]; }
    [[nodiscard]] double n_b(std::size_t k) const { return x[k] - y[k]; }
    [[nodiscard]] double n_c(std::size_t k) const { return y[k] - right[k]; }
    void add(double wall, double disc_x, double disc_y) {
        left.push_back(wall);
        x.push_back(disc_x);
        y.push_back(disc_y);
        right.push_back(-wall);
    }
};

Result<Path> solve(const Setup& setup, int steps) {
    const double radius = 1; // m; only overlaps count
    scene::Scene scene = plane_stage(linear_pair(setup.k, 1, 1, 0), setup.dt);
    const int x = add_round(scene, radius, setup.m_x), y = add_round(scene, radius, setup.m_y);
    const auto wall = [&](double at, double speed) {
        add_wall(scene, scene::Outline(scene::SegmentShape{{at, -2}, {at, 2}})).motion.linears = {{{}, {speed, 0, 0}}};
    };
    wall(-2 * radius, setup.v);
    wall(2 * radius, -setup.v);
    sim2d::BodyState disc_x, disc_y;
    disc_x.shape = x;
    disc_x.position = {-radius, 0};
    disc_y.shape = y;
    disc_y.position = {radius, 0};
    Result<sim2d::WorldPtr> world = start(scene, {disc_x, disc_y});
    if (!world)
        return world.problems();
    Path path;
    path.add(0, 0, 0);
    for (int k = 0; k < steps; ++k) {
        if (const auto problem = sim2d::advance(**world, 1))
            return *problem;
        const auto bodies = sim2d::bodies_of(**world);
        path.add(sim2d::walls_of(**world)[0].translation.x(), bodies[0].position.x() + radius,
                 bodies[1].position.x() - radius);
    }
    return path;
}

/// The thesis' cycle written out: force from displacement, motion from force.
Path by_hand(const Setup& setup, double dt, int steps) {
    const auto spring = [&](double overlap) { return setup.k * std::max(overlap, 0.0); };
    Path path;
    double x = 0, y = 0, x_rate = 0, y_rate = 0;
    for (int k = 0; k <= steps; ++k) {
        const double wall = setup.v * k * dt;
        path.add(wall, x, y);
        const double a = spring(wall - x), b = spring(x - y), c = spring(y + wall);
        x_rate += (a - b) / setup.m_x * dt;
        y_rate += (b - c) / setup.m_y * dt;
        x += x_rate * dt;
        y += y_rate * dt;
    }
    return path;
}

double worst_difference(const Path& a, const Path& b) {
    double worst = 0, size = 0;
    for (std::size_t k = 0; k < a.x.size(); ++k) {
        worst = std::max({worst, std::abs(a.x[k] - b.x[k]), std::abs(a.y[k] - b.y[k])});
        size = std::max(size, std::abs(a.left[k]));
    }
    return worst / size;
}

void first_steps(Walk& walk, const Setup& s, const Path& seen) {
    const double dt = s.dt;
    const double n_1 = s.v * dt, f_x = s.k * n_1, f_y = -s.k * n_1;
    const double x_1 = f_x / s.m_x * dt, y_1 = f_y / s.m_y * dt;
    const double n_a = (s.v - x_1) * dt, n_b = (x_1 - y_1) * dt, n_c = (y_1 + s.v) * dt;
    const auto rate = [&](const std::vector<double>& path, std::size_t k) { return (path[k + 1] - path[k]) / dt; };
    const double x_seen = rate(seen.x, 1), y_seen = rate(seen.y, 1);
    const std::vector<Column> columns{{"", ""}, {"equation"}, {"by hand", "", 10}, {"solver", "", 10}, {"unit"}};

    walk.head("t1: the walls have moved, the discs do not know yet");
    walk.say("A disturbance crosses at most one disc in a step. So each wall digs an overlap Δn into its disc while "
             "both discs stay where they are:");
    walk.formula(fmt::format("Δn = v Δt = {:.4g} m/s × {:.4g} s = {:.4g} m", s.v, dt, n_1), "(3.10)");
    walk.say("The overlap is a spring's compression. Force, acceleration and, with the acceleration kept constant over "
             "the step, velocity follow, each from the one before:");
    walk.formula(fmt::format("F = κ Δn = {:.4g} N/m × {:.4g} m = {:.4g} N", s.k, n_1, f_x), "(3.11)");
    walk.parts.emplace_back(Grid{columns,
                                 {{"overlap at A", "(3.10)", n_1, seen.n_a(1), "m"},
                                  {"overlap at C", "(3.10)", n_1, seen.n_c(1), "m"},
                                  {"force on X at t1", "(3.12)", f_x, s.m_x * x_seen / dt, "N"},
                                  {"force on Y at t1", "(3.12)", f_y, s.m_y * y_seen / dt, "N"},
                                  {"acceleration of X at t1", "(3.13)", f_x / s.m_x, x_seen / dt, "m/s2"},
                                  {"acceleration of Y at t1", "(3.13)", f_y / s.m_y, y_seen / dt, "m/s2"},
                                  {"velocity of X, t1 to t2", "(3.14)", x_1, x_seen, "m/s"},
                                  {"velocity of Y, t1 to t2", "(3.14)", y_1, y_seen, "m/s"}}});
    walk.say("The solver's column is read off its positions: overlaps as differences of places, velocities as "
             "differences over a step, forces as mass times acceleration.");

    walk.head("t2: three contacts instead of two");
    walk.say("Now the discs have moved with these velocities, and what was a touch between them at B has become an "
             "overlap too. What each overlap grew by from t1 to t2, positive for compression:");
    walk.parts.emplace_back(Grid{columns,
                                 {{"growth at A", "(3.15)", n_a, seen.n_a(2) - seen.n_a(1), "m"},
                                  {"growth at B", "(3.16)", n_b, seen.n_b(2) - seen.n_b(1), "m"},
                                  {"growth at C", "(3.17)", n_c, seen.n_c(2) - seen.n_c(1), "m"}}});

    walk.head("t2 to t3: increments add up");
    walk.say("Forces are sums of all increments so far (3.27). At t2 each disc feels two contacts, one from either "
             "side, and what they say holds for the velocity until t3:");
    const double f_x2 = s.k * (n_1 + n_a - n_b), f_y2 = s.k * (n_b - n_1 - n_c);
    walk.parts.emplace_back(Grid{columns,
                                 {{"force on X at t2", "(3.27)", f_x2, s.m_x * (rate(seen.x, 2) - x_seen) / dt, "N"},
                                  {"force on Y at t2", "(3.27)", f_y2, s.m_y * (rate(seen.y, 2) - y_seen) / dt, "N"},
                                  {"velocity of X, t2 to t3", "", x_1 + f_x2 / s.m_x * dt, rate(seen.x, 2), "m/s"},
                                  {"velocity of Y, t2 to t3", "", y_1 + f_y2 / s.m_y * dt, rate(seen.y, 2), "m/s"}}});
    walk.fact("overlap_a_t1", seen.n_a(1), "m");
    walk.fact("velocity_x_t1", x_seen, "m/s");
    walk.fact("growth_a_t2", seen.n_a(2) - seen.n_a(1), "m");
    walk.fact("growth_b_t2", seen.n_b(2) - seen.n_b(1), "m");
    walk.fact("growth_c_t2", seen.n_c(2) - seen.n_c(1), "m");
    walk.fact("force_x_t2", s.m_x * (rate(seen.x, 2) - x_seen) / dt, "N");
}

/// Forces of the three contacts, and by how much they differ from those of a step `finer` times shorter.
std::array<Figure, 2> force_figures(const Setup& s, const Path& seen, const Path& fine, std::size_t finer) {
    const Axis time{"time", "s"};
    Figure forces{.name = "forces", .title = "Forces of the three contacts", .x = time, .y = {"force", "N"}};
    Figure error{.name = "error",
                 .title = fmt::format("The forces in this step, less those in one {} times shorter", finer),
                 .x = time,
                 .y = {"force, less that of the short step", "N"}};
    using Overlap = double (Path::*)(std::size_t) const;
    const std::vector<std::pair<const char*, Overlap>> contacts{
        {"A", &Path::n_a}, {"B", &Path::n_b}, {"C", &Path::n_c}};
    for (const auto& [name, overlap] : contacts) {
        const auto force = [&, overlap = overlap](const Path& path, std::size_t k) {
            return s.k * std::max((path.*overlap)(k), 0.0);
        };
        Curve curve{name}, difference{name};
        for (std::size_t k = 0; k < seen.x.size(); ++k) {
            curve.add(static_cast<double>(k) * s.dt, force(seen, k));
            difference.add(static_cast<double>(k) * s.dt, force(seen, k) - force(fine, k * finer));
        }
        forces.curves.push_back(std::move(curve));
        error.curves.push_back(std::move(difference));
    }
    return {forces, error};
}

double largest(const Figure& figure) {
    double size = 0;
    for (const Curve& curve : figure.curves)
        for (const double y : curve.y)
            size = std::max(size, std::abs(y));
    return size;
}

Figure path_figure(const Setup& s, const Path& seen) {
    Figure figure{.name = "displacements",
                  .title = "Displacements of walls and discs",
                  .x = {"time", "s"},
                  .y = {"displacement to the right", "mm"},
                  .curves = {{"left wall", Style::dashes, {}, {}},
                             {"disc X", Style::points, {}, {}},
                             {"disc Y", Style::points, {}, {}},
                             {"right wall", Style::dashes, {}, {}}}};
    for (std::size_t k = 0; k < seen.x.size(); ++k) {
        const double t = static_cast<double>(k) * s.dt;
        figure.curves[0].add(t, 1e3 * seen.left[k]);
        figure.curves[1].add(t, 1e3 * seen.x[k]);
        figure.curves[2].add(t, 1e3 * seen.y[k]);
        figure.curves[3].add(t, 1e3 * seen.right[k]);
    }
    return figure;
}

Result<Walk> teach(const Values& values) {
    const Setup setup(values);
    const double critical = setup.critical_step();
    if (setup.dt > critical)
        return Problem{.key = "--time_step_s",
                       .what = fmt::format("a step of {:.4g} s is longer than 2/ω = {:.4g} s of these masses and this "
                                           "spring: the discs would fly apart",
                                           setup.dt, critical),
                       .fix = "a shorter step, a softer spring or larger masses; `tumble lesson time-step` shows why"};
    // The solver's column consists of differences of places about 1 m away, which are known to 2e-16 m.
    constexpr double shortest_way = 1e-9; // m
    const double way = setup.k * setup.v * std::pow(setup.dt, 3) / std::max(setup.m_x, setup.m_y);
    if (way < shortest_way)
        return Problem{
            .key = "--time_step_s",
            .what = fmt::format("in the first step a disc would go {:.2g} m, too little to be told from places in "
                                "double precision",
                                way),
            .fix = fmt::format("a step of at least {:.2g} s, faster walls, a stiffer spring or less mass",
                               setup.dt * std::cbrt(shortest_way / way))};
    const Result<Path> seen = solve(setup, cycles);
    if (!seen)
        return seen.problems();
    Setup half = setup;
    half.dt = setup.dt / 2;
    const Result<Path> halved = solve(half, 4);
    if (!halved)
        return halved.problems();

    Walk walk;
    walk.say("Two discs, X on the left and Y on the right, touch each other and a wall on either side: wall A X B Y C "
             "wall, with A, B and C the contacts. At t0 there is no overlap and no force. Then both walls move inwards "
             "with speed v. This is the example with which Cundall and Strack (1979) explain the method; the thesis "
             "has it as (3.10) to (3.17). \"Weightless\" there means without gravity: the discs have masses. Their "
             "radius, 1 m "
             "here, does not enter.");
    first_steps(walk, setup, *seen);

    walk.head("And so on");
    constexpr std::size_t finer = 100;
    const Path hand = by_hand(setup, setup.dt, cycles);
    const Path fine = by_hand(setup, setup.dt / static_cast<double>(finer), cycles * static_cast<int>(finer));
    walk.say(fmt::format("The cycle never changes: overlaps give forces, forces give accelerations, accelerations give "
                         "velocities and places, places give overlaps. Written out as a loop of eight lines and taken "
                         "{} times, it differs from the solver by less than {} of the walls' path, which is rounding.",
                         cycles, at_most(worst_difference(*seen, hand))));
    walk.parts.emplace_back(path_figure(setup, *seen));
    const auto [forces, error] = force_figures(setup, *seen, fine, finer);
    walk.parts.emplace_back(forces);
    walk.say(fmt::format(
        "The contact in the middle answers later than those at the walls, because the push has to travel. The step of "
        "{:.3g} s is {:.0f} % of the longest stable one (2/ω = {:.4g} s). Taken again with a step {} times shorter the "
        "forces differ by up to {:.2g} N, {:.2g} % of the largest: the cycle follows the true course without being on "
        "it.",
        setup.dt, 100 * setup.dt / critical, critical, finer, largest(error), 100 * largest(error) / largest(forces)));
    walk.parts.emplace_back(error);
    walk.fact("loop_difference", worst_difference(*seen, hand));
    walk.fact("critical_step", critical, "s");
    const double whole = seen->n_b(2), eighth = halved->n_b(2), same_moment = halved->n_b(4);
    walk.fact("halved_growth_b_t2", eighth, "m");
    walk.fact("halved_overlap_b_same_moment", same_moment, "m");
    walk.fact("fine_overlap_b_t2", fine.n_b(2 * finer), "m");
    walk.question = "Halve the time step and look at the overlap at B at t2 again. By what factor is it smaller, and "
                    "how much of that is an error of the method?";
    walk.answer = fmt::format(
        "By {:.4g}: {:.4g} m became {:.4g} m. (3.16) with (3.10) to (3.14) put in says κ v Δt³ (1/m_x + 1/m_y): the "
        "walls' path, the velocity it leads to and the discs' path each carry one Δt. That is no error, t2 = 2 Δt is "
        "simply an earlier moment. But the first two steps do miss something: a push that grows evenly, κ v t, moves a "
        "mass by κ v t³ / (6 m), which at 2 Δt gives 4/3 where (3.16) has 1. n steps reach 1 - 1/n² of it, whatever "
        "Δt is, so at one and the same moment the error falls with Δt²: at {:.3g} s two steps give {:.4g} m, four "
        "half steps {:.4g} m, and very short ones {:.4g} m (a little less than 4/3 of the first, for by then A, B and "
        "C "
        "push back, which the even push leaves out).",
        whole / eighth, whole, eighth, 2 * setup.dt, whole, same_moment, fine.n_b(2 * finer));
    return walk;
}

} // namespace

Lesson two_discs() {
    return {
        .name = "two-discs",
        .title = "Two discs between closing walls: the cycle of force and displacement",
        .parameters = {{"normal_stiffness_N_per_m", "N/m", 1000, {.lo = 1, .hi = 1e9}, "Spring of every contact, κ"},
                       {"wall_speed_m_s", "m/s", 0.1, {.lo = 0, .hi = 1, .above = true}, "Speed of each wall, v"},
                       {"time_step_s", "s", 0.01, {.lo = 1e-6, .hi = 0.02}, "Time step, Δt"},
                       {"mass_x_kg", "kg", 1, {.lo = 1e-3, .hi = 1e3}, "Mass of the left disc"},
                       {"mass_y_kg", "kg", 2, {.lo = 1e-3, .hi = 1e3}, "Mass of the right disc"}},
        .teach = teach};
}

} // namespace tumble::lesson
