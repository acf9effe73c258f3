#pragma once

#include <vector>

namespace tumble::observe {

struct Rows {
    std::vector<double> time, value;
};

/// The rows after `from` up to `until` (s): a stretch of whole periods holds each phase once. A row stands at the step
/// nearest to its time, so that half of `every`, what lies between rows, decides. What has no meaning in some rows (a
/// slope while bodies fly) is left out there; none at all where it has none in most.
Rows rows_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
               double every);

/// Their mean; NaN where there are none.
double mean_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
                 double every);

} // namespace tumble::observe
