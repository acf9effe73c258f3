#include "base/distributions.h"

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace tumble {

double chi_square_tail(double x, double degrees) {
    return x <= 0 || degrees <= 0 ? 1.0 : Eigen::numext::igammac(degrees / 2, x / 2);
}

double normal_tail(double x) {
    return 0.5 * std::erfc(x / std::sqrt(2.0));
}

double normal_quantile(double tail) {
    return -Eigen::numext::ndtri(tail);
}

double f_tail(double x, double above, double below) {
    return x <= 0 ? 1.0 : Eigen::numext::betainc(below / 2, above / 2, below / (below + above * x));
}

double student_quantile(double tail, double degrees) {
    if (std::isinf(degrees))
        return normal_quantile(tail);
    double lo = 0, hi = 1e6;
    while (hi - lo > 1e-9 * hi) {
        const double middle = (lo + hi) / 2;
        (f_tail(middle * middle, 1, degrees) > 2 * tail ? lo : hi) = middle;
    }
    return hi;
}

} // namespace tumble
