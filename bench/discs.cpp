// 10,000 discs in dense flow down a slope of 18 degrees, periodic along it.
#include "base/rng.h"
#include "sim2d/solver.h"
#include "support/arguments.h"
#include "support/media.h"
#include "support/report.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

using namespace tumble;

namespace {

constexpr double radius = 1e-3; // m, of the middle of three sizes
constexpr int columns = 200;
constexpr int layers = 50;
constexpr double spacing = 2.2 * radius; // of the start's lattice

scene::Scene slope() {
    scene::Scene scene;
    scene.title = "bench";
    scene.dimension = 2;
    scene.depth = 0.01;
    scene.duration = 1e9;
    const double angle = 18 * std::numbers::pi / 180;
    scene.gravity = 9.81 * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0);
    scene.domain.box = {{0, -radius, -0.005}, {columns * spacing, 2 * layers * spacing, 0.005}};
    scene.domain.periodic = {true, false, false};
    scene.materials = {{"glass", 2500, 0, 0}};
    contact::PairProperties pair;
    pair.restitution = 0.6;
    pair.friction = 0.4;
    pair.normal_stiffness = 1e4;
    pair.stiffness_ratio = 0.7;
    scene.pairs = {pair};
    scene.contact.normal = scene::NormalLaw::linear;
    scene.contact.tangential = scene::TangentialLaw::linear;
    for (const double size : {0.9, 1.0, 1.1}) {
        scene::BodyTemplate disc;
        disc.name = "disc";
        disc.spheres = {{Eigen::Vector3d::Zero(), size * radius}};
        scene.bodies.push_back(disc);
    }
    // A floor of teeth, so that the lowest layer cannot slide off as a whole.
    scene::PolylineShape teeth;
    for (int k = 0; k <= 2 * columns; ++k)
        teeth.points.emplace_back(0.5 * k * spacing, k % 2 == 0 ? 0 : -0.5 * radius);
    scene::Wall floor;
    floor.name = "floor";
    floor.outline = teeth;
    scene.walls = {floor};
    return scene;
}

std::vector<sim2d::BodyState> lattice() {
    Rng rng(1);
    std::vector<sim2d::BodyState> bodies;
    for (int layer = 0; layer < layers; ++layer)
        for (int column = 0; column < columns; ++column) {
            sim2d::BodyState body;
            body.shape = static_cast<int>(rng.uniform(0, 3));
            body.position = {(column + 0.5 * (layer % 2)) * spacing, (layer + 0.6) * spacing};
            body.velocity = {rng.uniform(-0.01, 0.01) + 0.01 * layer, rng.uniform(-0.01, 0.01)};
            bodies.push_back(body);
        }
    return bodies;
}

/// What flows, so that a rate can be believed: a loose or a slowing bed is quick to simulate.
struct Flow {
    double solid_fraction = 0; // by centres, from 20 to 60 mm above the floor
    double coordination = 0;   // contacts seen from both sides, per disc
    double speed = 0;          // m/s, mean down the slope

    explicit Flow(const sim2d::World& world) {
        constexpr double lo = 0.02, hi = 0.06; // m
        const auto bodies = sim2d::bodies_of(world);
        const auto& shapes = sim2d::shapes_of(world);
        double area = 0;
        for (const sim2d::BodyState& body : bodies) {
            const double r = shapes[static_cast<std::size_t>(body.shape)].discs.front().radius;
            area += body.position.y() > lo && body.position.y() < hi ? std::numbers::pi * r * r : 0;
            speed += body.velocity.x() / static_cast<double>(bodies.size());
        }
        solid_fraction = area / ((hi - lo) * columns * spacing);
        coordination = 2 * static_cast<double>(sim2d::books_of(world).contacts) / static_cast<double>(bodies.size());
    }
};

void print_flow(const Flow& before, const Flow& after) {
    fmt::print(R"({{"solid_fraction": [{:.3f}, {:.3f}], "coordination": [{:.3f}, {:.3f}], )"
               R"("speed_m_s": [{:.4g}, {:.4g}]}})"
               "\n",
               before.solid_fraction, after.solid_fraction, before.coordination, after.coordination, before.speed,
               after.speed);
}

} // namespace

/// threads=1 dt=1e-5 skin=0 pre=20000 blocks=1 steps=10000
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    scene::Scene scene = slope();
    scene.time_step = arguments.number("dt", 1e-5);
    scene.skin = arguments.number("skin", 0);
    const auto threads = static_cast<int>(arguments.whole("threads", 1));
    const auto pre = arguments.whole("pre", 20000), blocks = arguments.whole("blocks", 1);
    const auto steps = arguments.whole("steps", 10000);
    arguments.finish();

    const sim2d::WorldPtr world = bench::value_or_refuse(sim2d::build_world(scene, threads));
    if (const auto problem = sim2d::insert(*world, lattice()))
        bench::refuse(to_string(*problem));
    bench::advance_or_refuse(*world, pre);
    const Flow before(*world);
    bench::timed_blocks(*world, "flow", blocks, steps);
    print_flow(before, Flow(*world));
    bench::print_summary(*world);
}
