#include "about.h"
#include "diagnose/statistics.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_statistics {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;

TEST_CASE("the best of independent causes needs Sidak's quantile, and of equal ones that of a single cause") {
    // P(max of k chi-squares of one degree < x) = (1 - tail(x))^k; at alpha = 0.01 a fortieth of that is the drawing's
    // error.
    const double one = std::pow(normal_quantile(0.005), 2);
    const double each = 1 - std::pow(0.99, 1.0 / 8);
    const double eight = std::pow(normal_quantile(each / 2), 2);
    CHECK(quantile_of_largest(MatrixXd::Identity(8, 8), {}, 0.01, 3) == about(eight, 0.04));
    CHECK(quantile_of_largest(MatrixXd::Ones(8, 8), {}, 0.01, 3) == about(one, 0.05));
    // Of one side each, twice as rare: the tail of each is one-sided. Of both sides of one and the same, as of one
    // cause.
    const std::vector<Side> above(8, Side::above);
    CHECK(quantile_of_largest(MatrixXd::Identity(8, 8), above, 0.01, 3) ==
          about(std::pow(normal_quantile(each), 2), 0.05));
    CHECK(quantile_of_largest(MatrixXd::Ones(2, 2), {Side::above, Side::below}, 0.01, 3) == about(one, 0.05));
}

TEST_CASE("a projector takes out a span once, however often its columns say the same") {
    MatrixXd columns(4, 3);
    columns << 1, 2, 0, 1, 2, 0, 0, 0, 1, 0, 0, 1;
    const Projector projector(columns);
    CHECK(projector.rank() == 2);
    const VectorXd vector = (VectorXd(4) << 3, 1, 5, 1).finished();
    const VectorXd left = (VectorXd(4) << 1, -1, 2, -2).finished();
    CHECK((projector.out(vector) - left).norm() < 1e-14 * vector.norm()); // rounding
    CHECK(projector.inside(vector) == about(vector.squaredNorm() - left.squaredNorm()));
}

} // namespace test_statistics
