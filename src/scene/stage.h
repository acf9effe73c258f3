#pragma once

#include "scene/scene.h"

#include <vector>

/// Small scenes for lessons and experiments, put together without a file: one material for everything, no gravity
/// unless asked for, as much room as needed.
namespace tumble::scene {

/// Discs 1 m deep under the linear law.
Scene plane_stage(const contact::PairProperties& pair, double time_step);

/// Spheres under the law of Hertz and Mindlin.
Scene space_stage(const contact::Material& material, const contact::PairProperties& pair, double time_step);

/// Adds a template and returns its index.
int add_body(Scene& scene, const std::vector<Sphere>& parts);
/// One disc or sphere; with a mass given (kg) density does not count.
int add_round(Scene& scene, double radius);
int add_round(Scene& scene, double radius, double mass);

Wall& add_wall(Scene& scene, const Outline& outline);
Wall& add_wall(Scene& scene, const WallShape& shape);

/// One body of that template at t = 0, its centre of mass there, turned as written.
Fill& place(Scene& scene, int body, const Vector3d& position, const Vector3d& velocity = Vector3d::Zero(),
            const Vector3d& angular_velocity = Vector3d::Zero());

/// A floor about y = 0 from -`half` to `half` (m), with teeth as wide as a disc of that radius and as deep as it, so
/// that the lowest row cannot roll away.
PolylineShape toothed_floor(double half, double radius);

/// Three discs in a triangle, of about the area of one disc of that radius (m).
std::vector<Sphere> disc_triangle(double radius);

/// Spring of k_n (N/m), k_s over k_n, restitution, friction.
contact::PairProperties linear_pair(double stiffness, double ratio, double restitution, double friction);

} // namespace tumble::scene
