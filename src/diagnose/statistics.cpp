#include "diagnose/statistics.h"

#include "base/rng.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>
#include <vector>

namespace tumble::diagnose {

namespace {

constexpr int draws = 40'000;
constexpr double dependent = 1e-7;

/// Box and Muller's pair, one of them: standard normal.
double normal(Rng& rng) {
    const double radius = std::sqrt(-2 * std::log(1 - rng.uniform()));
    return radius * std::cos(2 * 3.14159265358979323846 * rng.uniform());
}

} // namespace

double chi_square_tail(double x, double degrees) {
    return x <= 0 || degrees <= 0 ? 1.0 : Eigen::numext::igammac(degrees / 2, x / 2);
}

double normal_tail(double x) {
    return 0.5 * std::erfc(x / std::sqrt(2.0));
}

double normal_quantile(double tail) {
    return -Eigen::numext::ndtri(tail);
}

double quantile_of_largest(const MatrixXd& correlation, double alpha, std::uint64_t seed) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(correlation);
    const MatrixXd root = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    Rng rng(seed);
    std::vector<double> largest;
    largest.reserve(draws);
    VectorXd drawn(correlation.rows());
    for (int k = 0; k < draws; ++k) {
        for (double& z : drawn)
            z = normal(rng);
        largest.push_back((root * drawn).cwiseAbs2().maxCoeff());
    }
    const auto at = largest.begin() + static_cast<std::ptrdiff_t>((1 - alpha) * draws);
    std::nth_element(largest.begin(), at, largest.end());
    return *at;
}

Projector::Projector(const MatrixXd& columns) {
    if (columns.cols() == 0) {
        basis_ = MatrixXd::Zero(columns.rows(), 0);
        return;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(unit_columns(columns));
    qr.setThreshold(dependent);
    basis_ = qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

MatrixXd unit_columns(MatrixXd columns) {
    for (Eigen::Index k = 0; k < columns.cols(); ++k)
        if (const double length = columns.col(k).norm(); length > 0)
            columns.col(k) /= length;
    return columns;
}

} // namespace tumble::diagnose
