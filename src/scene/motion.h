#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

namespace tumble::scene {

/// When a part of a motion acts, s. Before start it contributes nothing; after stop it holds what it had reached.
struct Active {
    double start = 0;
    double stop = std::numeric_limits<double>::infinity();
};

/// Displacement amplitude * (sin(2 pi (f t + drift t^2 / 2) + phase) - sin(phase)) along one axis, t since the start:
/// no jump there.
struct Harmonic {
    Active active;
    int axis = 1;         // 0 x, 1 y, 2 z
    double amplitude = 0; // m
    double frequency = 0; // Hz
    double phase = 0;     // rad
    double drift = 0;     // Hz/s, of the frequency, which is `frequency` at the start
};

/// Constant angular velocity about an axis through a point.
struct Rotation {
    Active active;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // m
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  // unit vector
    double angular_velocity = 0;                      // rad/s
};

/// Harmonic angle about an axis through a point, written as Harmonic is.
struct Rocking {
    Active active;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // m
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  // unit vector
    double amplitude = 0;                             // rad
    double frequency = 0;                             // Hz
    double phase = 0;                                 // rad
    double drift = 0;                                 // Hz/s
};

/// Constant velocity.
struct Linear {
    Active active;
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); // m/s
};

/// Measured displacement, linear between its rows; the time column counts from active.start.
struct MotionTable {
    Active active;
    std::vector<double> time;                  // s, strictly increasing, first is 0
    std::vector<Eigen::Vector3d> displacement; // m, same length as time
};

/// All parts superpose: rotations and rockings first, in the order written, about points of the unmoved wall; then the
/// sum of all displacements. A pure function of time: position and surface velocity come from the same expression.
struct WallMotion {
    std::vector<Harmonic> harmonics;
    std::vector<Rotation> rotations;
    std::vector<Rocking> rockings;
    std::vector<Linear> linears;
    std::vector<MotionTable> tables;

    [[nodiscard]] bool at_rest() const {
        return harmonics.empty() && rotations.empty() && rockings.empty() && linears.empty() && tables.empty();
    }
};

/// Rigid pose of a wall and its rate: world = rotation * local + translation.
struct WallPose {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();      // m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();         // m/s, of the point that was the local origin
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(); // rad/s

    /// Velocity of the wall's material point now at `world`, m/s.
    [[nodiscard]] Eigen::Vector3d velocity_at(const Eigen::Vector3d& world) const {
        return velocity + angular_velocity.cross(world - translation);
    }
};

/// Pose at time t (s), exact to rounding however many steps came before.
WallPose pose_at(const WallMotion& motion, double t);

/// How far a frequency may drift, over what it was: `speed_bound` counts on it, and scenes are held to it.
constexpr double most_drift = 1;

/// Hz, the highest that the frequency of a Harmonic or a Rocking may come to.
template <class Wave> double top_frequency(const Wave& wave) {
    return wave.drift > 0 ? (1 + most_drift) * wave.frequency : wave.frequency;
}

/// The fastest any point within `reach` (m) of `about` can ever move, m/s; 0 for a wall at rest.
double speed_bound(const WallMotion& motion, const Eigen::Vector3d& about, double reach);

} // namespace tumble::scene
