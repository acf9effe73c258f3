#pragma once

#include "scene/scene.h"
#include "sim2d/solver.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

/// Small worlds for tests: one material for everything, the linear law, no gravity unless asked for, as much room as
/// needed, discs 1 m deep.
namespace tumble::sim2d::testing {

using Eigen::Vector2d;
using Eigen::Vector3d;

inline contact::Material stone(double density = 1000) {
    return {"stone", density, 0, 0};
}

/// k_n in N/m, k_s over k_n, restitution, friction.
inline contact::PairProperties springs(double normal, double ratio, double restitution, double friction) {
    contact::PairProperties pair;
    pair.restitution = restitution;
    pair.friction = friction;
    pair.normal_stiffness = normal;
    pair.stiffness_ratio = ratio;
    return pair;
}

struct Sandbox {
    scene::Scene scene;
    WorldPtr world;

    Sandbox(const contact::PairProperties& pair, double dt) {
        scene.title = "sandbox";
        scene.dimension = 2;
        scene.depth = 1;
        scene.gravity = Vector3d::Zero();
        scene.time_step = dt;
        scene.duration = 1;
        scene.allow_large_step = true;
        scene.domain.box = {{-50, -50, -0.5}, {50, 50, 0.5}};
        scene.materials = {stone()};
        scene.pairs = {pair};
        scene.contact.normal = scene::NormalLaw::linear;
        scene.contact.tangential = scene::TangentialLaw::linear;
    }

    int disc(double radius) { return body({{Vector3d::Zero(), radius}}); }

    int body(const std::vector<scene::Sphere>& discs) {
        scene::BodyTemplate shape;
        shape.name = "body" + std::to_string(scene.bodies.size());
        shape.spheres = discs;
        scene.bodies.push_back(shape);
        return static_cast<int>(scene.bodies.size()) - 1;
    }

    scene::Wall& wall(const scene::Outline& outline) {
        scene::Wall wall;
        wall.name = "wall" + std::to_string(scene.walls.size());
        wall.outline = outline;
        scene.walls.push_back(wall);
        return scene.walls.back();
    }

    void build(int threads = 1) {
        auto built = build_world(scene, threads);
        REQUIRE_MESSAGE(built.ok(), to_string(built.problems()));
        world = std::move(*built);
    }

    void put(const std::vector<BodyState>& states) {
        if (!world)
            build();
        const auto problem = insert(*world, states);
        REQUIRE_MESSAGE(!problem, to_string(*problem));
    }

    void step(std::int64_t steps = 1) const {
        const auto problem = advance(*world, steps);
        REQUIRE_MESSAGE(!problem, to_string(*problem));
    }

    [[nodiscard]] BodyState body_at(std::size_t id) const { return bodies_of(*world)[id]; }
    [[nodiscard]] const BodyShape& shape(int index) const { return shapes_of(*world)[static_cast<std::size_t>(index)]; }
};

inline BodyState at(int shape, const Vector2d& position, const Vector2d& velocity = Vector2d::Zero(), double spin = 0) {
    BodyState state;
    state.shape = shape;
    state.position = position;
    state.velocity = velocity;
    state.angular_velocity = spin;
    return state;
}

} // namespace tumble::sim2d::testing
