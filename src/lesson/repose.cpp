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
#include <numeric>

namespace tumble::lesson {

namespace {

constexpr std::array<double, 2> radii{3.5e-3, 4.5e-3}; // m, of discs: equal ones would lie in rows
constexpr double half = 0.50;                          // m, from the middle to either side
constexpr double settling = 1.0;                       // s, after the last bodies
constexpr double batch = 0.05;                         // s, between bodies that come in
constexpr double bodies_a_batch = 24;                  // fewer than fit
constexpr double dt = 5e-5;                            // s
constexpr double stiffness = 5e3;                      // N/m
constexpr double picture = 0.04;                       // s, between those of the film
constexpr int fills = 3;                               // of each kind
constexpr double stretch = 2.5;                        // of heights, in the figure

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

/// What is poured: half of the bodies of either size.
struct Kind {
    std::string name;
    std::string fact;
    std::array<std::vector<scene::Sphere>, 2> bodies;
    double friction = 0;
};

/// s, until the last bodies come in.
double poured(double count) {
    return batch * std::ceil(count / bodies_a_batch);
}

scene::Scene pouring(const Kind& kind, double count, int seed) {
    scene::Scene scene = plane_stage(linear_pair(stiffness, 0.8, 0.5, kind.friction), dt);
    scene.seed = static_cast<std::uint64_t>(seed);
    scene.depth = 0.01;
    scene.gravity = {0, -9.81, 0};
    scene.domain.box = {{-half, -0.05, -0.005}, {half, 0.5, 0.005}};
    scene.materials[0].density = 2500;
    add_wall(scene, scene::Outline(scene::toothed_floor(half, radii[1])));
    for (const double side : {-half, half})
        add_wall(scene, scene::Outline(scene::SegmentShape{{side, -0.02}, {side, 0.5}}));
    for (const std::size_t size : {0, 1}) {
        scene::Fill fill;
        fill.body = add_body(scene, kind.bodies[size]);
        const std::int64_t all = std::llround(count), smaller = all / 2;
        fill.count = size == 0 ? smaller : all - smaller;
        const double low = size == 0 ? 0.16 : 0.20; // m, a region for each size, so that both come at once
        fill.region = {{-0.025, low, -0.005}, {0.025, low + 0.04, 0.005}};
        fill.velocity = {0, -0.5, 0};
        fill.until = poured(count);
        fill.every = batch;
        scene.fills.push_back(fill);
    }
    scene.duration = poured(count) + settling;
    return scene;
}

Result<Heap> pour(const Kind& kind, double count, int seed) {
    const scene::Scene scene = pouring(kind, count, seed);
    Result<Reel> reel = film(scene, kind.name, scene.duration, picture);
    if (!reel)
        return reel.problems();
    Heap heap;
    heap.frames = std::move(reel->frames);
    if (heap.frames.back().time < scene.duration - picture)
        return Problem{.what = fmt::format("the solver stopped at t = {:.3g} s", heap.frames.back().time),
                       .fix = "a smaller --count"};
    heap.surface = observe::free_surface(heap.frames.back());
    if (heap.surface.points.size() < 6)
        return Problem{.what = "too few bodies lie in the heap to see its slope", .fix = "a larger --count"};
    const double reach = std::max(-heap.surface.points.front().x(), heap.surface.points.back().x());
    if (kind.friction > 0 && reach > half - 2 * radii[1])
        return Problem{.what = "the heap runs to a wall, which would hold it up", .fix = "a smaller --count"};
    heap.angle = 0.5 * (observe::surface_slope_left(heap.surface) - observe::surface_slope_right(heap.surface));
    return heap;
}

/// The free surface and the flanks.
void draw(const Heap& heap, const Kind& kind, std::size_t color, Figure& figure) {
    Curve curve{kind.name, Style::line, {}, {}, color};
    for (const Eigen::Vector2d& point : heap.surface.points)
        curve.add(1e3 * point.x(), 1e3 * point.y());
    figure.curves.push_back(std::move(curve));
    if (kind.friction == 0)
        return; // no heap, as the page says
    for (const auto& [from, to] : heap.flanks())
        figure.curves.push_back(
            {"", Style::dashes, {1e3 * from.x(), 1e3 * to.x()}, {1e3 * from.y(), 1e3 * to.y()}, color});
}

std::vector<Kind> kinds_of(double mu) {
    const auto each = [](auto&& body) { return std::array{body(radii[0]), body(radii[1])}; };
    const auto disc = [](double radius) { return std::vector<scene::Sphere>{{Eigen::Vector3d::Zero(), radius}}; };
    return {{"discs, no friction", "angle_smooth", each(disc), 0},
            {fmt::format("discs, μ = {:.3g}", mu), "angle_discs", each(disc), mu},
            {fmt::format("wedges, μ = {:.3g}", mu), "angle_wedges", each(scene::disc_triangle), mu}};
}

Result<Walk> teach(const Values& values) {
    const double mu = values["friction"], count = values["count"];
    Walk walk;
    walk.say(fmt::format("{:.0f} bodies fall, some every twentieth of a second, onto the middle of a rough floor, and "
                         "what stays is a heap. Its slope is called the angle of repose. It is nowhere in the scene: "
                         "it comes out, and there is no formula for it. Half of the bodies are 0.78 times as large as "
                         "the others, since equal ones would lie in rows.",
                         count));
    Figure figure{.name = "heaps",
                  .title = fmt::format("The first heap of each kind and its flanks, heights drawn {} times as large",
                                       scene::plain(stretch)),
                  .x = {"place", "mm"},
                  .y = {"height", "mm"},
                  .curves = {},
                  .stretch = stretch};
    Film film{.name = "pouring",
              .title = "Discs and wedges of the same friction",
              .reels = {},
              .every = picture,
              .color = "vy",
              .range = {-1, 1},
              .view = scene::Box{{-0.8 * half, -2 * radii[1], -0.005}, {0.8 * half, 0.16, 0.005}},
              .poster = static_cast<std::size_t>(0.8 * poured(count) / picture)};
    Grid grid{{{"heap"},
               {"angle, mean of 3", "deg", 3},
               {"from", "deg", 3},
               {"to", "deg", 3},
               {"height", "mm", 3},
               {"arctan μ", "deg", 3}},
              {}};
    for (const Kind& kind : kinds_of(mu)) {
        std::vector<double> angles, heights;
        for (int seed = 1; seed <= fills; ++seed) {
            Result<Heap> heap = pour(kind, count, seed);
            if (!heap)
                return heap.problems();
            angles.push_back(heap->angle);
            heights.push_back(1e3 * heap->height());
            if (seed > 1)
                continue;
            draw(*heap, kind, grid.rows.size(), figure);
            if (kind.friction > 0)
                film.reels.push_back({kind.name, std::move(heap->frames)});
        }
        const auto mean = [](const std::vector<double>& of) {
            return std::accumulate(of.begin(), of.end(), 0.0) / fills;
        };
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        grid.rows.push_back(
            {kind.name, mean(angles), *low, *high, mean(heights), std::atan(kind.friction) * 180 / std::numbers::pi});
        walk.fact(kind.fact, mean(angles), "deg");
        walk.fact(kind.fact + "_scatter", *high - *low, "deg");
    }
    walk.parts.emplace_back(grid);
    walk.parts.emplace_back(figure);
    walk.show(std::move(film));
    const double slides_at = std::atan(mu) * 180 / std::numbers::pi;
    const double scatter = std::max(walk.fact("angle_discs_scatter"), walk.fact("angle_wedges_scatter"));
    const bool apart = walk.fact("angle_wedges") - walk.fact("angle_discs") > scatter;
    walk.say(fmt::format(
        "The dashed lines are the flanks whose slopes the table has. Without friction there is no heap: what lies in a "
        "hollow has to climb before it runs, so that the bodies do not lie flat, but how steep depends on how many "
        "they "
        "are and on the room they have. {} {}",
        walk.fact("angle_discs") < slides_at
            ? "With it discs still roll, so their heap stays below arctan μ, at which a block would begin to slide "
              "(`tumble lesson friction`)."
            : "So little friction leaves the discs' heap steeper than arctan μ, at which a block would begin to slide "
              "(`tumble lesson friction`): hollows hold more than friction does, and arctan μ bounds nothing.",
        apart ? fmt::format(
                    "Three discs bound together do not roll so easily; here their heap stands {:.2g} times as steep. "
                    "Friction and shape both raise it: a measured angle of repose alone does not tell one from the "
                    "other.",
                    walk.fact("angle_wedges") / walk.fact("angle_discs"))
              : "Three discs bound together do not roll so easily, but between fills the heaps differ by as much as "
                "discs and wedges do: so few heaps, or so few bodies, do not show it."));
    walk.say(fmt::format(
        "Three fills that differ in nothing but where their bodies begin differ by as much as the table's columns "
        "from and to are apart: one heap is a sample of one. A slope does not depend on how many grains there "
        "are only if the heap is not too small (thesis, section 3.1.1.5){}. Nor is it a number of the material alone: "
        "`scenes/repose-2d.toml` pours stiffer discs, half as many a second, from higher up and with a friction of "
        "0.5, and "
        "gets 14 degrees.",
        count > 150 ? ": try `--count 100`, whose heaps are a few rows high" : ""));
    walk.question = "A code has only single discs, and its heap is too flat beside the experiment. What is often added "
                    "to the law in place of the shape?";
    walk.answer = "A moment that resists rolling. It stands for the corners that a disc does not have, and must be "
                  "fitted: `rolling = \"epsd\"` in a scene (`tumble lesson rolling-resistance`). Clumps take the shape "
                  "itself.";
    return walk;
}

} // namespace

Lesson repose() {
    return {.name = "repose",
            .title = "The angle of repose: what nobody typed in",
            .parameters = {{"friction", "", 0.5, {.lo = 0.05, .hi = 1}, "Coulomb's coefficient μ of all contacts"},
                           {"count", "", 500, {.lo = 60, .hi = 800}, "Bodies in a heap", true}},
            .teach = teach};
}

} // namespace tumble::lesson
