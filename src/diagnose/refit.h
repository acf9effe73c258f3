#pragma once

#include "diagnose/decide.h"
#include "diagnose/fit.h"

namespace tumble::diagnose {

/// Fits these causes (numbers of the model's) beside all nuisances: from the baseline, whose slopes and `effects`, a
/// column for each cause of the model, are known; anew from the scene where that does not end or the baseline went
/// astray; and if neither ends, from the one of several amplitudes that misses the readings least. Not `thorough`: from
/// the baseline alone.
Refit refit_of(const std::vector<int>& causes, Model& model, const Noise& noise, const Fit& baseline,
               const MatrixXd& effects, bool thorough = true);

} // namespace tumble::diagnose
