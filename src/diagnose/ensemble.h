#pragma once

#include "diagnose/statistics.h"

#include <vector>

namespace tumble::diagnose {

/// Runs of one scene that differ in their seed: a row a run, a column a number.
using Ensemble = MatrixXd;

/// How single runs scatter about the mean of their ensemble.
struct Scatter {
    MatrixXd covariance;
    double degrees = 0;   // of freedom
    double shrinkage = 0; // share by which correlations were drawn towards none
};

/// The scatter that these ensembles of the same numbers share, each about its own mean: what a scene's extension does
/// to means it hardly does to scatter, and few seeds of each then make many together. The correlations are shrunk
/// towards zero as Ledoit and Wolf do (J. Multivariate Analysis 88, 2004, 365-411, lemma 3.1 to 3.4, of numbers in
/// units of their standard deviation), so that they can be inverted however few the runs.
Scatter pooled_scatter(const std::vector<Ensemble>& ensembles);

} // namespace tumble::diagnose
