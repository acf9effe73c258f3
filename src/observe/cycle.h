#pragma once

#include <span>
#include <vector>

namespace tumble::observe {

/// What goes up and down in a signal, found from its turning points and not from a spectrum: a few irregular cycles of
/// a body that is carried round are too short for one. docs/measures.md, "Cycle of a signal".
struct Cycle {
    double period = 0;       // s, median time between turning points of one kind; NaN with fewer than two of a kind
    double peak_to_peak = 0; // median height between neighbouring turning points; NaN with fewer than two
    double lowest = 0, highest = 0;
    double cycles = 0;                 // seen, from the first turning point to the last, two halves to each
    std::vector<double> tops, bottoms; // s
};

/// A turning point counts once the signal has come back from it by `threshold` of the span between its 5 % and 95 %
/// quantiles, so that jitter below that makes none. The signal's ends are no turning points. Values that are not finite
/// are left out.
Cycle find_cycle(std::span<const double> times, std::span<const double> values, double threshold = 0.35);

/// The value below which a share of the values lies, linear between neighbours; NaN without any.
double quantile(std::vector<double> values, double share);

} // namespace tumble::observe
