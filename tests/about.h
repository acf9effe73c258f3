#pragma once

#include <doctest/doctest.h>

namespace tumble::test {

/// Equal to `value` within `relative` of the larger of the two. Approx as doctest has it adds 1 to it, so that of
/// lengths, times and energies in SI units, most of them far below 1, it accepts nearly anything. About 0 is 0 alone.
inline doctest::Approx about(double value, double relative = 1e-5) {
    return doctest::Approx(value).epsilon(relative).scale(1e-200);
}

} // namespace tumble::test
