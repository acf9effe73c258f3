#include "lesson/stage.h"

#include "run/simulation.h"

#include <cmath>

namespace tumble::lesson {

namespace {

template <class WorldPtr, class State>
Result<WorldPtr> with_bodies(Result<WorldPtr> world, const std::vector<State>& bodies) {
    if (world)
        if (const auto problem = insert(**world, bodies))
            return *problem;
    return world;
}

} // namespace

Result<sim2d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim2d::BodyState>& bodies) {
    return with_bodies(sim2d::build_world(scene, 1), bodies);
}

Result<sim3d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim3d::BodyState>& bodies) {
    return with_bodies(sim3d::build_world(scene, 1), bodies);
}

void put(scene::Scene& scene, int body, const Eigen::Vector2d& position, const Eigen::Vector2d& velocity) {
    scene::Fill& fill = scene.fills.emplace_back();
    fill.body = body;
    fill.count = 1;
    fill.orientation = scene::Orientation::as_written;
    fill.position = Eigen::Vector3d(position.x(), position.y(), 0);
    fill.velocity = {velocity.x(), velocity.y(), 0};
}

double one_digit(double time) {
    const double power = std::pow(10, std::floor(std::log10(time)));
    return std::ceil(time / power) * power;
}

Result<Reel> film(const scene::Scene& scene, const std::string& label, double until, double every) {
    const Result<run::SimulationPtr> world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    Reel reel{label, {(*world)->frame()}};
    const auto pictures = static_cast<int>(std::lround(until / every));
    for (int k = 1; k <= pictures; ++k) {
        const std::int64_t to = std::llround(k * every / scene.step());
        if ((*world)->advance(to - (*world)->steps()))
            break;
        reel.frames.push_back((*world)->frame());
    }
    return reel;
}

} // namespace tumble::lesson
