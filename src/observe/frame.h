#pragma once

#include "base/problem.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tumble::observe {

/// Spheres or discs of a body template, relative to the body's centre of mass, in its principal frame. Metres.
struct FrameShape {
    std::string name;
    double mass = 0;                                   // kg
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero(); // kg m2, principal
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
};

/// Triangles of a wall in its own frame, or lines in two dimensions, metres; a frame's WallPlace puts them into the
/// world.
struct FrameWall {
    std::string name;
    double opacity = 0.25;
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> lines{};
};

/// What does not change between the frames of a run.
struct FrameLayout {
    std::string title;
    int dimension = 3; // 2: discs, which lie in the plane z = 0 and turn about z
    std::vector<FrameShape> shapes;
    std::vector<FrameWall> walls;
    Eigen::Vector3d domain_lo = Eigen::Vector3d::Zero(); // m
    Eigen::Vector3d domain_hi = Eigen::Vector3d::Zero(); // m
    std::array<bool, 3> periodic{};
};

struct WallPlace {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();      // m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();         // m/s, of the local origin
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(); // rad/s
};

/// A place where a body touches another body, or a wall. In two dimensions every z is 0.
struct FrameContact {
    std::int64_t a = 0;                               // id
    std::int64_t b = -1;                              // id of the other body; -1: it is a wall
    int wall = -1;                                    // index into layout->walls; -1: it is a body
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  // m, where a is (b may be seen through a periodic side)
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // unit, towards a
    Eigen::Vector3d force = Eigen::Vector3d::Zero();  // N, on a

    /// N, above 0: pressed.
    [[nodiscard]] double pressing() const { return force.dot(normal); }
};

/// One instant of a run: all that pictures, measures and exports need, and nothing that can disturb the solver.
struct Frame {
    std::shared_ptr<const FrameLayout> layout;
    double time = 0; // s
    std::int64_t step = 0;
    std::vector<std::int64_t> id;                  // per body, constant over the run
    std::vector<int> shape;                        // index into layout->shapes
    std::vector<Eigen::Vector3d> position;         // m, centre of mass
    std::vector<Eigen::Quaterniond> orientation;   // principal frame to world
    std::vector<Eigen::Vector3d> velocity;         // m/s
    std::vector<Eigen::Vector3d> angular_velocity; // rad/s, world frame
    std::vector<WallPlace> walls;                  // parallel to layout->walls
    // Those of the last step taken, one step before `time`. Nothing where nobody asked for them: observe.contacts.
    std::optional<std::vector<FrameContact>> contacts;

    [[nodiscard]] std::size_t bodies() const { return position.size(); }
};

} // namespace tumble::observe
