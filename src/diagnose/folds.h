#pragma once

#include "diagnose/decide.h"

namespace tumble::diagnose {

/// Standard errors of the parameters of a fit with these slopes.
VectorXd errors_of(const MatrixXd& slopes);

/// For every condition: the cause's amplitude from all others (of two, the first one's), and how well the condition is
/// predicted by them with and without what was fitted. What only this condition can tell (its clock offset) is taken
/// from the first part of its own records, for both alike. Linear about the fits. Empty when there is one condition
/// only.
std::vector<Fold> folds_of(const Evidence& evidence, const Refit& extended);

} // namespace tumble::diagnose
