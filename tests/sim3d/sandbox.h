#pragma once

#include "scene/scene.h"
#include "sim3d/solver.h"

#include <doctest/doctest.h>
#include <vector>

/// Small worlds for tests: one material for everything, no gravity unless asked for, as much room as needed.
namespace tumble::sim3d::testing {

using Eigen::Vector3d;

struct Sandbox {
    scene::Scene scene;
    WorldPtr world;

    Sandbox(const contact::Material& material, const contact::PairProperties& pair, double dt) {
        scene.title = "sandbox";
        scene.gravity = Vector3d::Zero();
        scene.time_step = dt;
        scene.duration = 1;
        scene.allow_large_step = true;
        scene.domain.box = {Vector3d::Constant(-10), Vector3d::Constant(10)};
        scene.materials = {material};
        scene.pairs = {pair};
    }

    /// A second material for walls; `pair` is what the two do to each other.
    int wall_material(const contact::Material& material, const contact::PairProperties& pair) {
        scene.materials.push_back(material);
        scene.pairs = {scene.pairs[0], pair, pair, pair};
        return 1;
    }

    int ball(double radius) { return body({{Vector3d::Zero(), radius}}); }

    int body(const std::vector<scene::Sphere>& spheres) {
        scene::BodyTemplate shape;
        shape.name = "body" + std::to_string(scene.bodies.size());
        shape.spheres = spheres;
        scene.bodies.push_back(shape);
        return static_cast<int>(scene.bodies.size()) - 1;
    }

    scene::Wall& wall(const scene::WallShape& shape, int material = 0) {
        scene::Wall wall;
        wall.name = "wall" + std::to_string(scene.walls.size());
        wall.shape = shape;
        wall.material = material;
        scene.walls.push_back(wall);
        return scene.walls.back();
    }

    void start(const std::vector<BodyState>& bodies, int threads = 1) {
        auto built = build_world(scene, threads);
        REQUIRE_MESSAGE(built.ok(), to_string(built.problems()));
        world = std::move(*built);
        const auto problem = insert(*world, bodies);
        REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    }

    void run(std::int64_t steps) {
        const auto problem = advance(*world, steps);
        REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    }

    [[nodiscard]] BodyState body_now(std::size_t id) const { return bodies_of(*world)[id]; }
};

inline BodyState placed(int shape, const Vector3d& position, const Vector3d& velocity = Vector3d::Zero(),
                        const Vector3d& spin = Vector3d::Zero()) {
    BodyState state;
    state.shape = shape;
    state.position = position;
    state.velocity = velocity;
    state.angular_velocity = spin;
    return state;
}

} // namespace tumble::sim3d::testing
