#pragma once

#include <vector>

namespace tumble::observe {

/// Mean of the rows after `from` up to `until` (s): a stretch of whole periods holds each phase once. A row stands at
/// the step nearest to its time, so that half of `every`, what lies between rows, decides. What has no meaning in some
/// rows (a slope while bodies fly) is left out there; NaN where it has none in most.
double mean_over(const std::vector<double>& times, const std::vector<double>& values, double from, double until,
                 double every);

} // namespace tumble::observe
