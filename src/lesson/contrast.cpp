#include "lesson/contrast.h"

#include "run/simulation.h"

#include <algorithm>
#include <cmath>

namespace tumble::lesson::contrast {

namespace {

/// Steps to the end; `look` sees every frame, the first included.
template <class Look> Result<run::SimulationPtr> watch(const scene::Scene& scene, double until, Look&& look) {
    Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    look((*world)->frame());
    while ((*world)->time() < until) {
        if (const auto problem = (*world)->advance(1))
            return *problem;
        look((*world)->frame());
    }
    return world;
}

} // namespace

scene::Scene hard(scene::Scene scene) {
    scene.solver = scene::Solver::box2d;
    return scene;
}

std::vector<scene::Sphere> raft(int discs) {
    std::vector<scene::Sphere> parts;
    for (int k = 0; k < discs; ++k)
        parts.push_back({{2 * radius * (k - 0.5 * (discs - 1)), 0, 0}, radius});
    return parts;
}

Result<Push> strike(scene::Scene scene, const std::vector<scene::Sphere>& parts, double speed) {
    add_body(scene, parts);
    scene.bodies.back().mass = mass;
    add_wall(scene, scene::Outline(scene::SegmentShape{{-1, 0}, {1, 0}}));
    // From so high that the first touch falls into the middle of a step of Box2D.
    const double height = radius + 2.5 * speed * hard_step;
    put(scene, 0, {0, height}, {0, -speed});
    Push push;
    const double dt = scene.step(), touch = 2.5 * hard_step;
    // Of springs the velocity in the middle of each step: what a frame tells is reckoned ahead from there.
    double before = -speed, place = height + speed * dt;
    const auto look = [&](const observe::Frame& frame) {
        const double y = frame.position[0].y(), middle = (y - place) / dt;
        const double now = scene.solver == scene::Solver::box2d ? frame.velocity[0].y() : middle;
        const double force = mass * (now - before) / dt;
        before = now;
        place = y;
        push.time.push_back(frame.time - touch);
        push.force.push_back(force);
        push.deepest = std::max(push.deepest, radius - frame.position[0].y());
        push.strongest = std::max(push.strongest, force);
        push.lasted += std::abs(force) > 1e-6 ? dt : 0;
        push.restitution = now / speed;
    };
    const Result<run::SimulationPtr> world = watch(scene, touch + 4 * hard_step, look);
    if (!world)
        return world.problems();
    return push;
}

Result<std::array<double, 3>> cradle(scene::Scene scene, double speed, double gap) {
    scene.pairs[0].restitution = 1;
    scene.pairs[0].friction = 0;
    add_round(scene, radius, mass);
    put(scene, 0, {0, 0}, {0, 0});
    put(scene, 0, {2 * radius + gap, 0}, {0, 0});
    put(scene, 0, {-2 * radius - 2.5 * speed * hard_step, 0}, {speed, 0});
    std::array<double, 3> after{};
    const auto look = [&](const observe::Frame& frame) {
        after = {frame.velocity[2].x() / speed, frame.velocity[0].x() / speed, frame.velocity[1].x() / speed};
    };
    const Result<run::SimulationPtr> world = watch(scene, 0.02, look);
    if (!world)
        return world.problems();
    return after;
}

Result<double> slides(scene::Scene scene, double mu, double speed) {
    scene.gravity = {0, -g, 0};
    scene.box2d.rebound_above = 2 * g * hard_step;
    scene.pairs[0].restitution = 0.1;
    add_body(scene, raft(3));
    scene.bodies.back().mass = mass;
    add_wall(scene, scene::Outline(scene::SegmentShape{{-1, 0}, {50, 0}}));
    put(scene, 0, {0, radius * (1 + 1e-6)}, {speed, 0});
    double way = 0;
    const Result<run::SimulationPtr> world =
        watch(scene, 1.1 * speed / (mu * g), [&](const observe::Frame& frame) { way = frame.position[0].x(); });
    if (!world)
        return world.problems();
    return way;
}

Result<double> sunk(scene::Scene scene) {
    scene.gravity = {0, -g, 0};
    scene.box2d.rebound_above = 2 * g * hard_step;
    scene.pairs[0].restitution = 0.1; // comes to rest soon
    scene.pairs[0].friction = 0;
    scene.time_step *= 4; // nothing strikes
    add_round(scene, radius, mass);
    add_wall(scene, scene::Outline(scene::SegmentShape{{-1, 0}, {1, 0}}));
    for (const double side : {-1.001, 1.001})
        add_wall(scene, scene::Outline(scene::SegmentShape{{side * radius, 0}, {side * radius, 1}}));
    for (int k = 0; k < stacked; ++k)
        put(scene, 0, {0, (2 * k + 1) * radius * (1 + 1e-6)}, {0, 0});
    Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    if (const auto problem = (*world)->advance(std::llround(1.5 / scene.step())))
        return *problem;
    return (2 * stacked - 1) * radius - (*world)->frame().position[stacked - 1].y();
}

scene::Scene pour(scene::Scene scene) {
    scene.gravity = {0, -g, 0};
    scene.box2d.rebound_above = 2 * g * hard_step;
    scene.time_step *= steps_a_contact / 40; // enough for a heap
    scene.domain.box = {{-0.2, -0.05, -0.5}, {0.2, 0.6, 0.5}};
    add_round(scene, radius, mass);
    add_wall(scene, scene::Outline(scene::BoxShape{.box = {{-0.12, 0, -1}, {0.12, 0.5, 1}}, .open = {}}));
    scene::Fill& fill = scene.fills.emplace_back();
    fill.count = 80;
    fill.region = {{-0.1, 0.02, -0.5}, {0.1, 0.48, 0.5}};
    return scene;
}

Result<Poured> watch_pour(const scene::Scene& scene, const std::string& label, double passes_a_step) {
    Poured seen{{label, Style::line, {}, {}}, 0, 0, 0};
    Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    constexpr int looks = 300;
    for (int k = 1; k <= looks; ++k) {
        const std::int64_t until = std::llround(poured_for * k / looks / scene.step());
        const std::int64_t steps = until - (*world)->steps();
        if (const auto problem = (*world)->advance(steps))
            return *problem;
        const Books books = (*world)->books();
        seen.energy.add((*world)->time(), 1e3 * (books.kinetic_translation + books.kinetic_rotation));
        seen.passes += static_cast<double>(steps * books.contacts) * passes_a_step;
    }
    seen.steps = (*world)->steps();
    const observe::Frame frame = (*world)->frame();
    for (const Eigen::Vector3d& position : frame.position)
        seen.height += position.y() / static_cast<double>(frame.position.size());
    return seen;
}

} // namespace tumble::lesson::contrast
