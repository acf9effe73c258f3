#pragma once

#include "excitation/motion.h"

#include <Eigen/Core>
#include <complex>
#include <vector>

/// What two sensors at different places tell and one cannot: how the body turns.
namespace tumble::excitation {

/// Where the sensors sit (m) and about which axis of the scene (0 x, 1 y, 2 z) the body is taken to rock.
struct Places {
    Eigen::Vector3d first = Eigen::Vector3d::Zero(), second = Eigen::Vector3d::Zero();
    int about = 0;
};

/// A line as the motion of a rigid body: angle Im(angle exp(i 2 pi f (t - reference))) about an axis through the pivot,
/// and what the pivot itself does.
struct Turn {
    double frequency = 0;                                     // Hz
    std::complex<double> angle;                               // rad
    double angle_se = 0;                                      // rad, of either part
    Eigen::Vector3d pivot = Eigen::Vector3d::Zero();          // m, the point that moves least
    double pivot_se = 0;                                      // m
    Eigen::Vector3cd pivot_motion = Eigen::Vector3cd::Zero(); // m, displacement of it
    Eigen::Vector3d motion_se = Eigen::Vector3d::Zero();      // m, standard error of either part of it, per axis
    double misfit = 0, misfit_se = 0;                         // m, of the sensors' difference, what no turning explains
    [[nodiscard]] bool seen() const { return std::abs(angle) > 4 * angle_se; }
};

/// One per line that moves the wall. Problems: the sensors share no axis on which a turn about this axis would show.
Result<std::vector<Turn>> turns_of(const Excitation& found, const std::vector<Channel>& channels, const Places& places);

/// The motion of the wall: rocking where it is seen, and the harmonics of the pivot; else those of the first sensor.
scene::WallMotion motion_of(const std::vector<Turn>& turns, const Places& places, double start);

} // namespace tumble::excitation
