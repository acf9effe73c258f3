#pragma once

#include "diagnose/decide.h"

namespace tumble::diagnose {

/// Standard errors of the parameters of a fit with these slopes.
VectorXd errors_of(const MatrixXd& slopes);

/// Half of the covariance that a fit with these slopes S leaves: H with H H' = (S'S)^-1. Of what no row tells, no more
/// than 1e4 standard errors of all readings.
MatrixXd half_covariance(const MatrixXd& slopes);

/// How far readings of scatter 1 lie from a prediction that has errors of its own.
struct Foretold {
    double chi_square = 0; // by the covariance of both
    double spread = 0;     // logarithm of that covariance's determinant
};

/// `missed`: readings less prediction; `errors`: one column for each independent error of the prediction of size 1.
Foretold foretold(const VectorXd& missed, const MatrixXd& errors);

/// For every condition: the cause's amplitude from all others (of two, the first one's), and how well the condition is
/// predicted by them with and without what was fitted. What only this condition can tell (its clock offset) is left as
/// open as it was beforehand, for both alike. Linear about the fits. Empty when there is one condition only.
std::vector<Fold> folds_of(const Evidence& evidence, const Refit& extended);

} // namespace tumble::diagnose
