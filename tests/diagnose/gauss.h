#pragma once

#include "base/rng.h"

#include <cmath>

namespace tumble::test {

/// A number of the standard normal distribution.
inline double gauss(Rng& rng) {
    return std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(6.283185307179586 * rng.uniform());
}

} // namespace tumble::test
