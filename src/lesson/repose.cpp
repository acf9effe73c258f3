#include "lesson/each.h"
#include "lesson/stage.h"
#include "observe/surface.h"
#include "run/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr double radius = 4e-3;   // m, of discs
constexpr double half = 0.40;     // m, from the middle to either side
constexpr double poured = 1.0;    // s
constexpr double settled = 1.6;   // s
constexpr double dt = 5e-5;       // s
constexpr double stiffness = 5e3; // N/m

constexpr double picture = 0.02; // s, between those of the film

struct Heap {
    observe::Surface surface;
    double angle = 0; // deg, mean of both flanks
    std::vector<observe::Frame> frames;

    [[nodiscard]] double height() const {
        double top = 0;
        for (const Eigen::Vector2d& point : surface.points)
            top = std::max(top, point.y());
        return top;
    }
    /// Straight lines through the points left and right of the middle, from one end of each half to the other.
    [[nodiscard]] std::vector<std::array<Eigen::Vector2d, 2>> flanks() const {
        const auto& points = surface.points;
        const double middle = 0.5 * (points.front().x() + points.back().x());
        std::vector<std::array<Eigen::Vector2d, 2>> lines;
        for (const bool left : {true, false}) {
            std::vector<Eigen::Vector2d> own;
            std::copy_if(points.begin(), points.end(), std::back_inserter(own),
                         [&](const Eigen::Vector2d& point) { return (point.x() < middle) == left; });
            const auto at = [line = observe::robust_line(own).value_or(observe::Line{})](double x) {
                return Eigen::Vector2d(x, line.level + line.slope * x);
            };
            lines.push_back({at(own.front().x()), at(own.back().x())});
        }
        return lines;
    }
};

Result<Heap> pour(const std::vector<scene::Sphere>& body, double friction, double count) {
    scene::Scene scene = plane_stage(linear_pair(stiffness, 0.8, 0.5, friction), dt);
    scene.depth = 0.01;
    scene.gravity = {0, -9.81, 0};
    scene.domain.box = {{-half, -0.05, -0.005}, {half, 0.5, 0.005}};
    scene.materials[0].density = 2500;
    add_body(scene, body);
    add_wall(scene, scene::Outline(scene::toothed_floor(half, radius)));
    for (const double side : {-half, half})
        add_wall(scene, scene::Outline(scene::SegmentShape{{side, -0.02}, {side, 0.5}}));
    scene::Fill fill;
    fill.count = std::llround(count);
    fill.region = {{-0.025, 0.14, -0.005}, {0.025, 0.22, 0.005}};
    fill.velocity = {0, -0.5, 0};
    fill.until = poured;
    fill.every = 0.05;
    scene.fills.push_back(fill);
    const Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    Heap heap;
    for (double time = 0; time < settled + 0.5 * picture; time += picture) {
        if (const auto problem = (*world)->advance(std::llround(time / dt) - (*world)->steps()))
            return *problem;
        heap.frames.push_back((*world)->frame());
    }
    heap.surface = observe::free_surface(heap.frames.back());
    if (heap.surface.points.size() < 6)
        return Problem{.what = "too few bodies lie in the heap to see its slope", .fix = "a larger --count"};
    const bool at_a_wall =
        std::max(-heap.surface.points.front().x(), heap.surface.points.back().x()) > half - 2 * radius;
    if (friction > 0 && at_a_wall)
        return Problem{.what = "the heap runs to a wall, which would hold it up", .fix = "a smaller --count"};
    heap.angle = 0.5 * (observe::surface_slope_left(heap.surface) - observe::surface_slope_right(heap.surface));
    return heap;
}

Result<Walk> teach(const Values& values) {
    const double mu = values["friction"], count = values["count"];
    const std::vector<scene::Sphere> disc{{Eigen::Vector3d::Zero(), radius}};
    struct Case {
        std::string what;
        std::string fact;
        std::vector<scene::Sphere> body;
        double friction;
    };
    const std::vector<Case> cases{
        {"discs, no friction", "angle_smooth", disc, 0},
        {fmt::format("discs, μ = {:.3g}", mu), "angle_discs", disc, mu},
        {fmt::format("wedges, μ = {:.3g}", mu), "angle_wedges", scene::disc_triangle(radius), mu}};
    Walk walk;
    walk.say(fmt::format(
        "{:.0f} bodies fall, a few every twentieth of a second, onto the middle of a rough floor, and what stays is a "
        "heap. Its slope is called the angle of repose. It is nowhere in the scene: it comes out, and there is no "
        "formula for it.",
        count));
    Figure figure{.name = "heaps",
                  .title = "Free surfaces of three heaps, and their flanks",
                  .x = {"place", "mm"},
                  .y = {"height", "mm"},
                  .curves = {},
                  .equal_scales = true};
    Film film{.name = "pouring",
              .title = "Discs and wedges of the same friction",
              .reels = {},
              .every = picture,
              .color = "vy",
              .range = {-1, 1},
              .view = scene::Box{{-0.6 * half, -radius, -0.005}, {0.6 * half, 0.22, 0.005}},
              .poster = std::size_t{18}};
    Grid grid{{{"heap"}, {"angle", "deg", 3}, {"height", "mm", 3}, {"arctan μ", "deg", 3}}, {}};
    for (const Case& one : cases) {
        Result<Heap> heap = pour(one.body, one.friction, count);
        if (!heap)
            return heap.problems();
        Curve curve{one.what, Style::line, {}, {}};
        const std::size_t color = grid.rows.size();
        curve.color = color;
        for (const Eigen::Vector2d& point : heap->surface.points)
            curve.add(1e3 * point.x(), 1e3 * point.y());
        figure.curves.push_back(std::move(curve));
        if (one.friction > 0)
            for (const auto& [from, to] : heap->flanks())
                figure.curves.push_back(
                    {"", Style::dashes, {1e3 * from.x(), 1e3 * to.x()}, {1e3 * from.y(), 1e3 * to.y()}, color});
        grid.rows.push_back(
            {one.what, heap->angle, 1e3 * heap->height(), std::atan(one.friction) * 180 / std::numbers::pi});
        walk.fact(one.fact, heap->angle, "deg");
        if (one.friction > 0)
            film.reels.push_back({one.what, std::move(heap->frames)});
    }
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(figure);
    walk.show(std::move(film));
    walk.say(
        fmt::format("The dashed lines are the flanks whose slopes the table has. Without friction discs run apart to a "
                    "sheet. With it they still roll, so their heap is flat, far below arctan μ, at which a block would "
                    "begin to slide (`tumble lesson friction`). Three discs bound together do not roll so easily; here "
                    "their heap stands {:.2g} times as steep. Friction and shape both raise it: a measured angle of "
                    "repose alone does not tell one from the other.",
                    walk.fact("angle_wedges") / walk.fact("angle_discs")));
    walk.say("These are no material's angles of repose. A slope does not depend on how many grains there are only if "
             "the heap is not too small (thesis, section 3.1.1.5), and these are a few rows high: 600 of the same "
             "discs stand at 16 and 15 deg (scenes/repose-2d.toml). Equal discs lie in rows, which two sizes would "
             "not. And each heap is a sample of one: other fills differ by some degrees. A measurement takes larger "
             "heaps, more sizes and several fills, and gives a mean with its scatter.");
    walk.question = "A code has only single discs, and its heap is too flat beside the experiment. What is often added "
                    "to the law in place of the shape?";
    walk.answer = "A moment that resists rolling. It stands for the corners that a disc does not have, and must be "
                  "fitted. There is no such law here yet; clumps take the shape itself.";
    return walk;
}

} // namespace

Lesson repose() {
    return {.name = "repose",
            .title = "The angle of repose: what nobody typed in",
            .parameters = {{"friction", "", 0.5, {.lo = 0.05, .hi = 1}, "Coulomb's coefficient μ of all contacts"},
                           {"count", "", 120, {.lo = 40, .hi = 200}, "Bodies in a heap"}},
            .teach = teach};
}

} // namespace tumble::lesson
