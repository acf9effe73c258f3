#include "fem/brick.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>

namespace tumble::fem {

using Eigen::Matrix;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Strains of a displacement along `axis` whose gradient is given: one column of a strain matrix.
Stress strain_of(const Vector3d& gradient, int axis) {
    Stress strain = Stress::Zero();
    strain[axis] = gradient[axis];
    // xy, yz, zx
    for (int shear = 0; shear < 3; ++shear) {
        const int a = shear, b = (shear + 1) % 3;
        if (axis == a)
            strain[3 + shear] = gradient[b];
        if (axis == b)
            strain[3 + shear] = gradient[a];
    }
    return strain;
}

/// Columns 3 * k + axis from gradients, one column each.
template <int functions> Matrix<double, 6, 3 * functions> strains_of(const Matrix<double, 3, functions>& gradients) {
    Matrix<double, 6, 3 * functions> strains;
    for (int k = 0; k < functions; ++k)
        for (int axis = 0; axis < 3; ++axis)
            strains.col(3 * k + axis) = strain_of(gradients.col(k), axis);
    return strains;
}

/// What trilinear values at the integration points are at the corners: corner n lies at sqrt(3) of point n.
Matrix<double, 8, 8> to_corners() {
    Matrix<double, 8, 8> values;
    for (int corner = 0; corner < 8; ++corner)
        values.row(corner) = solid::shape_at(std::sqrt(3.0) * solid::corner_signs.col(corner)).transpose();
    return values;
}

} // namespace

Matrix<double, 6, 6> hooke(const Elastic& material) {
    const double shear = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
    const double lame = 2 * shear * material.poisson_ratio / (1 - 2 * material.poisson_ratio);
    Matrix<double, 6, 6> law = Matrix<double, 6, 6>::Zero();
    law.topLeftCorner<3, 3>().setConstant(lame);
    law.topLeftCorner<3, 3>().diagonal().array() += 2 * shear;
    law.bottomRightCorner<3, 3>().diagonal().setConstant(shear);
    return law;
}

Brick brick_of(const solid::Corners& corners, const Matrix<double, 6, 6>& law, Formulation formulation) {
    const Matrix3d centre = solid::jacobian_at(corners, Vector3d::Zero());
    const Matrix3d centre_inverse = centre.inverse().transpose();
    const double centre_volume = centre.determinant();

    std::array<Matrix<double, 6, 24>, 8> strains;
    std::array<Matrix<double, 6, 9>, 8> own_strains; // of the element's own displacements
    Matrix<double, 24, 24> stiffness = Matrix<double, 24, 24>::Zero();
    Matrix<double, 9, 24> coupling = Matrix<double, 9, 24>::Zero();
    Matrix<double, 9, 9> own = Matrix<double, 9, 9>::Zero();
    for (std::size_t point = 0; point < 8; ++point) {
        const Vector3d natural = solid::gauss_point(static_cast<int>(point));
        const Matrix3d jacobian = solid::jacobian_at(corners, natural);
        const double volume = jacobian.determinant();
        const Matrix<double, 3, 8> gradients = jacobian.inverse().transpose() * solid::slopes_at(natural);
        strains[point] = strains_of<8>(gradients);
        const Matrix<double, 6, 24> stress = law * strains[point];
        stiffness.noalias() += volume * strains[point].transpose() * stress;
        if (formulation == Formulation::standard)
            continue;
        // 1 - r^2, 1 - s^2, 1 - t^2
        const Matrix3d own_gradients = centre_volume / volume * centre_inverse * Matrix3d((-2 * natural).asDiagonal());
        own_strains[point] = strains_of<3>(own_gradients);
        coupling.noalias() += volume * own_strains[point].transpose() * stress;
        own.noalias() += volume * own_strains[point].transpose() * law * own_strains[point];
    }

    Brick brick;
    Matrix<double, 9, 24> follow = Matrix<double, 9, 24>::Zero(); // of the element's own displacements
    if (formulation == Formulation::incompatible) {
        follow = -own.ldlt().solve(coupling);
        stiffness += coupling.transpose() * follow;
    }
    brick.stiffness = 0.5 * (stiffness + stiffness.transpose());
    for (std::size_t point = 0; point < 8; ++point) {
        Matrix<double, 6, 24> strain = strains[point];
        if (formulation == Formulation::incompatible)
            strain += own_strains[point] * follow;
        brick.point_stress.middleRows<6>(6 * static_cast<Eigen::Index>(point)) = law * strain;
    }
    static const Matrix<double, 8, 8> extrapolate = to_corners();
    brick.corner_stress.setZero();
    for (int corner = 0; corner < 8; ++corner)
        for (int point = 0; point < 8; ++point)
            brick.corner_stress.middleRows<6>(6 * corner) +=
                extrapolate(corner, point) * brick.point_stress.middleRows<6>(6 * point);
    return brick;
}

} // namespace tumble::fem
