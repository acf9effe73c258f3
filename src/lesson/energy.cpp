#include "base/books.h"
#include "lesson/each.h"
#include "lesson/impact.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double g = 9.81;    // m/s2
constexpr double milli = 1e3; // mJ per J
constexpr int steps_per_contact = 100;
constexpr int coarse_steps = 4;
const contact::Material media{"media", 1665.71, 5e7, 0.25};

struct Setup {
    double height = 0, e = 0, radius = 0, mass = 0; // m, -, m, kg

    explicit Setup(const Values& values)
        : height(values["height_mm"] * 1e-3), e(values["restitution"]), radius(values["radius_mm"] * 1e-3),
          mass(4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * media.density) {}

    [[nodiscard]] double energy() const { return mass * g * height; }
    [[nodiscard]] double speed() const { return std::sqrt(2 * g * height); }
    /// Release to the third impact, s.
    [[nodiscard]] double duration() const { return speed() / g * (1 + 2 * e + 2 * e * e); }
};

/// One line of the books, J; potential energy is that above the plate.
struct Instant {
    double time = 0, kinetic = 0, gravity = 0, elastic = 0, lost = 0;
    [[nodiscard]] double sum() const { return kinetic + gravity + elastic + lost; }
};

struct Drop {
    std::vector<Instant> course;
    std::vector<double> tops; // m, highest points after each bounce
    double closure = 0;       // J, the worst
};

Instant read(const Books& books, const Setup& s) {
    return {books.time, books.kinetic_translation + books.kinetic_rotation, books.gravity - s.mass * g * s.radius,
            books.stored_normal + books.stored_tangential,
            books.lost_normal_damping + books.lost_tangential_damping + books.lost_sliding};
}

/// The ball above the plate, stepped so that an elastic impact takes that many steps.
scene::Scene plate_and_ball(const Setup& s, double gravity, int steps) {
    contact::PairProperties pair;
    pair.restitution = s.e;
    const double E_eff = contact::derive(media, media, pair).E_eff;
    const double dt = hertz_impact(E_eff, s.radius, s.mass, s.speed()).duration / steps;
    scene::Scene scene = space_stage(media, pair, dt);
    scene.gravity = {0, -gravity, 0};
    scene.allow_large_step = true;
    add_round(scene, s.radius);
    add_wall(scene, scene::WallShape(scene::PlaneShape{}));
    return scene;
}

/// The part of its energy that one impact gives back; the surfaces meet `early` of a step after the start.
Result<double> given_back(const Setup& s, double gravity, int steps, double early) {
    const scene::Scene scene = plate_and_ball(s, gravity, steps);
    const double gap = early * s.speed() * scene.time_step;
    sim3d::BodyState ball;
    ball.position = {0, s.radius + gap, 0};
    ball.velocity = {0, -s.speed(), 0};
    const Result<sim3d::WorldPtr> world = start(scene, {ball});
    if (!world)
        return world.problems();
    bool touched = false;
    for (int k = 0; k < 10 * steps; ++k) {
        if (const auto problem = sim3d::advance(**world, 1))
            return *problem;
        const bool touches = sim3d::books_of(**world).contacts > 0;
        if (touched && !touches)
            break;
        touched = touches;
    }
    ball = sim3d::bodies_of(**world)[0];
    const double end = ball.velocity.squaredNorm() + 2 * gravity * (ball.position.y() - s.radius);
    return end / (s.speed() * s.speed() + 2 * gravity * gap);
}

/// By what part of e^2 an impact gives back more than e^2: what gravity does, seen with steps so short that nothing
/// else is left; and what the step does, without gravity, by where between two steps the surfaces meet.
struct Departure {
    double gravity = 0, least = 0, most = 0;
};

Result<Departure> departure(const Setup& s) {
    const double asked = s.e * s.e;
    const Result<double> pulled = given_back(s, g, 20 * steps_per_contact, 0.5);
    if (!pulled)
        return pulled.problems();
    Departure seen{*pulled / asked - 1, 1, -1};
    for (const double early : {0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
        const Result<double> free = given_back(s, 0, steps_per_contact, early);
        if (!free)
            return free.problems();
        seen.least = std::min(seen.least, *free / asked - 1);
        seen.most = std::max(seen.most, *free / asked - 1);
    }
    return seen;
}

Result<Drop> fall(const Setup& s, int steps) {
    sim3d::BodyState ball;
    ball.position = {0, s.radius + s.height, 0};
    const Result<sim3d::WorldPtr> world = start(plate_and_ball(s, g, steps), {ball});
    if (!world)
        return world.problems();
    Drop drop;
    double top = 0;
    bool touching = false;
    while (drop.tops.size() < 3 && sim3d::time_of(**world) < 1.5 * s.duration()) {
        if (const auto problem = sim3d::advance(**world, 1))
            return *problem;
        const Books books = sim3d::books_of(**world);
        drop.course.push_back(read(books, s));
        drop.closure = std::max(drop.closure, std::abs(books.closure));
        if (books.contacts > 0 && !touching && top > 0)
            drop.tops.push_back(top);
        touching = books.contacts > 0;
        top = touching ? 0 : std::max(top, sim3d::bodies_of(**world)[0].position.y() - s.radius);
    }
    return drop;
}

Figure balance(const Drop& drop, const std::string& name, const std::string& title, double from, double to) {
    Figure figure{.name = name,
                  .title = title,
                  .x = {"time", "ms"},
                  .y = {"energy", "mJ"},
                  .curves = {{"kinetic", Style::line, {}, {}},
                             {"potential (height)", Style::line, {}, {}},
                             {"elastic (contact)", Style::line, {}, {}},
                             {"lost to the dashpot", Style::line, {}, {}},
                             {"sum", Style::dashes, {}, {}}}};
    std::size_t inside = 0;
    for (const Instant& now : drop.course)
        inside += now.time >= from && now.time <= to;
    const std::size_t stride = std::max<std::size_t>(1, inside / 600);
    for (std::size_t k = 0; k < drop.course.size(); ++k) {
        const Instant& now = drop.course[k];
        // An impact is shorter than a stride: all of it is drawn.
        if (now.time < from || now.time > to || (k % stride != 0 && now.elastic == 0))
            continue;
        const std::array<double, 5> all{now.kinetic, now.gravity, now.elastic, now.lost, now.sum()};
        for (std::size_t c = 0; c < all.size(); ++c)
            figure.curves[c].add(1e3 * now.time, milli * all[c]);
    }
    return figure;
}

/// The moments of the first bounce that a table can show.
struct Moments {
    Instant touch, deepest, leave;

    explicit Moments(const Drop& drop) {
        bool touched = false;
        for (std::size_t k = 1; k < drop.course.size(); ++k) {
            const Instant& now = drop.course[k];
            if (!touched && now.elastic > 0) {
                touched = true;
                touch = drop.course[k - 1];
            }
            if (touched && now.elastic > deepest.elastic)
                deepest = now;
            if (touched && now.elastic == 0) {
                leave = now;
                return;
            }
        }
    }
};

void show_heights(Walk& walk, const Drop& drop, const Setup& s) {
    Grid heights{{{"after bounce"}, {"height, solver", "mm", 5}, {"h e^(2n)", "mm", 5}, {"difference", "%", 2}}, {}};
    for (std::size_t n = 1; n < std::min<std::size_t>(drop.tops.size(), 3); ++n) {
        const double expected = s.height * std::pow(s.e, 2.0 * static_cast<double>(n));
        heights.rows.push_back(
            {static_cast<double>(n), 1e3 * drop.tops[n], 1e3 * expected, 100 * (drop.tops[n] / expected - 1)});
        walk.fact(fmt::format("height_{}", n), drop.tops[n], "m");
    }
    walk.parts.emplace_back(heights);
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    const Result<Drop> drop = fall(s, steps_per_contact), coarse = fall(s, coarse_steps);
    const Result<Departure> departs = departure(s);
    if (!drop || !coarse)
        return (drop ? coarse : drop).problems();
    if (!departs)
        return departs.problems();
    if (drop->tops.size() < 3)
        return Problem{.what = "the ball does not bounce twice",
                       .fix = "a larger height, or a restitution nearer to 1"};
    const Moments at(*drop);
    Walk walk;
    walk.say(fmt::format(
        "A ball of {:.4g} g falls {:.4g} mm onto a plate and bounces. The solver keeps books: in every step it says "
        "how much energy moves, how much is height, how much the contact has stored, and what the dashpot has taken so "
        "far. The thesis draws these in figure 4.14b for two bounces; here they are again, with ball and plate softer "
        "than its plastic (E = {:.3g} Pa, ν = {:.3g}), so that an impact can be seen.",
        1e3 * s.mass, 1e3 * s.height, media.youngs_modulus, media.poisson_ratio));
    walk.parts.emplace_back(
        balance(*drop, "bounces", "Where the energy is, bounce after bounce", 0, drop->course.back().time));
    walk.say("Falling, height turns into motion, along two parabolas that mirror each other. The impact looks like a "
             "jump. The sum is a straight line: nothing comes from nowhere. Now the first impact alone, for what looks "
             "like a jump takes its time:");
    const double width = at.leave.time - at.touch.time;
    walk.parts.emplace_back(balance(*drop, "impact", "Where the energy is in the first impact",
                                    at.touch.time - 0.3 * width, at.leave.time + 0.3 * width));
    const auto row = [&](const char* name, const Instant& now) -> std::vector<Cell> {
        return {name,
                1e3 * now.time,
                milli * now.kinetic,
                milli * now.gravity,
                milli * now.elastic,
                milli * now.lost,
                milli * now.sum()};
    };
    walk.parts.emplace_back(Grid{{{"moment"},
                                  {"time", "ms", 5},
                                  {"kinetic", "mJ"},
                                  {"height", "mJ"},
                                  {"elastic", "mJ", 3},
                                  {"lost", "mJ", 3},
                                  {"sum", "mJ", 6}},
                                 {row("released", drop->course.front()), row("last step before the touch", at.touch),
                                  row("deepest", at.deepest), row("leaves", at.leave)}});
    walk.say(
        "At the deepest point almost nothing moves; what the ball had is in the contact, less what the dashpot has "
        "taken on the way in. On the way out it takes less, for the ball is slower. The closed forms of a bounce:");
    const double touched = s.energy();
    const double taken = at.leave.lost;
    walk.formula(
        fmt::format("energy lost in one bounce: (1 − e²) m g h = {:.5g} mJ", milli * (1 - s.e * s.e) * touched));
    walk.formula("height after n bounces: h e^(2n),   n = 1: thesis (4.7)");
    show_heights(walk, *drop, s);
    if (s.e == 1)
        walk.say(
            fmt::format("Without a dashpot nothing is lost in a bounce, here {:.2g} mJ. At no step do the books miss "
                        "more than {:.1g} of the energy, which is the error of sums taken in steps.",
                        milli * taken, drop->closure / s.energy()));
    else
        walk.say(fmt::format(
            "The solver lost {:.5g} mJ in the first bounce. Two things part it from the closed form. e is the "
            "restitution "
            "of a free impact, and here gravity goes on pulling while the ball is in touch: with steps so short that "
            "nothing else is left, that changes what an impact gives back by {:+.2f} %. And the steps are {} in a "
            "contact: "
            "without gravity they change it by {:+.2f} to {:+.2f} %, by where between two steps the surfaces meet. At "
            "no "
            "step do the books miss more than {:.1g} of the energy, which is the error of sums taken in steps.",
            milli * taken, 100 * departs->gravity, steps_per_contact, 100 * departs->least, 100 * departs->most,
            drop->closure / s.energy()));
    walk.fact("energy", s.energy(), "J");
    walk.fact("lost_first", taken, "J");
    walk.fact("closure", drop->closure / s.energy());
    walk.fact("closure_coarse", coarse->closure / s.energy());
    walk.fact("departure_gravity", departs->gravity);
    walk.fact("departure_least", departs->least);
    walk.fact("departure_most", departs->most);
    walk.question =
        fmt::format("Someone typed a restitution of {:.4g} in place of {:.4g}. Does the curve of the sum betray "
                    "it? So is a level sum a proof that a run is right?",
                    s.e < 0.85 ? 0.9 : 0.7, s.e);
    walk.answer = fmt::format(
        "No, twice. A level sum says that no energy was made or forgotten, not that it went where nature would send "
        "it: a wrong restitution, a wrong friction or a wrong mass all give a level sum. What the sum does catch is a "
        "step too long for the impact: with {} steps in a contact in place of {} it misses {:.1g} of the energy.",
        coarse_steps, steps_per_contact, coarse->closure / s.energy());
    return walk;
}

} // namespace

Lesson energy() {
    return {.name = "energy",
            .title = "Energy: where it goes in a bounce",
            .parameters = {{"height_mm", "mm", 200, {.lo = 10, .hi = 2000}, "Height of the fall, h"},
                           {"restitution",
                            "",
                            0.667,
                            {.lo = 0.3, .hi = 1},
                            "Coefficient of restitution e (thesis, table 4.4: media on media)"},
                           {"radius_mm",
                            "mm",
                            12.75,
                            {.lo = 1, .hi = 50},
                            "Radius of the ball (thesis, section 4.4: a 25.5 mm sphere of media)"}},
            .teach = teach};
}

} // namespace tumble::lesson
