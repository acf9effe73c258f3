#pragma once

#include "solid/hex8.h"

#include <Eigen/Core>

/// One linear elastic hexahedron.
namespace tumble::fem {

struct Elastic {
    double youngs_modulus = 0; // Pa
    double poisson_ratio = 0;
};

/// standard: trilinear displacements, 2 x 2 x 2 integration (C3D8). It is too stiff where it bends: its straight edges
/// stay straight and it shears instead.
/// incompatible: with three further quadratic displacements per direction that belong to the element alone and are
/// condensed out (Wilson et al. 1973), their derivatives taken with the Jacobian of the centre so that distorted
/// elements pass the patch test (Taylor, Beresford and Wilson 1976, Int. J. Num. Meth. Eng. 10, 1211); it bends right.
enum class Formulation { standard, incompatible };

/// Stress and strain: xx yy zz xy yz zx; shear strains are the engineering ones.
using Stress = Eigen::Matrix<double, 6, 1>;

/// Hooke's law, Pa.
Eigen::Matrix<double, 6, 6> hooke(const Elastic& material);

struct Brick {
    Eigen::Matrix<double, 24, 24> stiffness; // N/m; rows and columns: 3 * corner + axis
    /// Stresses at the corners by displacements of the corners, Pa/m; rows: 6 * corner + component. Those of the
    /// integration points, extrapolated to the corners as a trilinear field.
    Eigen::Matrix<double, 48, 24> corner_stress;
    /// The same at the integration points, rows: 6 * point + component.
    Eigen::Matrix<double, 48, 24> point_stress;
};

/// Of an element whose Jacobian determinant is positive at the integration points.
Brick brick_of(const solid::Corners& corners, const Eigen::Matrix<double, 6, 6>& law, Formulation formulation);

} // namespace tumble::fem
