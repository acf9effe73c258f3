#include "lesson/each.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double g = 9.81;        // m/s2
constexpr double stiffness = 1e7; // N/m
constexpr double radius = 0.1;    // m
constexpr double dt = 2e-5;       // s
constexpr double degrees = 180 / std::numbers::pi;

/// A floor inclined by `slope` (rad): gravity is turned instead, x points downhill.
scene::Scene incline(double slope, double friction) {
    scene::Scene scene = plane_stage(linear_pair(stiffness, 1, 0.3, friction), dt);
    scene.gravity = {g * std::sin(slope), -g * std::cos(slope), 0};
    add_wall(scene, scene::Outline(scene::SegmentShape{{-50, 0}, {50, 0}}));
    return scene;
}

struct Ride {
    std::vector<double> time, speed, surface; // s, m/s downhill, of the body and of its lowest point
    double moved = 0;                         // m
    /// Between two thirds and the end, m/s2.
    [[nodiscard]] double acceleration() const {
        const std::size_t from = time.size() * 2 / 3;
        return (speed.back() - speed[from]) / (time.back() - time[from]);
    }
};

/// Sets a body of these discs on the floor at `speed` and watches it for `duration` s, every `look` steps.
Result<Ride> ride(double slope, double friction, const std::vector<scene::Sphere>& discs, double speed, double duration,
                  int look = 50) {
    scene::Scene scene = incline(slope, friction);
    add_body(scene, discs);
    sim2d::BodyState body;
    const double mass = 1000 * std::numbers::pi * radius * radius * static_cast<double>(discs.size());
    body.position = {0, radius - mass * g * std::cos(slope) / stiffness / static_cast<double>(discs.size())};
    body.velocity = {speed, 0};
    const Result<sim2d::WorldPtr> world = start(scene, {body});
    if (!world)
        return world.problems();
    Ride seen;
    const auto looks = static_cast<int>(std::lround(duration / dt / look));
    for (int k = 0; k <= looks; ++k) {
        const sim2d::BodyState now = sim2d::bodies_of(**world)[0];
        seen.time.push_back(sim2d::time_of(**world));
        seen.speed.push_back(now.velocity.x());
        seen.surface.push_back(now.velocity.x() + now.angular_velocity * radius);
        seen.moved = now.position.x();
        if (const auto problem = k < looks ? sim2d::advance(**world, look) : std::nullopt)
            return *problem;
    }
    return seen;
}

/// Three discs in a row, bound together: it slides or it stays.
std::vector<scene::Sphere> block() {
    return {{{-2 * radius, 0, 0}, radius}, {{0, 0, 0}, radius}, {{2 * radius, 0, 0}, radius}};
}
std::vector<scene::Sphere> disc() {
    return {{{0, 0, 0}, radius}};
}

double block_theory(double slope, double mu) {
    return std::max(0.0, g * (std::sin(slope) - mu * std::cos(slope)));
}
double disc_theory(double slope, double mu) {
    return std::max(2.0 / 3 * g * std::sin(slope), g * (std::sin(slope) - mu * std::cos(slope)));
}

std::optional<Problem> inclines(Walk& walk, double mu) {
    walk.head("On an incline");
    walk.say("A block, three discs bound in a row, lies on a slope. Below the angle of friction the shear springs of "
             "its contacts stretch until they carry the downhill pull, and it stays. Above, the pull exceeds what "
             "Coulomb allows, the springs are cut back in every step, and it slides:");
    walk.formula(fmt::format("stays while tan α ≤ μ, that is α ≤ {:.4g} deg;   else a = g (sin α − μ cos α)",
                             std::atan(mu) * degrees));
    walk.say("A single disc is another matter. It rolls, and rolling needs only a third of the downhill pull as "
             "friction; so it is slow to slip, and never rests:");
    walk.formula(
        fmt::format("rolls with a = 2/3 g sin α while tan α ≤ 3 μ, that is α ≤ {:.4g} deg;   else slips as the block",
                    std::atan(3 * mu) * degrees));
    Grid grid{
        {{"slope", "deg"}, {"tan α / μ"}, {"block", "m/s2"}, {"theory", "m/s2"}, {"disc", "m/s2"}, {"theory", "m/s2"}},
        {}};
    Figure figure{.name = "incline",
                  .title = "Acceleration down a slope",
                  .x = {"slope", "deg"},
                  .y = {"acceleration", "m/s2"},
                  .curves = {{"block, theory", Style::line, {}, {}, 0},
                             {"block, solver", Style::points, {}, {}, 0},
                             {"disc, theory", Style::line, {}, {}, 1},
                             {"disc, solver", Style::points, {}, {}, 1}}};
    double worst = 0;
    for (const double share : {0.5, 0.95, 1.05, 1.5, 2.0, 2.8, 3.2, 4.0}) {
        const double slope = std::atan(share * mu);
        const Result<Ride> slab = ride(slope, mu, block(), 0, 0.3), roller = ride(slope, mu, disc(), 0, 0.3);
        if (!slab || !roller)
            return (slab ? roller : slab).problems().front();
        const double block_seen = std::abs(slab->acceleration()) < 1e-9 ? 0 : slab->acceleration(),
                     disc_seen = roller->acceleration();
        grid.rows.push_back(
            {slope * degrees, share, block_seen, block_theory(slope, mu), disc_seen, disc_theory(slope, mu)});
        figure.curves[1].add(slope * degrees, block_seen);
        figure.curves[3].add(slope * degrees, disc_seen);
        walk.fact(fmt::format("block_at_{}", share), block_seen, "m/s2");
        walk.fact(fmt::format("disc_at_{}", share), disc_seen, "m/s2");
        worst = std::max({worst, std::abs(block_seen - block_theory(slope, mu)) / g,
                          std::abs(disc_seen - disc_theory(slope, mu)) / g});
    }
    constexpr int points = 40; // between two of these: the curves have their kinks at 1 and 3
    for (const auto& [from, to] : {std::pair{0.0, 1.0}, std::pair{1.0, 3.0}, std::pair{3.0, 4.2}})
        for (int k = 0; k <= points; ++k) {
            const double slope = std::atan(mu * (from + (to - from) * k / points));
            figure.curves[0].add(slope * degrees, block_theory(slope, mu));
            figure.curves[2].add(slope * degrees, disc_theory(slope, mu));
        }
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(figure);
    walk.say(fmt::format("Theory and solver differ by at most {:.1g} of g. The thesis finds the coefficients of its "
                         "media in the same way, by tilting a plane until a particle begins to slide (figure 4.7).",
                         worst));
    return std::nullopt;
}

/// The slope (rad) at which the block begins to slide, by halving.
Result<double> sliding_angle(double mu) {
    double rests = 0.5 * std::atan(mu), slides = std::min(1.5, std::atan(2 * mu));
    for (int k = 0; k < 12; ++k) {
        const double middle = 0.5 * (rests + slides);
        const Result<Ride> seen = ride(middle, mu, block(), 0, 0.3);
        if (!seen)
            return seen.problems();
        (seen->acceleration() > 1e-4 ? slides : rests) = middle;
    }
    return 0.5 * (rests + slides);
}

Result<Film> film_of_slip(double mu, double speed, double until) {
    scene::Scene scene = incline(0, mu);
    put(scene, add_body(scene, disc()), {0, radius}, {speed, 0});
    constexpr int pictures = 75;
    Film shown{.name = "slipping-disc",
               .title = "A disc that slips, then rolls",
               .reels = {},
               .every = one_digit(until / pictures),
               .range = {0, speed},
               .view = scene::Box{{-radius, 0, -0.5}, {until * speed + radius, 3 * radius, 0.5}}};
    Result<Reel> reel = film(scene, "", until, shown.every);
    if (!reel)
        return reel.problems();
    shown.poster = reel->frames.size() / 3; // it still slips
    shown.reels.push_back(std::move(*reel));
    return shown;
}

std::optional<Problem> slip_to_roll(Walk& walk, double mu, double speed) {
    const double until = speed / (3 * mu * g);
    const int look = std::max(1, static_cast<int>(until / dt / 200));
    const Result<Ride> seen = ride(0, mu, disc(), speed, 1.6 * until, look);
    if (!seen)
        return seen.problems().front();
    // Over the last eighth: the shear spring still swings a little.
    const std::size_t from = seen->time.size() * 7 / 8;
    double rolling = 0, energy = 0; // m/s; of the first energy, both motions
    for (std::size_t k = from; k < seen->time.size(); ++k) {
        const double v = seen->speed[k], rim = seen->surface[k] - v,
                     share = 1.0 / static_cast<double>(seen->time.size() - from);
        rolling += share * v;
        energy += share * (v * v + 0.5 * rim * rim) / (speed * speed);
    }
    walk.head("From slip to roll");
    walk.say(fmt::format("A disc is set on level ground at {:.4g} m/s without spin. It slips; friction brakes it and "
                         "spins it up, both at a constant rate, until its lowest point stands still. From then on it "
                         "rolls, and friction is not needed any more:",
                         speed));
    walk.formula("m v' = −μ m g,   m R²/2 ω' = −μ m g R   →   rolls from t = v₀ / (3 μ g) on with 2/3 v₀");
    // The last two looks while it slips say when the lowest point comes to rest.
    double rolls_from = seen->time.back();
    for (std::size_t k = 2; k < seen->time.size(); ++k)
        if (seen->surface[k] < 1e-3 * speed) {
            const double lost = (seen->surface[k - 2] - seen->surface[k - 1]) / (seen->time[k - 1] - seen->time[k - 2]);
            rolls_from = seen->time[k - 1] + seen->surface[k - 1] / lost;
            break;
        }
    walk.parts.emplace_back(Grid{{{""}, {"solver", "", 5}, {"closed form", "", 5}, {"unit"}},
                                 {{"rolls from", rolls_from, until, "s"},
                                  {"speed then", rolling, 2.0 / 3 * speed, "m/s"},
                                  {"energy left", 100 * energy, 100 * 2.0 / 3, "%"}}});
    if (rolls_from < 0.99 * until)
        walk.say("It rolls a little earlier than Coulomb alone would have it: until the shear spring is wound up, the "
                 "dashpot brakes beside it, and no limit holds that (below).");
    Figure figure{.name = "slip-to-roll",
                  .title = "A disc that slips, then rolls",
                  .x = {"time", "s"},
                  .y = {"speed", "m/s"},
                  .curves = {{"centre", Style::line, {}, {}},
                             {"lowest point", Style::line, {}, {}},
                             {"2/3 of the first speed", Style::dashes, {}, {}}}};
    for (std::size_t k = 0; k < seen->time.size(); k += std::max<std::size_t>(1, seen->time.size() / 400)) {
        figure.curves[0].add(seen->time[k], seen->speed[k]);
        figure.curves[1].add(seen->time[k], seen->surface[k]);
        figure.curves[2].add(seen->time[k], 2.0 / 3 * speed);
    }
    walk.parts.emplace_back(figure);
    walk.fact("rolls_from", rolls_from, "s");
    walk.fact("rolling_speed", rolling, "m/s");
    walk.fact("energy_left", energy);
    Result<Film> shown = film_of_slip(mu, speed, 1.6 * until);
    if (!shown)
        return shown.problems().front();
    walk.show(std::move(*shown));
    return std::nullopt;
}

/// What a disc that strikes a floor at a flat angle gets along it, over Coulomb's share of what it gets across.
struct Graze {
    double impulses = 0; // J_t / (mu J_n) of the whole impact
    double forces = 0;   // the largest F_t / (mu F_n) of any step
};

constexpr double shear_ratio = 0.7; // kappa_s / kappa_n, as in the scenes of two dimensions
constexpr double flatness = 8;      // speed along the floor over speed towards it

Result<Graze> graze(double e, double mu) {
    constexpr double fine = 2e-7; // s: some hundred steps before the spring slips
    constexpr double towards = 0.01;
    scene::Scene scene = plane_stage(linear_pair(stiffness, shear_ratio, e, mu), fine);
    add_wall(scene, scene::Outline(scene::SegmentShape{{-1, 0}, {1, 0}}));
    add_body(scene, disc());
    sim2d::BodyState body;
    body.position = {0, radius};
    body.velocity = {flatness * towards, -towards};
    const Result<sim2d::WorldPtr> world = start(scene, {body});
    if (!world)
        return world.problems();
    Graze seen;
    Eigen::Vector2d now = body.velocity;
    do {
        const Eigen::Vector2d before = now;
        if (const auto problem = sim2d::advance(**world, 1))
            return *problem;
        now = sim2d::bodies_of(**world)[0].velocity;
        const Eigen::Vector2d push = now - before; // times mass / step
        if (push.y() > 0)
            seen.forces = std::max(seen.forces, -push.x() / push.y() / mu);
    } while (now.y() < 0 || sim2d::books_of(**world).contacts > 0);
    seen.impulses = (body.velocity.x() - now.x()) / (now.y() - body.velocity.y()) / mu;
    return seen;
}

/// J_t / (mu J_n) of an impact that slides from its first moment to its last, for the steepest of slips. The normal
/// force turns to a pull, which bears no friction, when the speed is e* = exp(-zeta w t*) of what it was; the dashpot
/// adds 4 zeta^2 / sqrt(kappa_s / kappa_n) before the spring bears its limit.
double grazing_share(double e) {
    const double zeta = -std::log(e) / std::hypot(std::log(e), std::numbers::pi), damped = std::sqrt(1 - zeta * zeta);
    const double pulls_from = (std::numbers::pi - std::atan2(2 * zeta * damped, 1 - 2 * zeta * zeta)) / damped;
    return (1 + std::exp(-zeta * pulls_from) + 4 * zeta * zeta / std::sqrt(shear_ratio)) / (1 + e);
}

std::optional<Problem> beyond_the_limit(Walk& walk) {
    walk.head("What the limit does not limit");
    walk.say(fmt::format("Coulomb's limit holds the spring. Beside it the contact has a dashpot, as in Cundall and "
                         "Strack 1979, and its "
                         "force comes on top as long as the spring is below the limit. At a flat impact the spring is "
                         "still at rest when "
                         "the slip is fastest, and the sum exceeds μ F_n. Discs that strike a floor, {:.4g} "
                         "times as fast along it as towards it, with the coefficients of the shipped scenes:",
                         flatness));
    Grid grid{{{"as in"},
               {"e"},
               {"μ"},
               {"J_t / (μ J_n)", "", 3},
               {"if it slid throughout", "", 3},
               {"largest F_t / (μ F_n)", "", 3}},
              {}};
    struct Row {
        const char* scene;
        double e, mu;
    };
    for (const auto& [scene, e, mu] : {Row{"no dashpot", 1, 0.5}, Row{"drum-2d", 0.6, 0.5},
                                       Row{"shaken-bed-2d", 0.3, 0.3}, Row{"trough-2d, lining", 0.159, 0.86}}) {
        const Result<Graze> seen = graze(e, mu);
        if (!seen)
            return seen.problems().front();
        grid.rows.push_back({scene, e, mu, seen->impulses, grazing_share(e), seen->forces});
        walk.fact(fmt::format("grazing_impulses_of_e_{:g}", e), seen->impulses);
        walk.fact(fmt::format("grazing_forces_of_e_{:g}", e), seen->forces);
    }
    walk.parts.emplace_back(grid);
    walk.formula("J_t / (μ J_n) = (1 + e* + 4 ζ² / √(κ_s / κ_n)) / (1 + e)", "docs/theory-2d.md");
    walk.say(
        "e* of the speed is left when the normal force turns to a pull, which lowers J_n and bears no friction. A bed "
        "of low restitution whose bodies graze each other is thus rougher than its μ says. Codes differ here: some "
        "hold the "
        "sum of spring and dashpot to the limit, this one does not offer it.");
    return std::nullopt;
}

Result<Walk> teach(const Values& values) {
    const double mu = values["friction"], speed = values["speed_m_s"];
    Walk walk;
    walk.say("Friction in a discrete element code is a spring with a limit. While the spring holds, the contact "
             "sticks; what it would bear beyond μ F_n is cut off, and the contact slips (`tumble lesson force-law`). "
             "Here is what that does to whole bodies.");
    if (const auto problem = inclines(walk, mu))
        return *problem;
    const Result<double> angle = sliding_angle(mu);
    if (!angle)
        return angle.problems();
    walk.say(
        fmt::format("Tilted in ever smaller steps, the block begins to slide at {:.5g} deg; arctan μ is {:.5g} deg.",
                    *angle * degrees, std::atan(mu) * degrees));
    walk.fact("sliding_angle", *angle * degrees, "deg");
    if (const auto problem = slip_to_roll(walk, mu, speed))
        return *problem;
    if (const auto problem = beyond_the_limit(walk))
        return *problem;
    const Result<Ride> twice = ride(0, 2 * mu, disc(), speed, 1.6 * speed / (3 * mu * g));
    if (!twice)
        return twice.problems();
    walk.question = "The floor is made twice as rough. How much of its energy does the disc lose to sliding now?";
    walk.answer = fmt::format(
        "As much as before, a third: it ends up with {:.5g} m/s again. Friction decides only how soon it rolls. (The "
        "angular momentum about the line of contact does not change while it slips, and fixes the last speed.)",
        twice->speed.back());
    return walk;
}

} // namespace

Lesson friction() {
    return {.name = "friction",
            .title = "Friction: stick, slip, and the incline",
            .parameters = {{"friction", "", 0.3, {.lo = 0.05, .hi = 1}, "Coulomb's coefficient μ"},
                           {"speed_m_s", "m/s", 1, {.lo = 0.5, .hi = 5}, "First speed of the disc that slips, v₀"}},
            .teach = teach};
}

} // namespace tumble::lesson
