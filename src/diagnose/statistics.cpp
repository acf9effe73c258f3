#include "diagnose/statistics.h"

#include "base/rng.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
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

/// Chi-square with so many whole degrees of freedom.
double chi_square(Rng& rng, double degrees) {
    double sum = 0;
    for (int k = 0; k < static_cast<int>(degrees); ++k) {
        const double z = normal(rng);
        sum += z * z;
    }
    return sum;
}

} // namespace

double hotelling_tail(double x, double dimensions, double degrees) {
    if (std::isinf(degrees))
        return chi_square_tail(x, dimensions);
    const double below = degrees - dimensions + 1;
    return dimensions > 0 && below > 0 ? f_tail(x * below / (degrees * dimensions), dimensions, below) : 1.0;
}

double quantile_of_largest(const MatrixXd& correlation, const std::vector<Side>& sides, double alpha,
                           std::uint64_t seed, double degrees) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(correlation);
    const MatrixXd root = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    Rng rng(seed);
    std::vector<double> largest;
    largest.reserve(draws);
    VectorXd drawn(correlation.rows());
    for (int k = 0; k < draws; ++k) {
        for (double& z : drawn)
            z = normal(rng);
        const double variance = std::isinf(degrees) ? 1 : chi_square(rng, degrees) / degrees;
        VectorXd z = root * drawn;
        for (std::size_t j = 0; j < sides.size(); ++j)
            if (double& one = z[static_cast<Eigen::Index>(j)]; sides[j] != Side::both)
                one = sides[j] == Side::above ? std::max(0.0, one) : std::min(0.0, one);
        largest.push_back(z.cwiseAbs2().maxCoeff() / variance);
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
