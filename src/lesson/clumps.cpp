#include "lesson/each.h"
#include "lesson/impact.h"
#include "lesson/packing.h"
#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double stiffness = 1e5; // N/m, of one contact
constexpr int steps_per_contact = 500;
constexpr int contact_times = 4; // that a landing is watched for
const contact::Material plastic{"plastic", 1665.71, 5e7, 0.25};

/// A flat body: a row of 2, or a square of 1, 4 or 9 spheres that touch.
std::vector<scene::Sphere> raft(int spheres, double radius) {
    const int columns = spheres == 2 ? 2 : static_cast<int>(std::lround(std::sqrt(spheres)));
    const int rows = spheres / columns;
    std::vector<scene::Sphere> parts;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            parts.push_back(
                {{2 * radius * (column - 0.5 * (columns - 1)), 0, 2 * radius * (row - 0.5 * (rows - 1))}, radius});
    return parts;
}

struct Landing {
    double restitution = 0, overlap = 0, duration = 0; // -, m, s
    bool left = false;                                 // it came free again
};

struct Setup {
    double e = 0, speed = 0, radius = 0; // -, m/s, m
    double mass = 0.02;                  // kg, of every body, whatever it is made of

    explicit Setup(const Values& values)
        : e(values["restitution"]), speed(values["speed_m_s"]), radius(values["radius_mm"] * 1e-3) {}

    /// Flat onto a plane, linear law, no gravity.
    [[nodiscard]] Result<Landing> land(int spheres, bool shared) const {
        contact::PairProperties pair = linear_pair(stiffness, 0, e, 0);
        pair.tangential_stiffness = stiffness;
        const double omega = std::sqrt(stiffness * spheres / mass);
        const double dt = pi / omega / steps_per_contact;
        scene::Scene scene = space_stage(plastic, pair, dt);
        scene.contact.normal = scene::NormalLaw::linear;
        scene.contact.tangential = scene::TangentialLaw::linear;
        scene.contact.share_among_body_contacts = shared;
        add_body(scene, raft(spheres, radius));
        scene.bodies.back().mass = mass;
        add_wall(scene, scene::WallShape(scene::PlaneShape{}));
        const Result<sim3d::WorldPtr> world = start(scene, std::vector<sim3d::BodyState>{});
        if (!world)
            return world.problems();
        sim3d::BodyState body;
        body.position = {0, radius, 0};
        body.velocity = {0, -speed, 0};
        body.orientation = sim3d::shapes_of(**world)[0].written_from_principal;
        if (const auto problem = sim3d::insert(**world, {body}))
            return *problem;
        return follow(**world, dt);
    }

private:
    [[nodiscard]] Result<Landing> follow(sim3d::World& world, double dt) const {
        Landing seen;
        for (int k = 1; k <= contact_times * steps_per_contact; ++k) {
            if (const auto problem = sim3d::advance(world, 1))
                return *problem;
            const sim3d::BodyState body = sim3d::bodies_of(world)[0];
            seen.overlap = std::max(seen.overlap, radius - body.position.y());
            seen.restitution = std::max(0.0, body.velocity.y() / speed);
            seen.duration = k * dt;
            if (k > 2 && body.position.y() >= radius)
                break;
        }
        return seen;
    }
};

/// e_n of n contacts in parallel; 0 from critical damping on.
double landing_theory(double e, int n) {
    const double zeta = std::sqrt(n) * damping_ratio(e);
    return zeta < 1 ? std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)) : 0;
}

std::optional<Problem> parallel(Walk& walk, const Setup& s) {
    walk.head("n contacts are n springs");
    walk.say("A clump is a rigid body made of spheres, and each of its spheres brings its own contact. A body of four "
             "spheres that lands flat touches four times at once. All four springs carry one mass, side by side:");
    walk.formula("κ_n = n κ,   c_n = n c,   ζ_n = n c / (2 √(n κ m)) = √n ζ", "docs/bodies.md");
    walk.formula("e_n = exp(−π ζ_n / √(1 − ζ_n²));   from ζ_n = 1 on nothing comes back");
    walk.say(fmt::format(
        "Bodies of 1, 2, 4 and 9 spheres, all of {:.4g} g, land at {:.4g} m/s; one contact alone has e = {:.4g}.",
        1e3 * s.mass, s.speed, s.e));
    Grid grid{
        {{"spheres"}, {"e, solver"}, {"e, theory"}, {"overlap / one's"}, {"time / one's"}, {"n^-1/2"}, {"e, shared"}},
        {}};
    const Result<Landing> one = s.land(1, false);
    if (!one)
        return one.problems().front();
    for (const int n : {1, 2, 4, 9}) {
        const Result<Landing> seen = s.land(n, false), shared = s.land(n, true);
        if (!seen || !shared)
            return (seen ? shared : seen).problems().front();
        grid.rows.push_back({static_cast<double>(n), seen->left ? Cell(seen->restitution) : Cell("-"),
                             landing_theory(s.e, n), seen->overlap / one->overlap,
                             seen->left ? Cell(seen->duration / one->duration) : Cell("-"), 1 / std::sqrt(n),
                             shared->left ? Cell(shared->restitution) : Cell("-")});
        walk.fact(fmt::format("restitution_{}", n), seen->restitution);
        walk.fact(fmt::format("shared_restitution_{}", n), shared->restitution);
    }
    walk.parts.emplace_back(grid);
    if (landing_theory(s.e, 9) == 0)
        walk.say("Where theory says 0 the body does not come free: it creeps out of the floor, ever slower.");
    walk.say("Stiffer makes the landing shorter and less deep, without dashpots by n^-1/2. More damped makes it "
             "duller: a restitution measured on single spheres is not the restitution of the bodies made of them. The "
             "last column has `share_among_body_contacts = true`: while n contacts of one pair of bodies touch, each "
             "dashpot counts 1/√n, and the pair is damped as one contact is.");
    Figure figure{.name = "landing",
                  .title = "Restitution of a flat landing on n spheres: lines theory, points solver",
                  .x = {"restitution of one contact", ""},
                  .y = {"restitution of the body", ""},
                  .curves = {}};
    for (const int n : {1, 2, 4, 9}) {
        Curve theory{fmt::format("n = {}", n), Style::line, {}, {}};
        for (int k = 5; k <= 100; ++k)
            theory.add(k / 100.0, landing_theory(k / 100.0, n));
        figure.curves.push_back(std::move(theory));
    }
    for (const int n : {1, 2, 4, 9}) {
        Curve points{"", Style::points};
        points.color = figure.curves.size() - 4;
        for (const double e : {0.3, 0.5, 0.7, 0.9}) {
            Setup other = s;
            other.e = e;
            const Result<Landing> seen = other.land(n, false);
            if (!seen)
                return seen.problems().front();
            points.add(e, seen->restitution);
        }
        figure.curves.push_back(std::move(points));
    }
    walk.parts.emplace_back(figure);
    return std::nullopt;
}

/// Volume of two equal spheres whose centres are `apart` from each other, less than two radii: what both have is a
/// lens.
double two_spheres(double radius, double apart) {
    const double cap = radius - apart / 2;
    return 8.0 / 3 * pi * std::pow(radius, 3) - 2.0 / 3 * pi * cap * cap * (3 * radius - cap);
}

std::optional<Problem> mass(Walk& walk, const Setup& s) {
    walk.head("Matter counts once");
    walk.say("Spheres of a clump overlap. Its mass is that of their union: what two spheres share is there once. For "
             "two equal spheres the shared part is a lens of two caps:");
    walk.formula("V = 8/3 π R³ − 2 · π h² (3 R − h) / 3,   h = R − d/2");
    Grid grid{{{"distance / R"},
               {"mass, solver", "g", 6},
               {"lens formula", "g", 6},
               {"sum of spheres", "g", 6},
               {"too heavy by", "%", 3}},
              {}};
    for (const double share : {0.25, 0.5, 1.0, 1.5, 2.0}) {
        const double apart = share * s.radius;
        scene::Scene scene = space_stage(plastic, linear_pair(stiffness, 0, 1, 0), 1e-6);
        add_body(scene, {{{-apart / 2, 0, 0}, s.radius}, {{apart / 2, 0, 0}, s.radius}});
        const Result<sim3d::WorldPtr> world = start(scene, std::vector<sim3d::BodyState>{});
        if (!world)
            return world.problems().front();
        const double seen = sim3d::shapes_of(**world)[0].mass,
                     sum = two_spheres(s.radius, 2 * s.radius) * plastic.density;
        const double expected = two_spheres(s.radius, apart) * plastic.density;
        grid.rows.push_back({share, 1e3 * seen, 1e3 * expected, 1e3 * sum, 100 * (sum / seen - 1)});
        walk.fact(fmt::format("mass_at_{}", share), seen, "kg");
    }
    walk.parts.emplace_back(grid);
    return std::nullopt;
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    Walk walk;
    walk.say("Real media are cones and wedges, not spheres. A rigid clump of spheres has their shape and keeps the "
             "simple contact of two spheres. It is a body of its own, with two surprises.");
    for (const auto add : {parallel, mass})
        if (const auto problem = add(walk, s))
            return *problem;
    if (const auto problem =
            add_packing(walk, {values["friction"], 1e-3 * values["packing_width_mm"],
                               static_cast<int>(values["packing_bodies"]), static_cast<int>(values["packing_fills"])}))
        return *problem;
    const double zeta = damping_ratio(s.e);
    walk.question = fmt::format("On how many spheres at once must a body land so that it does not rebound at all, with "
                                "e = {:.4g} of one contact?",
                                s.e);
    const double dead = 1 / (zeta * zeta);
    walk.answer =
        zeta > 0 ? fmt::format("On {:.0f}: ζ = {:.4g}, and √n ζ ≥ 1 from n = 1/ζ² = {:.4g} on. That is so as long as a "
                               "contact may pull the body back. With `limit_force = true` it may not, and at √n ζ = 1 "
                               "the body leaves with e = exp(−2) = {:.3f} (Schwager and Pöschel 2007).",
                               std::ceil(dead), zeta, dead, std::exp(-2))
                 : "On no number: without a dashpot n springs give back all, as one does.";
    return walk;
}

} // namespace

Lesson clumps() {
    return {.name = "clumps",
            .title = "Clumps: why n contacts are n springs",
            .parameters =
                {{"restitution",
                  "",
                  0.667,
                  {.lo = 0.05, .hi = 1},
                  "Restitution of one contact (thesis, table 4.4: media on media)"},
                 {"speed_m_s", "m/s", 0.5, {.lo = 1e-3, .hi = 1}, "Speed of the landing"},
                 {"radius_mm", "mm", 5, {.lo = 2, .hi = 100}, "Radius of the spheres, R"},
                 {"friction",
                  "",
                  0.58,
                  {.lo = 0.05, .hi = 1},
                  "Friction of the media that are packed (thesis, table 4.1: media on media)"},
                 {"packing_bodies", "", 60, {.lo = 40, .hi = 4000}, "Media in a bed", true},
                 {"packing_width_mm", "mm", 60, {.lo = 50, .hi = 300}, "Width of the bed"},
                 {"packing_fills", "", 1, {.lo = 1, .hi = 10}, "Beds of each kind, filled from other seeds", true}},
            .teach = teach};
}

} // namespace tumble::lesson
