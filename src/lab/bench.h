#pragma once

#include "base/problem.h"
#include "scene/stage.h"
#include "sheet/parameter.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

/// The bench that every experiment stands on.
namespace tumble::lab {

constexpr double gravity = 9.81;                         // m/s2, of scenes that say nothing else
constexpr double degrees = 180 / 3.14159265358979323846; // per rad

/// Parameters that most experiments take, with the thesis' media as defaults: material, restitution, friction.
sheet::Parameter density_parameter();
sheet::Parameter modulus_parameter(double standard = 4.6e7);
sheet::Parameter poisson_parameter();
sheet::Parameter restitution_parameter(double standard = 0.67);
sheet::Parameter friction_parameter(double standard = 0.58);
/// Of a sphere, by default as scenes have it (scene/keys_world.cpp, air.drag_coefficient).
sheet::Parameter drag_parameter();

/// Spheres of one material under gravity; a step of that share of the Rayleigh time of a sphere of that radius (m).
/// 5 % is right for what rests and slides; impacts and strong damping want less.
scene::Scene bench(const contact::Material& material, const contact::PairProperties& pair, double radius,
                   double share = 0.05);

/// A plane through a point, its free side towards `normal`.
scene::Wall& add_plane(scene::Scene& scene, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// Three equal spheres on a circle about y, far enough apart for the tripod to slide down 60 degrees without tipping.
std::vector<scene::Sphere> tripod(double radius);
constexpr double tripod_reach = 5; // radii, from the middle to a foot's centre

/// One body at one instant.
struct Seen {
    double time = 0;                                    // s
    Eigen::Vector3d position = Eigen::Vector3d::Zero(); // m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); // m/s
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();     // rad/s
    double wall_angle = 0;                              // rad, of the first wall about z
    Eigen::Vector3d wall = Eigen::Vector3d::Zero();     // m, how far it has moved
};
using Track = std::vector<Seen>;

/// Runs the scene and looks at its first body every `every` seconds, at the start too, until `duration` or until
/// `enough` says so.
Result<Track> watch(const scene::Scene& scene, double duration, double every,
                    const std::function<bool(const Track&)>& enough = {});

/// The straight line through points by least squares, with the standard error of its slope.
struct Line {
    double slope = 0, intercept = 0, slope_se = 0;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

/// Which law of slowing makes a record straight: rate' constant (dry friction), as the rate (a viscous film), as its
/// square (air). `symbol` stands for the rate, which is above 0 throughout.
struct Slowing {
    sheet::Grid grid;
    std::string best;
};
Slowing slowing_of(const std::vector<double>& time, const std::vector<double>& rate, const std::string& symbol);

} // namespace tumble::lab
