#pragma once

#include "diagnose/ensemble.h"

#include <vector>

namespace tumble::diagnose {

/// How the numbers of a bed change with one cause, read between the amplitudes it was run at: a parabola through them
/// and the null, or a wave of one turn where the cause is an angle and was run a quarter turn to either side.
struct Branch {
    double lo = 0, hi = 0; // amplitudes that were run; a whole turn for a wave
    VectorXd first, second;
    bool wave = false;

    [[nodiscard]] VectorXd change(double amplitude) const;
    [[nodiscard]] VectorXd slope(double amplitude) const;
    /// Change per unit that a screening goes by: the slope at the null, or the chord to an end where the change is to
    /// the same side whichever way the cause acts.
    [[nodiscard]] VectorXd direction() const;

    /// Of a cause that changes nothing.
    static Branch flat(Eigen::Index numbers, double lo, double hi);
    /// Through what was run: changes of the means against the null, at one or two amplitudes.
    static Branch through(const std::vector<double>& amplitudes, const std::vector<VectorXd>& changes, bool turns);
};

} // namespace tumble::diagnose
