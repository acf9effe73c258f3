#include "contact/cundall_strack.h"
#include "contact/hertz_discs.h"
#include "lesson/each.h"
#include "lesson/rig.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tumble::lesson {

namespace {

constexpr int steps = 400;      // per leg
constexpr double dt = 1e-3;     // s, without effect: no dashpot
constexpr double mass = 1;      // kg, without effect likewise
constexpr double micro = 1e-6;  // m per um
constexpr double micro_J = 1e6; // uJ per J

/// Two equal spheres and, beside them, a linear contact that is as stiff at the deepest point.
struct Setup {
    double radius = 0, depth = 0, width = 0, friction = 0; // m: R*, overlap, shear each way
    contact::PairConstants hertz, linear;
    double force = 0;           // N, at the deepest point, the same for both
    double shear_stiffness = 0; // N/m there

    explicit Setup(const Values& values)
        : radius(values["radius_mm"] * 1e-3 / 2), depth(values["overlap_um"] * micro),
          width(values["shear_um"] * micro), friction(values["friction"]) {
        const contact::Material grain{"grain", 0, values["youngs_modulus_Pa"], values["poisson_ratio"]};
        contact::PairProperties pair;
        pair.restitution = 1;
        pair.friction = friction;
        hertz = contact::derive(grain, grain, pair);
        const double a = std::sqrt(radius * depth);
        force = 4.0 / 3 * hertz.E_eff * a * depth;
        shear_stiffness = 8 * hertz.G_eff * a;
        linear = hertz;
        linear.normal_stiffness = force / depth;
        linear.tangential_stiffness = shear_stiffness;
    }

    [[nodiscard]] Trace drag_hertz(const std::vector<Place>& corners) const {
        return drag(contact::HertzDiscs<contact::Mindlin>(hertz, false), radius, mass, corners, steps, dt);
    }
    [[nodiscard]] Trace drag_linear(const std::vector<Place>& corners) const {
        return drag(contact::CundallStrack(linear, false, true), radius, mass, corners, steps, dt);
    }
};

void press(Walk& walk, const Setup& s) {
    const std::vector<Place> in{{0, 0}, {s.depth, 0}};
    const Trace hertz = s.drag_hertz(in), linear = s.drag_linear(in);
    const Trace both_ways = s.drag_hertz({{0, 0}, {s.depth, 0}, {0, 0}});
    walk.head("Press, and let go");
    walk.say("The rig presses one grain into the other and writes down the force. Two laws are asked: the linear "
             "spring of the thesis' discs, and Hertz' law of elastic spheres. To be comparable, the spring is chosen "
             "as stiff as makes both forces equal at the deepest point.");
    walk.formula("F_n = κ_n Δn", "(3.11)");
    walk.formula("F_n = 4/3 E* √(R* δ) δ,   1/E* = 2 (1 − ν²) / E,   R* = R / 2", "Hertz 1881");
    Grid grid{{{"overlap", "um"}, {"linear", "N"}, {"Hertz", "N"}, {"Hertz, formula", "N"}}, {}};
    for (const int quarter : {1, 2, 3, 4}) {
        const auto k = static_cast<std::size_t>(steps / 4 * quarter - 1);
        const double d = hertz.place[k].overlap;
        grid.rows.push_back(
            {d / micro, linear.normal[k], hertz.normal[k], 4.0 / 3 * s.hertz.E_eff * std::sqrt(s.radius * d) * d});
    }
    walk.parts.emplace_back(grid);
    Figure figure{.name = "normal",
                  .title = "Pressed together",
                  .x = {"overlap", "um"},
                  .y = {"normal force", "N"},
                  .curves = {{"Hertz, in and out", Style::line, {}, {}}, {"linear", Style::dashes, {}, {}}}};
    for (std::size_t k = 0; k < both_ways.place.size(); ++k)
        figure.curves[0].add(both_ways.place[k].overlap / micro, both_ways.normal[k]);
    for (std::size_t k = 0; k < linear.place.size(); ++k)
        figure.curves[1].add(linear.place[k].overlap / micro, linear.normal[k]);
    walk.parts.emplace_back(figure);
    walk.say(fmt::format(
        "A sphere's contact begins soft, for the area that carries the load begins with nothing. At a quarter of the "
        "overlap it bears {:.3g} of its full load (1/8), a spring a quarter. So at equal peak load it has stored less:",
        hertz.normal[steps / 4 - 1] / hertz.normal.back()));
    walk.parts.emplace_back(
        Grid{{{"work to press in"}, {"rig", "uJ"}, {"closed form", "uJ"}, {"formula"}},
             {{"linear", linear.work_normal * micro_J, 0.5 * s.force * s.depth * micro_J, "F δ / 2"},
              {"Hertz", hertz.work_normal * micro_J, 0.4 * s.force * s.depth * micro_J, "2 F δ / 5"}}});
    walk.say(fmt::format("Let go, the grains come out on the line on which they went in; the rig gets back its work to "
                         "better than {}. Without a dashpot a normal contact is a spring and nothing else.",
                         at_most(std::abs(both_ways.work_normal) / hertz.work_normal)));
    walk.say(fmt::format(
        "Hertz takes the circle of contact to be small against the grains. Its radius is √(R* δ), here {:.2g} "
        "% of R.",
        50 * std::sqrt(s.depth / s.radius)));
    walk.fact("hertz_force", hertz.normal.back(), "N");
    walk.fact("hertz_work", hertz.work_normal, "J");
    walk.fact("linear_work", linear.work_normal, "J");
}

/// The first point where the shear force stays behind its spring, m.
std::optional<double> yield_of(const Trace& trace, double stiffness) {
    for (std::size_t k = steps; k < trace.place.size(); ++k)
        if (stiffness * trace.place[k].shear - trace.shear[k] > 1e-9 * stiffness * trace.place[k].shear)
            return trace.place[k].shear;
    return std::nullopt;
}

/// Drawn along once, in steps short enough for the spring to be seen before it gives.
void first_draw(Walk& walk, const Setup& s, double limit, double yield) {
    const double way = yield > 0 ? std::min(s.width, 1.25 * yield) : s.width;
    const Trace first = s.drag_hertz({{0, 0}, {s.depth, 0}, {s.depth, way}});
    const double slope = first.shear[steps] / first.place[steps].shear;
    const std::optional<double> slides = yield_of(first, s.shear_stiffness);
    Grid grid{{{""}, {"rig"}, {"closed form"}, {"unit"}, {"formula"}}, {}};
    if (yield > 0)
        grid.rows.push_back({"slope before the cut", slope, s.shear_stiffness, "N/m", "8 G* √(R* δ)"});
    grid.rows.push_back({"largest shear force", first.shear.back(), std::min(limit, s.shear_stiffness * s.width), "N",
                         slides ? "μ F_n" : "κ_s s"});
    if (slides && yield > 0)
        grid.rows.push_back({"slides from", *slides / micro, yield / micro, "um", "μ F_n / κ_s"});
    else
        grid.rows.push_back(
            {"slides from", slides ? "the start" : "does not slide", yield / micro, "um", "μ F_n / κ_s"});
    walk.parts.emplace_back(grid);
    walk.fact("shear_slope", slope, "N/m");
    walk.fact("shear_limit", first.shear.back(), "N");
    if (slides)
        walk.fact("yield", *slides, "m");
}

void rub(Walk& walk, const Setup& s) {
    const auto loop_at = [&](double depth) -> std::vector<Place> {
        return {{0, 0}, {depth, 0}, {depth, s.width}, {depth, -s.width}, {depth, s.width}};
    };
    const Trace hertz = s.drag_hertz(loop_at(s.depth));
    const Trace half_hertz = s.drag_hertz(loop_at(s.depth / 2)), half_linear = s.drag_linear(loop_at(s.depth / 2));
    const double limit = s.friction * s.force, yield = limit / s.shear_stiffness;
    walk.head("Draw one along the other, and back");
    walk.say("Pressed in and held there, one grain is now drawn along the other, back past the middle, and forth "
             "again. Shear has a spring too, and it remembers:");
    walk.formula("ΔF_s = κ_s Δs,   F_s = Σ ΔF_s", "(3.26), (3.27)");
    walk.formula("κ_s = 8 G* √(R* δ),   G* = E / (4 (2 − ν) (1 + ν))", "Mindlin 1949");
    walk.say("But no contact bears more than Coulomb's limit. What the sum exceeds it by is cut off, and the cut is "
             "what we call sliding:");
    walk.formula("|F_s| ≤ μ F_n", "Cundall and Strack 1979");
    first_draw(walk, s, limit, yield);
    Figure figure{.name = "shear",
                  .title = "Drawn to and fro under constant load",
                  .x = {"shear displacement", "um"},
                  .y = {"shear force", "N"},
                  .curves = {{fmt::format("both laws, overlap {:.4g} um", s.depth / micro)},
                             {fmt::format("Hertz and Mindlin, {:.4g} um", s.depth / 2 / micro)},
                             {fmt::format("linear, {:.4g} um", s.depth / 2 / micro), Style::dashes}}};
    const std::array<const Trace*, 3> traces{&hertz, &half_hertz, &half_linear};
    for (std::size_t c = 0; c < traces.size(); ++c)
        for (std::size_t k = steps - 1; k < traces[c]->place.size(); ++k)
            figure.curves[c].add(traces[c]->place[k].shear / micro, traces[c]->shear[k]);
    walk.parts.emplace_back(figure);
    walk.say(
        "The linear spring is as stiff as Mindlin's at the full overlap, so there both laws draw one loop. Pressed "
        "half as deep they part: the linear one is as stiff as before and bears half, Mindlin's is softer by √2 "
        "and bears a part of 1/√8, as the normal force does.");
    // Slid over: width - yield on the first way, twice that on each of the two ways across.
    const double lost = 5 * limit * std::max(0.0, s.width - yield);
    if (lost > 0)
        walk.say("Each corner is a change between sticking and sliding. After a reversal the spring must first be "
                 "unloaded, then loaded the other way, so it takes twice as far until the grains slide again: the same "
                 "displacement can belong to two forces. That is why the law needs a memory. The loop's area is heat:");
    else
        walk.say(
            "Drawn so little the grains never slide at the full overlap: the spring goes out and back on one line, and "
            "gives back what it took.");
    walk.parts.emplace_back(
        Grid{{{"over the whole path"}, {"uJ"}},
             {{"work of the rig along the shear", hertz.work_shear * micro_J},
              {"lost to sliding, the law's account", hertz.lost_sliding * micro_J},
              {"still in the shear spring", hertz.stored_shear * micro_J},
              {lost > 0 ? "closed form of the loss, 5 μ F_n (s − μ F_n / κ_s)" : "closed form of the loss",
               lost * micro_J}}});
    walk.fact("loop_loss", hertz.lost_sliding, "J");
    walk.fact("loop_work", hertz.work_shear - hertz.stored_shear, "J");
}

void unload(Walk& walk, const Setup& s) {
    const Trace out = s.drag_linear({{0, 0}, {s.depth, 0}, {s.depth, s.width}, {0, s.width}});
    walk.head("Let go while sheared");
    walk.say("Last, the grains are drawn along each other until they slide, and then the load is taken off without "
             "moving back. The limit comes down with the load and takes the shear force along: in the plane of the two "
             "forces a contact lives between two straight lines, and slides when it touches one.");
    Figure figure{.name = "cone",
                  .title = "Press, draw, let go: never outside the two lines",
                  .x = {"normal force", "N"},
                  .y = {"shear force", "N"},
                  .curves = {{"1 pressed in", Style::points},
                             {"2 drawn along", Style::points},
                             {"3 let go", Style::points},
                             {"μ F_n", Style::dashes, {}, {}, 3},
                             {"−μ F_n", Style::dashes, {}, {}, 3}}};
    double beyond = 0;
    for (std::size_t k = 0; k < out.place.size(); ++k) {
        if (k % 10 == 0)
            figure.curves[k / steps].add(out.normal[k], out.shear[k]);
        beyond = std::max(beyond, std::abs(out.shear[k]) - s.friction * out.normal[k]);
    }
    for (const std::size_t side : {3, 4}) {
        figure.curves[side].add(0, 0);
        figure.curves[side].add(s.force, (side == 3 ? 1 : -1) * s.friction * s.force);
    }
    walk.parts.emplace_back(figure);
    walk.fact("beyond_limit", beyond, "N");
}

Result<Walk> teach(const Values& values) {
    const Setup s(values);
    Walk walk;
    walk.say("What does a contact answer when it is pushed? To see nothing but the law, two equal grains are put in a "
             "rig that drags them along a prescribed path: no masses, no time, no dashpots.");
    press(walk, s);
    rub(walk, s);
    unload(walk, s);
    walk.question = "Twice the overlap: how many times the normal force, the shear stiffness, and the shear "
                    "displacement at which sliding begins, with the linear law and with Hertz and Mindlin's?";
    const double yield = s.friction * s.force / s.shear_stiffness;
    walk.answer =
        fmt::format("Linear: 2, 1 (the spring does not know the overlap), 2. Hertz and Mindlin: {:.4g} (δ to the 3/2), "
                    "{:.4g} (δ to the 1/2), and again 2: μ F_n / κ_s = μ δ E* / (6 G*), here {:.4g} um at {:.4g} um of "
                    "overlap. The ratio of the two stiffnesses depends on Poisson's ratio alone.",
                    std::pow(2, 1.5), std::sqrt(2.0), yield / micro, s.depth / micro);
    return walk;
}

} // namespace

Lesson force_law() {
    return {.name = "force-law",
            .title = "The force law on a rig: press, shear, reverse",
            .parameters = {{"friction", "", 0.3, {.lo = 0, .hi = 2}, "Coulomb's coefficient μ"},
                           {"overlap_um", "um", 50, {.lo = 0.01, .hi = 500}, "How deep the grains are pressed, δ"},
                           {"shear_um", "um", 30, {.lo = 0.01, .hi = 1000}, "How far they are drawn each way, s"},
                           {"radius_mm", "mm", 5, {.lo = 1, .hi = 100}, "Radius of both grains, R"},
                           {"youngs_modulus_Pa", "Pa", 5e7, {.lo = 1e6, .hi = 1e12}, "Young's modulus E"},
                           {"poisson_ratio", "", 0.25, {.lo = 0, .hi = 0.5}, "Poisson's ratio ν"}},
            .teach = teach};
}

} // namespace tumble::lesson
