#include "lab/bench.h"
#include "lab/each.h"
#include "observe/surface.h"
#include "run/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tumble::lab {

namespace {

constexpr double radius = 4e-3;    // m, of discs
constexpr double half = 0.3;       // m, from the middle to the end of the floor
constexpr double column = 0.04;    // m, half width of the column that is let go
constexpr double settled = 0.5;    // s, when the sides begin to rise
constexpr double spread = 1.0;     // s, after the sides are clear of the heap
constexpr double time_step = 5e-5; // s
constexpr double stiffness = 5e3;  // N/m

struct Heap {
    observe::Surface surface;
    double left = 0, right = 0; // deg, both counted downwards from the middle
};

/// How steeply one side falls away from the middle, deg: a robust line through what lies above two layers, so that
/// bodies that rolled away do not count. 0 where too little lies there for a line: the column ran flat.
double flank(const observe::Surface& surface, double side) {
    constexpr std::size_t fewest = 5;
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& point : surface.points)
        if (side * point.x() >= 0 && point.y() > 4 * radius)
            points.push_back(point);
    const std::optional<observe::Line> line = observe::robust_line(points);
    return line && points.size() >= fewest ? -side * degrees * std::atan(line->slope) : 0.0;
}

/// Fills a column between two upright sides, lifts the sides, and looks at what stays.
Result<Heap> let_go(const std::vector<scene::Sphere>& body, double friction, std::uint64_t seed, const Values& values) {
    scene::Scene scene =
        scene::plane_stage(scene::linear_pair(stiffness, 0.8, values["restitution"], friction), time_step);
    scene.seed = seed;
    scene.depth = 0.01;
    scene.gravity = {0, -gravity, 0};
    scene.domain.box = {{-half, -0.05, -0.005}, {half, 1.5, 0.005}};
    scene.materials[0].density = 2500;
    // Half of them smaller: discs of one size would pile up as a crystal, at angles of its own.
    add_body(scene, body);
    std::vector<scene::Sphere> smaller = body;
    for (scene::Sphere& disc : smaller)
        disc = {0.75 * disc.centre, 0.75 * disc.radius};
    add_body(scene, smaller);
    add_wall(scene, scene::Outline(scene::toothed_floor(half, radius)));
    for (const double side : {-column, column}) {
        scene::Wall& wall = add_wall(scene, scene::Outline(scene::SegmentShape{{side, 0.002}, {side, 0.7}}));
        wall.motion.linears.push_back({{.start = settled}, {0, values["lift_m_s"], 0}});
    }
    for (const double side : {-half, half})
        add_wall(scene, scene::Outline(scene::SegmentShape{{0.99 * side, -0.02}, {0.99 * side, 0.5}}));
    scene::Fill fill;
    fill.count = std::llround(0.5 * values["count"]);
    fill.region = {{-column + 0.001, 0.005, -0.005}, {column - 0.001, 0.68, 0.005}};
    scene.fills.push_back(fill);
    fill.body = 1;
    scene.fills.push_back(fill);
    const Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    if (const auto problem = (*world)->advance(std::llround((settled + 0.3 / values["lift_m_s"] + spread) / time_step)))
        return *problem;
    Heap heap;
    heap.surface = observe::free_surface((*world)->frame());
    heap.left = flank(heap.surface, -1);
    heap.right = flank(heap.surface, 1);
    return heap;
}

Result<Outcome> perform(const Values& values) {
    const double mu = values["friction"];
    const std::vector<scene::Sphere> disc{{Eigen::Vector3d::Zero(), radius}};
    struct Case {
        const char* what;
        const char* fact;
        std::vector<scene::Sphere> body;
    };
    const std::array<Case, 2> cases{
        {{"discs", "angle_discs", disc}, {"triangles of discs", "angle_triangles", scene::disc_triangle(radius)}}};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(fmt::format(
        "A column of {:.0f} bodies is let go by lifting its sides at {:.3g} m/s; the slope of what stays is the "
        "angle of repose. It is in no law and has no formula: it is there to calibrate by. Round bodies roll, "
        "so shape, and rolling resistance in its place, count more than friction.",
        values["count"], values["lift_m_s"]));
    sheet::Grid grid{
        {{"bodies"}, {"seed"}, {"left flank", "deg", 3}, {"right flank", "deg", 3}, {"arctan μ", "deg", 3}}};
    sheet::Figure figure{.name = "repose",
                         .title = "What is left of a column that was let go",
                         .x = {"place", "mm"},
                         .y = {"height", "mm"},
                         .curves = {}};
    Recording table{"repose", {"triangles", "seed", "left_deg", "right_deg"}};
    const auto seeds = static_cast<int>(values["seeds"]);
    for (std::size_t c = 0; c < cases.size(); ++c) {
        std::vector<double> angles;
        for (int seed = 1; seed <= seeds; ++seed) {
            const Result<Heap> heap = let_go(cases[c].body, mu, static_cast<std::uint64_t>(seed), values);
            if (!heap)
                return heap.problems();
            grid.rows.push_back(
                {cases[c].what, std::to_string(seed), heap->left, heap->right, degrees * std::atan(mu)});
            table.rows.push_back({static_cast<double>(c), static_cast<double>(seed), heap->left, heap->right});
            angles.push_back(0.5 * (heap->left + heap->right));
            if (seed > 1)
                continue;
            sheet::Curve curve{cases[c].what};
            for (const Eigen::Vector2d& point : heap->surface.points)
                curve.add(1e3 * point.x(), 1e3 * point.y());
            figure.curves.push_back(std::move(curve));
        }
        double mean = 0, square = 0;
        for (const double angle : angles)
            mean += angle / static_cast<double>(angles.size());
        for (const double angle : angles)
            square += std::pow(angle - mean, 2);
        sheet.fact(cases[c].fact, mean, "deg");
        if (seeds > 1)
            sheet.fact(std::string(cases[c].fact) + "_sd", std::sqrt(square / (seeds - 1)), "deg");
    }
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.say(fmt::format(
        "Mean of both flanks and all seeds: {:.3g} deg for discs, {:.3g} deg for triangles. One heap is one draw; "
        "compare means over seeds.",
        sheet.fact("angle_discs"), sheet.fact("angle_triangles")));
    outcome.recordings.push_back(std::move(table));
    return outcome;
}

} // namespace

Experiment repose() {
    return {.name = "repose",
            .title = "Angle of repose: a column that is let go",
            .parameters = {friction_parameter(0.5),
                           {"count", "", 240, {.lo = 20, .hi = 400}, "How many bodies (whole number)"},
                           {"lift_m_s", "m/s", 0.2, {.lo = 0.05, .hi = 5}, "Speed at which the sides rise"},
                           {"seeds", "", 3, {.lo = 1, .hi = 20}, "How many heaps of each kind (whole number)"},
                           restitution_parameter(0.3)},
            .perform = perform};
}

} // namespace tumble::lab
