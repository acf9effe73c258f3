#include "about.h"
#include "base/distributions.h"

#include <doctest/doctest.h>
#include <limits>

namespace test_distributions {

using namespace tumble;
using tumble::test::about;

TEST_CASE("tails of chi-square and of the normal are those of the tables") {
    CHECK(chi_square_tail(3.841, 1) == about(0.05, 1e-3));
    CHECK(chi_square_tail(18.307, 10) == about(0.05, 1e-3));
    CHECK(normal_tail(1.6449) == about(0.05, 1e-3));
    CHECK(normal_quantile(0.025) == about(1.95996, 1e-4));
}

TEST_CASE("Student's t bounds 95 % where the tables say, and is the normal's in the end") {
    CHECK(student_quantile(0.025, 1) == about(12.7062, 1e-5));
    CHECK(student_quantile(0.025, 2) == about(4.30265, 1e-5));
    CHECK(student_quantile(0.025, 3) == about(3.18245, 1e-5));
    CHECK(student_quantile(0.025, 10) == about(2.22814, 1e-5));
    CHECK(student_quantile(0.025, 60) == about(2.00030, 1e-5));
    CHECK(student_quantile(0.025, std::numeric_limits<double>::infinity()) == about(1.95996, 1e-5));
}

} // namespace test_distributions
