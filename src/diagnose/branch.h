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

    /// The largest amplitude that was run, and the other one: to the other side, or half of it.
    [[nodiscard]] double far_end() const;
    [[nodiscard]] double other_end() const;
    [[nodiscard]] VectorXd change(double amplitude) const;
    [[nodiscard]] VectorXd slope(double amplitude) const;
    /// What of the change at the far end turns round with the amplitude's sign, and what does not.
    [[nodiscard]] VectorXd odd() const;
    [[nodiscard]] VectorXd even() const;
    /// Change per unit that a screening goes by: the slope at the null, or the chord to the far end where most of the
    /// change is even.
    [[nodiscard]] VectorXd direction(bool mostly_even) const;

    /// Of a cause that changes nothing.
    static Branch flat(Eigen::Index numbers, double lo, double hi);
    /// Through what was run: changes of the means against the null, at one or two amplitudes. A straight line where one
    /// is much nearer to the null, which a scene does that bears little to one side.
    static Branch through(const std::vector<double>& amplitudes, const std::vector<VectorXd>& changes, bool turns);
};

} // namespace tumble::diagnose
