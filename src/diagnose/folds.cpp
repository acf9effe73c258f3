#include "diagnose/folds.h"

#include <Eigen/QR>
#include <cmath>

namespace tumble::diagnose {

namespace {

MatrixXd rows_of(const MatrixXd& matrix, const std::vector<Eigen::Index>& rows) {
    MatrixXd some(static_cast<Eigen::Index>(rows.size()), matrix.cols());
    for (std::size_t k = 0; k < rows.size(); ++k)
        some.row(static_cast<Eigen::Index>(k)) = matrix.row(rows[k]);
    return some;
}

/// Rows of one condition, cut into the part that may be fitted and the rest; rows of all other conditions. Priors go
/// with both that are fitted.
struct Split {
    std::vector<Eigen::Index> others, first, rest;
    std::vector<Eigen::Index> readings_of_others; // others without priors
};

Split split_at(const Directions& directions, int condition) {
    Split split;
    for (std::size_t k = 0; k < directions.condition.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        if (directions.condition[k] == condition) {
            (directions.early[k] ? split.first : split.rest).push_back(row);
            continue;
        }
        split.others.push_back(row);
        (directions.condition[k] < 0 ? split.first : split.readings_of_others).push_back(row);
    }
    return split;
}

/// Parameters from the others; those that the others say nothing about, from the first part afterwards.
struct Prediction {
    VectorXd step;
    double chi_square = 0; // of the rest
};

Prediction predict(const VectorXd& residual, const MatrixXd& slopes, const Split& split) {
    if (slopes.cols() == 0) // nothing to adjust
        return {{}, rows_of(residual, split.rest).squaredNorm()};
    const MatrixXd first = rows_of(slopes, split.first), elsewhere = rows_of(slopes, split.readings_of_others);
    MatrixXd others = rows_of(slopes, split.others);
    std::vector<Eigen::Index> own;
    for (Eigen::Index k = 0; k < slopes.cols(); ++k)
        if (elsewhere.col(k).norm() < 1e-3 * first.col(k).norm())
            own.push_back(k);
    MatrixXd local(first.rows(), static_cast<Eigen::Index>(own.size()));
    for (std::size_t k = 0; k < own.size(); ++k) {
        others.col(own[k]).setZero();
        local.col(static_cast<Eigen::Index>(k)) = first.col(own[k]);
    }
    Prediction prediction;
    prediction.step = others.completeOrthogonalDecomposition().solve(rows_of(residual, split.others));
    if (!own.empty()) {
        const VectorXd missing = rows_of(residual, split.first) - first * prediction.step;
        const VectorXd found = local.completeOrthogonalDecomposition().solve(missing);
        for (std::size_t k = 0; k < own.size(); ++k)
            prediction.step[own[k]] = found[static_cast<Eigen::Index>(k)];
    }
    prediction.chi_square =
        (rows_of(residual, split.rest) - rows_of(slopes, split.rest) * prediction.step).squaredNorm();
    return prediction;
}

} // namespace

VectorXd errors_of(const MatrixXd& slopes) {
    if (slopes.cols() == 0)
        return {};
    const VectorXd scale = slopes.colwise().norm().cwiseMax(1e-300).transpose();
    const MatrixXd unit = slopes * scale.cwiseInverse().asDiagonal();
    const MatrixXd covariance = (unit.transpose() * unit).completeOrthogonalDecomposition().pseudoInverse();
    return covariance.diagonal().cwiseMax(0.0).cwiseSqrt().cwiseQuotient(scale);
}

std::vector<Fold> folds_of(const Evidence& evidence, const Refit& extended) {
    std::vector<Fold> folds;
    const Directions& directions = evidence.directions;
    if (directions.conditions.size() < 2)
        return folds;
    const Eigen::Index at = evidence.nuisances.cols();
    const double error = errors_of(extended.slopes)[at];
    for (std::size_t c = 0; c < directions.conditions.size(); ++c) {
        const Split split = split_at(directions, static_cast<int>(c));
        Fold fold;
        fold.condition = directions.conditions[c];
        fold.readings = static_cast<int>(split.rest.size());
        const Prediction with = predict(extended.residual, extended.slopes, split);
        fold.extended = with.chi_square;
        fold.baseline = predict(evidence.residual, evidence.nuisances, split).chi_square;
        fold.amplitude = extended.amplitude[0] + with.step[at];
        // The amplitude of all uses the others' data, too: the variance of the difference is that of the variances.
        const double without = errors_of(rows_of(extended.slopes, split.others))[at];
        const double own = std::sqrt(std::max(1e-300, without * without - error * error));
        fold.moved = without > 1.02 * error ? with.step[at] / own : 0;
        folds.push_back(std::move(fold));
    }
    return folds;
}

} // namespace tumble::diagnose
