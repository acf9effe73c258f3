#include "diagnose/ensemble.h"

#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

/// All runs, each less the mean of its ensemble.
MatrixXd about_means(const std::vector<Ensemble>& ensembles, double& degrees) {
    Eigen::Index rows = 0;
    for (const Ensemble& one : ensembles)
        rows += one.rows();
    MatrixXd all(rows, ensembles[0].cols());
    Eigen::Index at = 0;
    for (const Ensemble& one : ensembles) {
        all.middleRows(at, one.rows()) = one.rowwise() - one.colwise().mean();
        at += one.rows();
    }
    degrees = static_cast<double>(rows) - static_cast<double>(ensembles.size());
    return all;
}

/// Share of the way to the identity that loses least on average: how uncertain the products are over how far their
/// means are from it.
double best_shrinkage(const MatrixXd& unit, const MatrixXd& correlation) {
    const auto runs = static_cast<double>(unit.rows());
    const double distance = (correlation - MatrixXd::Identity(correlation.rows(), correlation.cols())).squaredNorm();
    double uncertain = 0;
    for (Eigen::Index k = 0; k < unit.rows(); ++k)
        uncertain += (unit.row(k).transpose() * unit.row(k) - correlation).squaredNorm();
    uncertain /= runs * runs;
    return distance > 0 ? std::min(1.0, uncertain / distance) : 1.0;
}

} // namespace

Scatter pooled_scatter(const std::vector<Ensemble>& ensembles) {
    Scatter scatter;
    const MatrixXd apart = about_means(ensembles, scatter.degrees);
    const auto runs = static_cast<double>(apart.rows());
    // A number that no seed changes has the scatter of its last digits.
    const VectorXd size = ensembles[0].cwiseAbs().colwise().maxCoeff().transpose();
    const VectorXd sums = apart.colwise().norm().transpose().cwiseMax(1e-9 * size).cwiseMax(1e-300);
    const MatrixXd unit = apart * (std::sqrt(runs) * sums.cwiseInverse()).asDiagonal();
    MatrixXd correlation = unit.transpose() * unit / runs;
    correlation.diagonal().setOnes();
    scatter.shrinkage = best_shrinkage(unit, correlation);
    correlation *= 1 - scatter.shrinkage;
    correlation.diagonal().setOnes();
    const VectorXd deviation = sums / std::sqrt(std::max(1.0, scatter.degrees));
    scatter.covariance = deviation.asDiagonal() * correlation * deviation.asDiagonal();
    return scatter;
}

} // namespace tumble::diagnose
