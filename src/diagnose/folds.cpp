#include "diagnose/folds.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
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

/// Rows of one condition, and those of all others and of priors.
struct Split {
    std::vector<Eigen::Index> own, others;
};

Split split_at(const Directions& directions, int condition) {
    Split split;
    for (std::size_t k = 0; k < directions.condition.size(); ++k)
        (directions.condition[k] == condition ? split.own : split.others).push_back(static_cast<Eigen::Index>(k));
    return split;
}

constexpr double unknown = 1e4; // standard errors of all readings: how far a nuisance may lie that nothing tells

/// What is known of each parameter's step without any row: where it ends, and how surely.
struct Beforehand {
    VectorXd step, width;
};

/// Parameters from the other conditions, and what that is worth.
struct Prediction {
    VectorXd step;
    Foretold own;
};

Prediction predict(const VectorXd& residual, const MatrixXd& slopes, const Beforehand& beforehand, const Split& split) {
    const VectorXd missed = rows_of(residual, split.own);
    const Eigen::Index count = slopes.cols();
    if (count == 0) // nothing to adjust
        return {{}, {missed.squaredNorm(), 0}};
    const auto rows = static_cast<Eigen::Index>(split.others.size());
    const VectorXd weight = beforehand.width.cwiseInverse();
    MatrixXd others(rows + count, count);
    others << rows_of(slopes, split.others), MatrixXd(weight.asDiagonal());
    VectorXd known(rows + count);
    known << rows_of(residual, split.others), weight.cwiseProduct(beforehand.step);
    const VectorXd step = others.completeOrthogonalDecomposition().solve(known);
    const MatrixXd own = rows_of(slopes, split.own);
    return {step, foretold(missed - own * step, own * half_covariance(others))};
}

/// Nothing of nuisances beyond the priors that are rows already; of causes, of which `extended` has found some, that
/// they are plausible.
Beforehand known_beforehand(const MatrixXd& slopes, const Evidence& evidence, const Refit* extended) {
    Beforehand beforehand{VectorXd::Zero(slopes.cols()),
                          unknown * slopes.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose()};
    for (std::size_t k = 0; extended && k < extended->causes.size(); ++k) {
        const Cause& cause = evidence.causes[static_cast<std::size_t>(extended->causes[k])];
        const Eigen::Index at = evidence.nuisances.cols() + static_cast<Eigen::Index>(k);
        beforehand.step[at] = -extended->amplitude[static_cast<Eigen::Index>(k)];
        beforehand.width[at] = std::max(std::abs(cause.lo), std::abs(cause.hi));
    }
    return beforehand;
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

MatrixXd half_covariance(const MatrixXd& slopes) {
    const VectorXd scale = slopes.colwise().norm().transpose();
    const MatrixXd unit = slopes * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> told(unit.transpose() * unit);
    const VectorXd root = told.eigenvalues().cwiseMax(1 / (unknown * unknown)).cwiseSqrt().cwiseInverse();
    return scale.cwiseInverse().asDiagonal() * told.eigenvectors() * root.asDiagonal();
}

Foretold foretold(const VectorXd& missed, const MatrixXd& errors) {
    // Woodbury and Sylvester: all of it in as many dimensions as there are errors.
    MatrixXd inner = errors.transpose() * errors;
    inner.diagonal().array() += 1;
    const Eigen::LLT<MatrixXd> root(inner);
    const VectorXd along = errors.transpose() * missed;
    return {missed.squaredNorm() - along.dot(VectorXd(root.solve(along))),
            2 * MatrixXd(root.matrixL()).diagonal().array().log().sum()};
}

std::vector<Fold> folds_of(const Evidence& evidence, const Refit& extended) {
    std::vector<Fold> folds;
    const Directions& directions = evidence.directions;
    if (directions.conditions.size() < 2)
        return folds;
    const Eigen::Index at = evidence.nuisances.cols();
    const VectorXd errors = errors_of(extended.slopes);
    const Beforehand known = known_beforehand(extended.slopes, evidence, &extended),
                     known_without = known_beforehand(evidence.nuisances, evidence, nullptr);
    for (std::size_t c = 0; c < directions.conditions.size(); ++c) {
        const Split split = split_at(directions, static_cast<int>(c));
        Fold fold;
        const Prediction with = predict(extended.residual, extended.slopes, known, split);
        const Prediction baseline = predict(evidence.residual, evidence.nuisances, known_without, split);
        fold.score = {.condition = directions.conditions[c],
                      .readings = static_cast<int>(split.own.size()),
                      .baseline = baseline.own.chi_square,
                      .extended = with.own.chi_square,
                      .spread = with.own.spread - baseline.own.spread};
        fold.amplitude = extended.amplitude[0] + with.step[at];
        // The amplitude of all uses the others' data, too: the variance of the difference is that of the variances.
        const VectorXd without = errors_of(rows_of(extended.slopes, split.others));
        fold.mover = extended.causes[0];
        for (std::size_t k = 0; k < extended.causes.size(); ++k) {
            const Eigen::Index row = at + static_cast<Eigen::Index>(k);
            const double own = std::sqrt(std::max(1e-300, without[row] * without[row] - errors[row] * errors[row]));
            const double moved = without[row] > 1.02 * errors[row] ? with.step[row] / own : 0;
            if (std::abs(moved) > std::abs(fold.moved)) {
                fold.moved = moved;
                fold.mover = extended.causes[k];
            }
        }
        folds.push_back(std::move(fold));
    }
    return folds;
}

} // namespace tumble::diagnose
