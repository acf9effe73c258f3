#include "sim3d/time_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sim3d {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// 1/m + the largest eigenvalue of [c] I^-1 [c]^T for impulses through sphere centres c; for any direction at the
/// sphere's surface the norm of [c + r n] is bounded by those of [c] and [r n].
scene::ContactSide side_of(const BodyShape& shape, int material) {
    scene::ContactSide side;
    side.name = "body " + shape.name;
    side.material = material;
    side.mass = shape.mass;
    side.radius = 0;
    const Vector3d root = shape.inertia.cwiseSqrt().cwiseInverse();
    double push = 0, full = 0;
    for (const scene::Sphere& sphere : shape.spheres) {
        const Vector3d& c = sphere.centre;
        Matrix3d cross;
        cross << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
        const Matrix3d turned = root.asDiagonal() * cross;
        const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(turned.transpose() * turned, Eigen::EigenvaluesOnly);
        const double arm = std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
        push = std::max(push, arm);
        full = std::max(full, arm + sphere.radius * root.maxCoeff());
        side.radius = std::max(side.radius, sphere.radius);
    }
    side.push_mobility = 1 / shape.mass + push * push;
    side.full_mobility = 1 / shape.mass + full * full;
    return side;
}

} // namespace

scene::TimeStepReport time_step_report(const scene::Scene& scene, const std::vector<BodyShape>& shapes) {
    std::vector<scene::ContactSide> bodies;
    std::vector<scene::NamedRadius> parts;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const int material = scene.bodies[i].material;
        bodies.push_back(side_of(shapes[i], material));
        for (std::size_t s = 0; s < shapes[i].spheres.size(); ++s)
            parts.push_back(
                {fmt::format("body {}, sphere {}", shapes[i].name, s + 1), shapes[i].spheres[s].radius, material});
    }
    return scene::time_step_report(scene, bodies, parts);
}

} // namespace tumble::sim3d
