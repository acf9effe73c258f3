#include "about.h"
#include "bricks.h"

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

namespace test_brick {

using namespace tumble;
using namespace tumble::fem;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

const Elastic steel{2e11, 0.3};

solid::Corners skew() {
    solid::Corners corners = 0.01 * solid::corner_signs;
    Rng rng(5);
    for (int k = 0; k < 8; ++k)
        for (int axis = 0; axis < 3; ++axis)
            corners(axis, k) += 0.003 * rng.uniform(-1, 1);
    return corners;
}

/// Displacements of the corners by a function of their place.
template <class Field> Eigen::Matrix<double, 24, 1> moved(const solid::Corners& corners, Field field) {
    Eigen::Matrix<double, 24, 1> displacement;
    for (int k = 0; k < 8; ++k)
        displacement.segment<3>(3 * k) = field(Vector3d(corners.col(k)));
    return displacement;
}

} // namespace

TEST_CASE("Hooke's law gives uniaxial strain and shear the moduli of theory") {
    // Held sideways a solid is as stiff as E (1 - nu) / ((1 + nu) (1 - 2 nu)); in shear G = E / (2 (1 + nu)).
    const auto law = hooke(steel);
    CHECK(law(0, 0) == about(2e11 * 0.7 / (1.3 * 0.4), 1e-12));
    CHECK(law(1, 0) == about(2e11 * 0.3 / (1.3 * 0.4), 1e-12));
    CHECK(law(4, 4) == about(2e11 / 2.6, 1e-12));
    CHECK(law.inverse()(0, 0) == about(1 / 2e11, 1e-12));
    CHECK(law.inverse()(1, 0) == about(-0.3 / 2e11, 1e-12));
}

TEST_CASE("a rigid motion gives no stress and no force, and nothing else does") {
    for (const Formulation formulation : {Formulation::standard, Formulation::incompatible}) {
        const Brick brick = brick_of(skew(), hooke(steel), formulation);
        const auto rigid = moved(
            skew(), [](const Vector3d& x) { return Vector3d(Vector3d(1, -2, 3) + Vector3d(30, -20, 10).cross(x)); });
        const double force_scale = brick.stiffness.cwiseAbs().maxCoeff() * rigid.cwiseAbs().maxCoeff();
        CHECK((brick.stiffness * rigid).cwiseAbs().maxCoeff() < 1e-14 * 24 * force_scale);
        CHECK((brick.corner_stress * rigid).cwiseAbs().maxCoeff() <
              1e-14 * 24 * brick.corner_stress.cwiseAbs().maxCoeff() * rigid.cwiseAbs().maxCoeff());
        // Six rigid motions, so six eigenvalues of 0; the others are stiff.
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 24, 24>> modes(brick.stiffness);
        const double stiffest = modes.eigenvalues()[23];
        CHECK(std::abs(modes.eigenvalues()[0]) < 1e-14 * stiffest);
        CHECK(std::abs(modes.eigenvalues()[5]) < 1e-14 * stiffest);
        CHECK(modes.eigenvalues()[6] > 1e-4 * stiffest);
    }
}

TEST_CASE("a linear displacement gives its stress everywhere in a distorted brick, standard or not") {
    Eigen::Matrix3d gradient;
    gradient << 1e-3, 2e-4, -3e-4, 4e-4, -2e-3, 5e-4, 1e-4, -6e-4, 7e-4;
    Stress strain;
    strain << gradient(0, 0), gradient(1, 1), gradient(2, 2), gradient(0, 1) + gradient(1, 0),
        gradient(1, 2) + gradient(2, 1), gradient(2, 0) + gradient(0, 2);
    const Stress expected = hooke(steel) * strain;
    for (const Formulation formulation : {Formulation::standard, Formulation::incompatible}) {
        const Brick brick = brick_of(skew(), hooke(steel), formulation);
        const Eigen::Matrix<double, 48, 1> stress =
            brick.corner_stress * moved(skew(), [&](const Vector3d& x) { return Vector3d(gradient * x); });
        for (int corner = 0; corner < 8; ++corner)
            CHECK((stress.segment<6>(6 * corner) - expected).cwiseAbs().maxCoeff() < 1e-11 * expected.norm());
    }
}

TEST_CASE("in pure bending a brick is too stiff by its slenderness, the incompatible one right") {
    // A box of length a along x and height b along z, bent by ux = -k x z without lateral strain (nu = 0): beam theory
    // stores E I k^2 a / 2. The straight edges of the standard brick shear by k x, which adds G A k^2 a^3 / 24: with
    // G = E/2 and I = A b^2 / 12 it stores 1 + (a/b)^2 / 2 times as much (Cook, Concepts and Applications of Finite
    // Element Analysis, the four-node rectangle).
    const double a = 0.03, b = 0.01, width = 0.02, curvature = 0.1;
    const solid::Corners corners = Vector3d(a / 2, width / 2, b / 2).asDiagonal() * solid::corner_signs;
    const auto bent = moved(corners, [&](const Vector3d& x) { return Vector3d(-curvature * x.x() * x.z(), 0, 0); });
    const Elastic without_poisson{2e11, 0};
    const double beam = 0.5 * 2e11 * width * b * b * b / 12 * curvature * curvature * a;
    const auto energy = [&](Formulation formulation) {
        return 0.5 * bent.dot(brick_of(corners, hooke(without_poisson), formulation).stiffness * bent);
    };
    CHECK(energy(Formulation::standard) == about(beam * (1 + 0.5 * (a / b) * (a / b)), 1e-12));
    CHECK(energy(Formulation::incompatible) == about(beam, 1e-12));
}

TEST_CASE("a bent incompatible brick of steel has beam theory's stress at its corners, and none across") {
    // With lateral strain (nu = 0.3): u = -k x z, v = nu k y z, w = k (x^2 + nu (z^2 - y^2)) / 2 strains by -k z along
    // x and by nu k z across, shears nothing, and leaves sigma_x = -E k z alone. A trilinear field extrapolates it
    // exactly.
    const double curvature = 0.1;
    const solid::Corners corners = Vector3d(0.015, 0.01, 0.005).asDiagonal() * solid::corner_signs;
    const auto bent = moved(corners, [&](const Vector3d& at) {
        const double x = at.x(), y = at.y(), z = at.z();
        return Vector3d(-curvature * x * z, 0.3 * curvature * y * z, 0.5 * curvature * (x * x + 0.3 * (z * z - y * y)));
    });
    const Brick brick = brick_of(corners, hooke(steel), Formulation::incompatible);
    const Eigen::Matrix<double, 48, 1> stress = brick.corner_stress * bent;
    for (int corner = 0; corner < 8; ++corner) {
        Stress theory = Stress::Zero();
        theory[0] = -2e11 * curvature * corners(2, corner);
        CHECK((stress.segment<6>(6 * corner) - theory).norm() < 1e-11 * theory.norm());
    }
    const double area = 0.02 * 0.01, inertia = area * 0.01 * 0.01 / 12;
    CHECK(0.5 * bent.dot(brick.stiffness * bent) == about(0.5 * 2e11 * inertia * curvature * curvature * 0.03, 1e-11));
}

} // namespace test_brick
