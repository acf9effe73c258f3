#pragma once

/// Tails and quantiles of the distributions that tests of chance need.
namespace tumble {

/// P(chi-square with so many degrees of freedom > x).
double chi_square_tail(double x, double degrees);
/// P(standard normal > x), and the x that this tail belongs to.
double normal_tail(double x);
double normal_quantile(double tail);
/// P(F with these degrees of freedom > x).
double f_tail(double x, double above, double below);
/// The x that Student's t with so many degrees of freedom, above 0, exceeds with this probability, below one half; the
/// normal's with infinitely many.
double student_quantile(double tail, double degrees);

} // namespace tumble
