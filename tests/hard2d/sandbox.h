#pragma once

#include "about.h"
#include "hard2d/solver.h"
#include "scene/scene.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

/// Small worlds for tests: one material for everything, no gravity unless asked for, room of 20 m, discs 1 m deep.
namespace tumble::hard2d::testing {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::about;

constexpr double g = 9.81; // m/s2
/// What Box2D lets things sink into each other, over the smallest radius (units.h).
constexpr double slop = 0.005;

struct Sandbox {
    scene::Scene scene;
    WorldPtr world;

    Sandbox(double restitution, double friction, double dt) {
        scene.title = "sandbox";
        scene.dimension = 2;
        scene.solver = scene::Solver::box2d;
        scene.depth = 1;
        scene.gravity = Vector3d::Zero();
        scene.duration = 1;
        scene.box2d = {.time_step = dt, .velocity_iterations = 20, .position_iterations = 8, .rebound_above = 0};
        scene.domain.box = {{-10, -10, -0.5}, {10, 10, 0.5}};
        scene.materials = {{"stone", 1000, 0, 0}};
        scene.pairs = {pair(restitution, friction)};
    }

    static contact::PairProperties pair(double restitution, double friction) {
        contact::PairProperties pair;
        pair.restitution = restitution;
        pair.friction = friction;
        return pair;
    }

    /// Falls towards (angle 0: down); what rests does not bounce.
    void gravity(double angle = 0) {
        scene.gravity = g * Vector3d(std::sin(angle), -std::cos(angle), 0);
        scene.box2d.rebound_above = 2 * g * scene.box2d.time_step;
    }

    int disc(double radius) { return body({{Vector3d::Zero(), radius}}); }

    int body(const std::vector<scene::Sphere>& discs) {
        scene::BodyTemplate shape;
        shape.name = "body" + std::to_string(scene.bodies.size());
        shape.spheres = discs;
        scene.bodies.push_back(shape);
        return static_cast<int>(scene.bodies.size()) - 1;
    }

    /// Three discs of that radius in a row: it stands on two of them and cannot roll.
    int block(double radius) {
        return body({{{-2 * radius, 0, 0}, radius}, {Vector3d::Zero(), radius}, {{2 * radius, 0, 0}, radius}});
    }

    scene::Wall& wall(const scene::Outline& outline) {
        scene::Wall wall;
        wall.name = "wall" + std::to_string(scene.walls.size());
        wall.outline = outline;
        scene.walls.push_back(wall);
        return scene.walls.back();
    }
    scene::Wall& floor() { return wall(scene::SegmentShape{{-9, 0}, {9, 0}}); }

    void build() {
        auto built = build_world(scene);
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
    /// As many steps as come nearest to that time, s.
    void run_for(double time) const { step(std::llround(time / scene.box2d.time_step)); }

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

} // namespace tumble::hard2d::testing
