#include "lesson/each.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double g = 9.81;       // m/s2
constexpr double density = 2500; // kg/m3
constexpr double modulus = 1e8;  // Pa
constexpr double dt = 2e-5;      // s
constexpr double degrees = 180 / std::numbers::pi;
constexpr double usual_radius = 0.02; // m

using contact::RollingLaw;

struct Resistance {
    RollingLaw law = RollingLaw::none;
    double friction = 0, damping = 0;
};

double mass_of(double radius) {
    return density * 4 / 3 * std::numbers::pi * radius * radius * radius;
}

/// How deep a ball at rest lies in a plane that it is pressed on with this force, m (Hertz).
double sunk(double force, double radius) {
    const double E_eff = modulus / (2 * (1 - 0.25 * 0.25));
    return std::pow(0.75 * force / (E_eff * std::sqrt(radius)), 2.0 / 3);
}

struct Ride {
    std::vector<double> time, place, speed; // s, m, m/s downhill
    std::vector<double> spin;               // rad/s about z, mean since the look before
    /// When and where it first stands still; the end, if it never does.
    [[nodiscard]] std::size_t stop() const {
        const auto still = std::find_if(speed.begin(), speed.end(), [](double v) { return v <= 0; });
        return still == speed.end() ? speed.size() - 1 : static_cast<std::size_t>(still - speed.begin());
    }
    /// Over the second half, m/s2.
    [[nodiscard]] double acceleration() const {
        const std::size_t middle = time.size() / 2;
        return (speed.back() - speed[middle]) / (time.back() - time[middle]);
    }
};

/// rad about z, small.
double turned(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
    const Eigen::Quaterniond way = to * from.conjugate();
    return 2 * std::atan2(way.z(), way.w());
}

/// A ball that rolls at `speed` on a plane inclined by `slope` (rad), x downhill: gravity is turned instead. Looked at
/// every `look` steps.
Result<Ride> ride(const Resistance& resistance, double radius, double slope, double speed, double duration, int look) {
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.friction = 0.8;
    pair.rolling_friction = resistance.friction;
    pair.rolling_damping = resistance.damping;
    scene::Scene scene = space_stage({"stone", density, modulus, 0.25}, pair, dt);
    scene.contact.additions.rolling = resistance.law;
    scene.gravity = {g * std::sin(slope), -g * std::cos(slope), 0};
    add_round(scene, radius);
    add_wall(scene, scene::WallShape(scene::PlaneShape{}));
    sim3d::BodyState ball;
    ball.position = {0, radius - sunk(mass_of(radius) * g * std::cos(slope), radius), 0};
    ball.velocity = {speed, 0, 0};
    ball.angular_velocity = {0, 0, -speed / radius};
    const Result<sim3d::WorldPtr> world = start(scene, {ball});
    if (!world)
        return world.problems();
    Ride seen;
    Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
    const auto looks = static_cast<int>(std::lround(duration / dt / look));
    for (int k = 0; k <= looks; ++k) {
        const sim3d::BodyState now = sim3d::bodies_of(**world)[0];
        seen.time.push_back(sim3d::time_of(**world));
        seen.place.push_back(now.position.x());
        seen.speed.push_back(now.velocity.x());
        // What the solver tells of a spin at a step is reckoned ahead from the last torque, which may jump.
        seen.spin.push_back(k == 0 ? now.angular_velocity.z() : turned(before, now.orientation) / (look * dt));
        before = now.orientation;
        if (const auto problem = k < looks ? sim3d::advance(**world, look) : std::nullopt)
            return *problem;
    }
    return seen;
}

/// EPSD's spring under the ball: the angle at which it gives way, rad, and how fast the ball swings on it, rad/s.
struct Spring {
    double yield, frequency;

    explicit Spring(double mu) {
        const double press = mass_of(usual_radius) * g, overlap = sunk(press, usual_radius);
        yield = overlap / (2.25 * mu * usual_radius);
        frequency = std::sqrt(2.25 * press / overlap * mu * mu / (1.4 * mass_of(usual_radius)));
    }
};

double stop_distance(double mu, double speed) {
    return 7 * speed * speed / (10 * mu * g);
}
double stop_time(double mu, double speed) {
    return 7 * speed / (5 * mu * g);
}

std::optional<Problem> never_stops(Walk& walk, double speed, double duration) {
    const Result<Ride> free = ride({}, usual_radius, 0, speed, duration, 500);
    if (!free)
        return free.problems().front();
    walk.head("A ball that never stops");
    const double overlap = sunk(mass_of(usual_radius) * g, usual_radius);
    walk.say(fmt::format(
        "A ball rolls over a level plane at {:.4g} m/s. Its lowest point stands still, so nothing slips; and as "
        "nothing "
        "speeds it up or slows it down, friction has nothing to hold either: the shear spring of the contact lies "
        "slack. "
        "Coulomb's law, however rough the floor, takes no energy from a ball that rolls. After {:.3g} s it still has "
        "{:.5g} m/s. (What is missing went in the first moments: the ball lies {:.2g} um deep in the plane, and rolls "
        "about "
        "the middle of the overlap, a little nearer than R: 2/7 δ / (2 R) = {:.2g} % of its speed.)",
        speed, free->time.back(), free->speed.back(), 1e6 * overlap, 100 * overlap / (7 * usual_radius)));
    walk.say(
        "A real ball stops. The floor gives way under it and comes back late, or it is a little rough: what bears "
        "the ball stands a little ahead of its middle, and so turns against the rolling. The ratio of that lead to "
        "the radius is the coefficient of rolling friction.");
    walk.formula("M = μ_r R* F_n,   R* = R on a plane", "Ai et al. 2011");
    walk.fact("free_speed", free->speed.back(), "m/s");
    return std::nullopt;
}

std::optional<Problem> stopping(Walk& walk, const Resistance& cdt, const Resistance& epsd, double speed) {
    const double mu = cdt.friction;
    const double duration = 1.5 * stop_time(mu, speed);
    walk.head("Two laws that stop it");
    walk.say("Constant directional torque (cdt) turns against the rolling with the whole of M, however slow it is. The "
             "elastic-plastic spring-dashpot (epsd) is a spring with a limit, as friction is: it is wound up by the "
             "rolling until it bears M, and from there on gives way.");
    walk.formula("7/5 m v' = −M / R   →   v' = −5/7 μ_r g,   stops after 7 v² / (10 μ_r g)");
    const Spring spring(mu);
    // While the spring is wound up the dashpot turns against the rolling too, with 2 eta I omega_r omega over its
    // yield.
    const double taken = 4 * epsd.damping * spring.yield * spring.frequency * usual_radius / speed;
    const double wound = stop_distance(mu, speed) * (1 - taken) + 0.5 * spring.yield * usual_radius;
    Grid grid{{{"law"}, {"stops after", "m"}, {"closed form", "m"}, {"in", "s"}, {"closed form", "s"}}, {}};
    Figure figure{.name = "stopping",
                  .title = "A ball that rolls on a plane",
                  .x = {"time", "s"},
                  .y = {"speed", "m/s"},
                  .curves = {{"no resistance", Style::dashes}, {"cdt"}, {"epsd"}}};
    double worst = 0; // of the distances
    for (const auto& [name, resistance, curve] :
         {std::tuple("none", Resistance{}, 0), std::tuple("cdt", cdt, 1), std::tuple("epsd", epsd, 2)}) {
        const Result<Ride> seen = ride(resistance, usual_radius, 0, speed, duration, 20);
        if (!seen)
            return seen.problems().front();
        for (std::size_t k = 0; k < seen->time.size(); k += std::max<std::size_t>(1, seen->time.size() / 300))
            figure.curves[static_cast<std::size_t>(curve)].add(seen->time[k], seen->speed[k]);
        if (resistance.law == RollingLaw::none)
            continue;
        const std::size_t stop = seen->stop();
        const bool winds = resistance.law == RollingLaw::epsd;
        grid.rows.push_back({name, seen->place[stop], winds ? wound : stop_distance(mu, speed), seen->time[stop],
                             stop_time(mu, speed) * (winds ? std::sqrt(std::max(0.0, 1 - taken)) : 1)});
        worst = std::max(worst, std::abs(seen->place[stop] / (winds ? wound : stop_distance(mu, speed)) - 1));
        walk.fact(fmt::format("stop_distance_{}", name), seen->place[stop], "m");
    }
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(figure);
    walk.formula("k_r = 9/4 k_n (μ_r R*)²   →   gives way at θ = δ / (9/4 μ_r R*)", "Ai et al. 2011");
    walk.say(
        fmt::format("Both stop it within {:.2g} % of where they should. The spring of epsd is wound up within {:.2g} "
                    "mm; meanwhile its "
                    "dashpot brakes as well, and no limit holds that: it takes 4 η_r θ ω_r R / v = {:.2g} % of the "
                    "energy before the torque is what it should be.",
                    100 * worst, 1e3 * spring.yield * usual_radius, 100 * taken));
    walk.fact("stop_distance_theory_epsd", wound, "m");
    walk.fact("stop_distance_theory", stop_distance(mu, speed), "m");
    return std::nullopt;
}

std::optional<Problem> at_rest(Walk& walk, const Resistance& cdt, const Resistance& epsd) {
    const double mu = cdt.friction;
    const double period = 2 * std::numbers::pi / Spring(mu).frequency;
    // So slow that the spring never gives way in what follows.
    const double speed = 0.2 * mu * g * 5 / 7 * period / (2 * std::numbers::pi);
    walk.head("At rest");
    walk.say("What does a law say that knows only a direction, when there is none? The constant torque turns the ball "
             "back past rest within a step, then turns round itself, and so in every step. The spring carries the ball "
             "back and forth, and its dashpot brings it to rest:");
    walk.formula(fmt::format("ω² = k_r / (7/5 m R²)   →   a period of {:.3g} s", period));
    Figure swing{.name = "swing",
                 .title = "A ball comes to rest",
                 .x = {"time", "s"},
                 .y = {"place", "mm"},
                 .curves = {{"cdt"}, {"epsd"}, {"epsd without dashpot", Style::dashes}}};
    Resistance undamped = epsd;
    undamped.damping = 0;
    for (std::size_t k = 0; const Resistance& resistance : {cdt, epsd, undamped}) {
        const Result<Ride> seen = ride(resistance, usual_radius, 0, speed, 3 * period, 20);
        if (!seen)
            return seen.problems().front();
        for (std::size_t i = 0; i < seen->time.size(); i += std::max<std::size_t>(1, seen->time.size() / 300))
            swing.curves[k].add(seen->time[i], 1e3 * seen->place[i]);
        ++k;
    }
    Figure shaking{.name = "spin-at-rest",
                   .title = "A ball that has come to rest",
                   .x = {"step"},
                   .y = {"spin, from the angle", "rad/s"},
                   .curves = {{"cdt", Style::points}, {"epsd", Style::points}}};
    double swing_of[2] = {0, 0}, creep[2] = {0, 0}; // rad/s, about the creep
    for (std::size_t k = 0; const Resistance& resistance : {cdt, epsd}) {
        const Result<Ride> seen = ride(resistance, usual_radius, 0, speed, 12 * period, 1);
        if (!seen)
            return seen.problems().front();
        const std::vector<double> last(seen->spin.end() - 40, seen->spin.end());
        for (std::size_t i = 0; i < last.size(); ++i)
            shaking.curves[k].add(static_cast<double>(i + 1), last[i]);
        const auto [least, most] = std::minmax_element(last.begin(), last.end());
        swing_of[k] = 0.5 * (*most - *least);
        creep[k] = 0.5 * (*most + *least);
        ++k;
    }
    walk.parts.emplace_back(swing);
    walk.parts.emplace_back(shaking);
    const double given = mu * g * dt / (0.4 * usual_radius);
    walk.say(fmt::format(
        "After twelve periods the constant torque still gives the ball M Δt / (2/5 m R²) = {:.2g} rad/s in one step "
        "and "
        "takes it back in the next: it spins with half of that to and fro, {:.2g} rad/s, about a mean of {:.1g} rad/s. "
        "That mean is a rolling which a torque of changing sense no longer brakes: the ball creeps by {:.1g} mm a "
        "second. With the spring the spin has faded to at most {} rad/s. The constant torque is enough for what rolls "
        "all "
        "the "
        "time; for heaps, which are to stand, it is not.",
        given, swing_of[0], std::abs(creep[0]), 1e3 * std::abs(creep[0]) * usual_radius,
        at_most(std::max(1e-10, std::abs(creep[1]) + swing_of[1]))));
    walk.fact("kicks_at_rest_cdt", swing_of[0] / given);
    walk.fact("creep_at_rest_cdt", creep[0], "rad/s");
    walk.fact("kicks_at_rest_epsd", (std::abs(creep[1]) + swing_of[1]) / given);
    walk.fact("period", period, "s");
    return std::nullopt;
}

std::optional<Problem> slopes(Walk& walk, const Resistance& cdt, const Resistance& epsd) {
    const double mu = cdt.friction;
    walk.head("On a slope");
    walk.say(
        "A coefficient of rolling friction is found by tilting, as that of sliding is: the ball sets out where the "
        "tangent of the slope passes μ_r.");
    walk.formula("stays while tan α ≤ μ_r;   else a = 5/7 g (sin α − μ_r cos α)");
    Grid grid{{{"slope", "deg"}, {"tan α / μ_r"}, {"cdt", "m/s2"}, {"epsd", "m/s2"}, {"closed form", "m/s2"}}, {}};
    double worst = 0;
    for (const double share : {0.5, 0.9, 1.1, 1.5, 2.0}) {
        const double slope = std::atan(share * mu);
        const double theory = std::max(0.0, 5.0 / 7 * g * (std::sin(slope) - mu * std::cos(slope)));
        std::vector<Cell> row{slope * degrees, share};
        for (const Resistance& resistance : {cdt, epsd}) {
            const Result<Ride> seen = ride(resistance, usual_radius, slope, 0, 1, 500);
            if (!seen)
                return seen.problems().front();
            const double a = seen->acceleration();
            row.emplace_back(std::abs(a) < 1e-3 * mu * g ? 0 : a);
            worst = std::max(worst, std::abs(a - theory) / (mu * g));
        }
        row.emplace_back(theory);
        grid.rows.push_back(row);
    }
    walk.parts.emplace_back(grid);
    walk.fact("worst_acceleration", worst);
    return std::nullopt;
}

Result<Walk> teach(const Values& values) {
    const double mu = values["rolling_friction"], speed = values["speed_m_s"];
    const Resistance cdt{RollingLaw::cdt, mu, 0}, epsd{RollingLaw::epsd, mu, values["rolling_damping"]};
    Walk walk;
    walk.say(
        "Friction stops what slides (`tumble lesson friction`). It does not stop what rolls, and so a heap of balls "
        "lies flatter in a simulation than on the table. Here is why, and two laws that mend it.");
    if (const auto problem = never_stops(walk, speed, 1.5 * stop_time(mu, speed)))
        return *problem;
    if (const auto problem = stopping(walk, cdt, epsd, speed))
        return *problem;
    if (const auto problem = at_rest(walk, cdt, epsd))
        return *problem;
    if (const auto problem = slopes(walk, cdt, epsd))
        return *problem;
    const Result<Ride> small = ride(cdt, usual_radius / 2, 0, speed, 1.2 * stop_time(mu, speed), 20);
    if (!small)
        return small.problems();
    const double place = small->place[small->stop()];
    walk.question = "A ball of half the radius sets out at the same speed. How far does it roll?";
    walk.answer = fmt::format("As far as the other: {:.4g} m. Its weight is an eighth and the lead of what bears it a "
                              "half, so the torque is a "
                              "sixteenth; what has to be stopped, 7/5 m R v, is a sixteenth as well. In experiments "
                              "small balls stop sooner, so "
                              "their μ_r is larger: a coefficient of rolling friction belongs to a size.",
                              place);
    walk.fact("stop_distance_small", place, "m");
    return walk;
}

} // namespace

Lesson rolling_resistance() {
    return {
        .name = "rolling-resistance",
        .title = "Rolling resistance: what stops a ball",
        .parameters = {{"rolling_friction", "", 0.05, {.lo = 0.02, .hi = 0.3}, "Coefficient of rolling friction μ_r"},
                       {"rolling_damping", "", 0.3, {.lo = 0.1, .hi = 1}, "Share of critical damping η_r of epsd"},
                       {"speed_m_s", "m/s", 0.3, {.lo = 0.1, .hi = 0.6}, "First speed of the ball"}},
        .teach = teach};
}

} // namespace tumble::lesson
