#include "support/fit_body.h"

#include "support/arguments.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_matrix(const Vector3d& v) {
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Matrix3d best_rotation(const Matrix3d& covariance) {
    const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double handed = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixV() * Vector3d(1, 1, handed).asDiagonal() * svd.matrixU().transpose();
}

} // namespace

FittedBody fit_body(const sim3d::BodyShape& shape, std::span<const WrittenSphere> spheres, double lo, double period) {
    std::vector<Vector3d> places;
    Vector3d middle = Vector3d::Zero(), local_middle = Vector3d::Zero(), drift = Vector3d::Zero();
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        Vector3d x = spheres[i].position;
        x.x() -= period * std::round((x.x() - spheres[0].position.x()) / period);
        places.push_back(x);
        middle += x;
        local_middle += shape.spheres[i].centre;
        drift += spheres[i].velocity;
    }
    const double n = static_cast<double>(spheres.size());
    middle /= n, local_middle /= n, drift /= n;

    Matrix3d covariance = Matrix3d::Zero(), spread = Matrix3d::Zero();
    Vector3d swirl = Vector3d::Zero();
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Vector3d arm = places[i] - middle;
        covariance += (shape.spheres[i].centre - local_middle) * arm.transpose();
        spread -= cross_matrix(arm) * cross_matrix(arm);
        swirl += arm.cross(spheres[i].velocity - drift);
    }
    FittedBody fitted;
    const Matrix3d rotation = best_rotation(covariance);
    fitted.state.orientation = Eigen::Quaterniond(rotation).normalized();
    fitted.state.position = middle - rotation * local_middle;
    fitted.state.angular_velocity = spread.ldlt().solve(swirl);
    fitted.state.velocity = drift + fitted.state.angular_velocity.cross(fitted.state.position - middle);
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const Vector3d place = fitted.state.position + rotation * shape.spheres[i].centre;
        fitted.miss = std::max(fitted.miss, (place - places[i]).norm());
    }
    fitted.state.position.x() -= period * std::floor((fitted.state.position.x() - lo) / period);
    return fitted;
}

std::vector<sim3d::BodyState> fit_bodies(const sim3d::World& world, const std::vector<WrittenSphere>& spheres,
                                         double lo, double period, double tolerance) {
    const sim3d::BodyShape& shape = sim3d::shapes_of(world).front();
    const std::size_t each = shape.spheres.size();
    if (spheres.size() % each != 0)
        refuse(fmt::format("{} spheres are not whole bodies of {}", spheres.size(), each));
    std::vector<sim3d::BodyState> bodies;
    for (std::size_t at = 0; at < spheres.size(); at += each) {
        const FittedBody fitted = fit_body(shape, std::span(spheres).subspan(at, each), lo, period);
        if (!(fitted.miss <= tolerance))
            refuse(fmt::format("body {}: a sphere lies {:.3g} m from its place", bodies.size(), fitted.miss));
        bodies.push_back(fitted.state);
    }
    return bodies;
}

} // namespace tumble::bench
