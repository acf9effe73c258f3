#include "sim3d/body_shape.h"

#include "base/angle_cover.h"
#include "fit/union_moments.h"
#include "scene/faults.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace tumble::sim3d {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using scene::Sphere;

namespace {

/// Two principal moments nearer than this (relative) are one: the axes between them are then free to choose.
constexpr double same_moment = 1e-5;
/// Off-diagonal moments below this (of the largest moment): the written axes are principal.
constexpr double no_product = 1e-6;

Problem problem_of(const scene::BodyTemplate& body, std::string what, std::string fix) {
    Problem problem;
    problem.key = "body." + body.name;
    problem.what = fmt::format("body '{}': {}", body.name, what);
    problem.fix = std::move(fix);
    return problem;
}

Problems faults_of(const scene::BodyTemplate& body, const contact::Material& material) {
    Problems problems;
    if (body.spheres.empty())
        problems.push_back(problem_of(body, "there are no spheres in it", "give it one sphere or more"));
    for (std::size_t i = 0; i < body.spheres.size(); ++i) {
        const Sphere& sphere = body.spheres[i];
        if (!sphere.centre.allFinite() || !std::isfinite(sphere.radius) || sphere.radius <= 0)
            problems.push_back(problem_of(body, fmt::format("sphere {} has radius {} m", i + 1, sphere.radius),
                                          "a radius must be positive and every number finite"));
    }
    if (!body.mass && !(material.density > 0 && std::isfinite(material.density)))
        problems.push_back(problem_of(body, fmt::format("the density is {} kg/m3", material.density),
                                      "give a positive density, or the body's mass"));
    if (body.mass && !(*body.mass > 0 && std::isfinite(*body.mass)))
        problems.push_back(problem_of(body, fmt::format("the mass is {} kg", *body.mass), "a mass must be positive"));
    if (body.principal_inertia)
        if (const auto fault = scene::fault_of_inertia(*body.principal_inertia))
            problems.push_back(problem_of(body, fault->what, fault->fix));
    return problems;
}

/// A mass within R of its centre has three moments that sum, being twice the sum of m r^2, to at most 2 m R^2. Arms
/// that no sphere stands for may go beyond that, but not a hundredfold; the units that slip differ by a thousand and
/// more.
std::optional<Problem> inertia_too_large(const scene::BodyTemplate& body, const BodyShape& shape) {
    constexpr double arms = 100;
    const double most = 2 * shape.mass * shape.bounding_radius * shape.bounding_radius;
    if (!body.principal_inertia || shape.inertia.sum() <= arms * most)
        return std::nullopt;
    Problem problem =
        problem_of(body,
                   fmt::format("the moments of {:.4g} kg within {:.4g} m of the centre sum to {:.3g} kg m2 at most, "
                               "not to {:.3g}",
                               shape.mass, shape.bounding_radius, most, shape.inertia.sum()),
                   "write them in kg m2 (1 kg mm2 is 1e-6 kg m2, 1 g cm2 is 1e-7 kg m2), or leave them out");
    problem.key += ".inertia_kg_m2";
    return problem;
}

/// The written axis that points most along `direction`.
int nearest_axis(const Vector3d& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// One axis is told apart from two equal ones: it gets the written axis that it is nearest to, the next written axis
/// is projected onto the plane of the two.
Matrix3d frame_about(Vector3d special) {
    const int first = nearest_axis(special), second = (first + 1) % 3, third = (first + 2) % 3;
    if (special[first] < 0)
        special = -special;
    Matrix3d axes;
    axes.col(first) = special;
    axes.col(second) = (Vector3d::Unit(second) - special[second] * special).normalized();
    axes.col(third) = axes.col(first).cross(axes.col(second));
    return axes;
}

/// Three different axes: the order with the most along the written axes, signs along them, right-handed.
Matrix3d frame_of(const Matrix3d& found) {
    std::array<int, 3> order{0, 1, 2}, best = order;
    double most = -1;
    do {
        double along = 0;
        for (int axis = 0; axis < 3; ++axis)
            along += std::abs(found(axis, order[static_cast<std::size_t>(axis)]));
        if (along > most + 1e-9) {
            most = along;
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    Matrix3d axes;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3d column = found.col(best[static_cast<std::size_t>(axis)]);
        axes.col(axis) = column[axis] < 0 ? Vector3d(-column) : column;
    }
    if (axes.determinant() < 0) {
        int weakest = 0;
        axes.diagonal().cwiseAbs().minCoeff(&weakest);
        axes.col(weakest) *= -1;
    }
    return axes;
}

/// Columns: principal axes in the written frame.
Matrix3d principal_axes(const Matrix3d& inertia) {
    Matrix3d products = inertia;
    products.diagonal().setZero();
    const double largest = inertia.diagonal().maxCoeff();
    if (products.cwiseAbs().maxCoeff() <= no_product * largest)
        return Matrix3d::Identity();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
    const Vector3d& moment = solver.eigenvalues();
    const Matrix3d& axes = solver.eigenvectors();
    const bool low_pair = moment[1] - moment[0] <= same_moment * moment[2];
    const bool high_pair = moment[2] - moment[1] <= same_moment * moment[2];
    if (low_pair && high_pair)
        return Matrix3d::Identity();
    if (low_pair || high_pair)
        return frame_about(axes.col(low_pair ? 2 : 0));
    return frame_of(axes);
}

bool inside(const Sphere& inner, const Sphere& outer) {
    return (inner.centre - outer.centre).norm() + inner.radius <= outer.radius;
}

/// Half the opening angle of the cap of `sphere` that lies inside `other`; not positive when there is none.
double cap_angle(const Sphere& sphere, const Sphere& other) {
    const double apart = (other.centre - sphere.centre).norm();
    if (apart >= sphere.radius + other.radius || apart + other.radius <= sphere.radius)
        return 0;
    const double cosine =
        (apart * apart + sphere.radius * sphere.radius - other.radius * other.radius) / (2 * apart * sphere.radius);
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

struct Cap {
    Vector3d middle = Vector3d::Zero(); // unit
    double angle = 0;                   // rad, half the opening
};

/// Hides on the rim of `rim` what lies inside the cap `over`. The rim's angle counts from `u` to `v`. A margin leaves
/// a hair of every arc free, so that only rounding-proof covers count.
void hide_rim(const Cap& rim, const Vector3d& u, const Vector3d& v, const Cap& over, AngleCover& cover) {
    constexpr double margin = 1e-9;
    const double across = std::hypot(over.middle.dot(u), over.middle.dot(v)) * std::sin(rim.angle);
    const double level = std::cos(over.angle) - over.middle.dot(rim.middle) * std::cos(rim.angle);
    // A rim point at angle t is in the cap when across * cos(t - middle) >= level.
    if (level <= -across - margin)
        cover.hide(0, 4);
    else if (level < across)
        cover.hide(std::atan2(over.middle.dot(v), over.middle.dot(u)),
                   std::acos(std::clamp(level / across, -1.0, 1.0)) - margin);
}

/// If anything of a sphere is free, the free part ends on the rim of some cap, and there the rim itself is free: it is
/// enough to look along the rims.
bool wholly_covered(const Sphere& sphere, const std::vector<const Sphere*>& others) {
    std::vector<Cap> caps;
    for (const Sphere* other : others) {
        if (inside(sphere, *other))
            return true;
        const double angle = cap_angle(sphere, *other);
        if (angle > 0)
            caps.push_back({(other->centre - sphere.centre).normalized(), angle});
    }
    if (caps.empty())
        return false;
    AngleCover cover;
    for (std::size_t i = 0; i < caps.size(); ++i) {
        const Vector3d u = caps[i].middle.unitOrthogonal(), v = caps[i].middle.cross(u);
        cover.clear();
        for (std::size_t j = 0; j < caps.size(); ++j)
            if (j != i)
                hide_rim(caps[i], u, v, caps[j], cover);
        if (!cover.all_hidden())
            return false;
    }
    return true;
}

} // namespace

Result<BodyShape> make_body_shape(const scene::BodyTemplate& body, const contact::Material& material) {
    if (Problems problems = faults_of(body, material); !problems.empty())
        return problems;
    const fit::UnionMoments moments = fit::union_moments(body.spheres);

    BodyShape shape;
    shape.name = body.name;
    shape.volume = moments.volume;
    shape.mass = body.mass.value_or(material.density * moments.volume);
    const Matrix3d spread = moments.second * (shape.mass / moments.volume);
    const Matrix3d inertia = spread.trace() * Matrix3d::Identity() - spread;
    const Matrix3d axes = principal_axes(inertia);
    shape.inertia = body.principal_inertia.value_or((axes.transpose() * inertia * axes).diagonal());
    shape.written_centre = moments.centre;
    shape.written_from_principal = Eigen::Quaterniond(axes);
    for (const Sphere& sphere : body.spheres) {
        shape.spheres.push_back({axes.transpose() * (sphere.centre - moments.centre), sphere.radius});
        const Sphere& placed = shape.spheres.back();
        shape.bounding_radius = std::max(shape.bounding_radius, placed.centre.norm() + placed.radius);
    }
    if (const auto problem = inertia_too_large(body, shape))
        return *problem;
    return shape;
}

std::vector<int> contact_spheres(const BodyShape& shape) {
    // Small ones are asked first, and each only against those still in: nothing is left out because of a sphere that is
    // itself left out.
    const std::vector<Sphere>& spheres = shape.spheres;
    std::vector<int> order(spheres.size()), kept;
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return spheres[static_cast<std::size_t>(a)].radius < spheres[static_cast<std::size_t>(b)].radius;
    });
    std::vector<bool> out(spheres.size(), false);
    for (const int candidate : order) {
        std::vector<const Sphere*> others;
        for (std::size_t i = 0; i < spheres.size(); ++i)
            if (static_cast<int>(i) != candidate && !out[i])
                others.push_back(&spheres[i]);
        out[static_cast<std::size_t>(candidate)] = wholly_covered(spheres[static_cast<std::size_t>(candidate)], others);
    }
    for (std::size_t i = 0; i < spheres.size(); ++i)
        if (!out[i])
            kept.push_back(static_cast<int>(i));
    return kept;
}

} // namespace tumble::sim3d
