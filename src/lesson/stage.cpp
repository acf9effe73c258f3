#include "lesson/stage.h"

#include "run/simulation.h"

#include <cmath>

namespace tumble::lesson {

namespace {

constexpr double room = 100; // m, from the origin to every side of the domain

scene::Scene stage(const contact::Material& material, const contact::PairProperties& pair, double time_step) {
    scene::Scene scene;
    scene.title = "lesson";
    scene.gravity = Eigen::Vector3d::Zero();
    scene.time_step = time_step;
    scene.duration = 1;
    scene.allow_large_step = true; // a lesson about too long a step needs it
    scene.domain.box = {Eigen::Vector3d::Constant(-room), Eigen::Vector3d::Constant(room)};
    scene.materials = {material};
    scene.pairs = {pair};
    return scene;
}

template <class WorldPtr, class State>
Result<WorldPtr> with_bodies(Result<WorldPtr> world, const std::vector<State>& bodies) {
    if (world)
        if (const auto problem = insert(**world, bodies))
            return *problem;
    return world;
}

} // namespace

scene::Scene plane_stage(const contact::PairProperties& pair, double time_step) {
    scene::Scene scene = stage({"stone", 1000, 0, 0}, pair, time_step);
    scene.dimension = 2;
    scene.depth = 1;
    scene.domain.box.lo.z() = -0.5;
    scene.domain.box.hi.z() = 0.5;
    scene.contact.normal = scene::NormalLaw::linear;
    scene.contact.tangential = scene::TangentialLaw::linear;
    return scene;
}

scene::Scene space_stage(const contact::Material& material, const contact::PairProperties& pair, double time_step) {
    return stage(material, pair, time_step);
}

int add_body(scene::Scene& scene, const std::vector<scene::Sphere>& parts) {
    scene::BodyTemplate body;
    body.name = "body" + std::to_string(scene.bodies.size());
    body.spheres = parts;
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
}

int add_round(scene::Scene& scene, double radius) {
    return add_body(scene, {{Eigen::Vector3d::Zero(), radius}});
}

int add_round(scene::Scene& scene, double radius, double mass) {
    const int body = add_round(scene, radius);
    scene.bodies.back().mass = mass;
    return body;
}

scene::Wall& add_wall(scene::Scene& scene, const scene::Outline& outline) {
    scene.walls.emplace_back();
    scene.walls.back().name = "wall" + std::to_string(scene.walls.size());
    scene.walls.back().outline = outline;
    return scene.walls.back();
}

scene::Wall& add_wall(scene::Scene& scene, const scene::WallShape& shape) {
    scene.walls.emplace_back();
    scene.walls.back().name = "wall" + std::to_string(scene.walls.size());
    scene.walls.back().shape = shape;
    return scene.walls.back();
}

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

contact::PairProperties linear_pair(double stiffness, double ratio, double restitution, double friction) {
    contact::PairProperties pair;
    pair.normal_stiffness = stiffness;
    pair.stiffness_ratio = ratio;
    pair.restitution = restitution;
    pair.friction = friction;
    return pair;
}

} // namespace tumble::lesson
