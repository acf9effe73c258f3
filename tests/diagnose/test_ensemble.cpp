#include "about.h"
#include "base/rng.h"
#include "diagnose/branch.h"
#include "diagnose/ensemble.h"
#include "gauss.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_ensemble {

using namespace tumble;
using namespace tumble::diagnose;
using tumble::test::about;
using tumble::test::gauss;

namespace {

/// Two numbers of deviation 2 and 3 that correlate by `share`, and one of deviation 0.1 by itself, about any mean.
Ensemble drawn(Rng& rng, int runs, double share, double mean) {
    Ensemble all(runs, 3);
    for (int k = 0; k < runs; ++k) {
        const double common = gauss(rng);
        all(k, 0) = mean + 2 * common;
        all(k, 1) = mean + 3 * (share * common + std::sqrt(1 - share * share) * gauss(rng));
        all(k, 2) = mean + 0.1 * gauss(rng);
    }
    return all;
}

} // namespace

TEST_CASE("F, Student and Hotelling have the tails of the tables") {
    CHECK(f_tail(3.708, 3, 10) == about(0.05, 1e-3)); // F(3, 10), 95 %
    CHECK(student_quantile(0.05, 10) == about(1.8125, 1e-4));
    CHECK(student_quantile(0.05, covariance_known) == about(1.6449, 1e-4));
    CHECK(hotelling_tail(1.8125 * 1.8125, 1, 10) == about(0.1, 1e-3)); // one dimension: Student's t, both sides
    // (n - p + 1) / (n p) T^2 = F: 3.708 * 3 * 12 / 10 of 12 degrees.
    CHECK(hotelling_tail(3.708 * 36 / 10, 3, 12) == about(0.05, 1e-3));
    CHECK(hotelling_tail(7.815, 3, covariance_known) == about(0.05, 1e-3)); // chi-square
    CHECK(hotelling_tail(100, 3, 2) == 1);                                  // cannot be judged
}

TEST_CASE("the largest of a library reaches higher where the scatter is estimated from few runs") {
    const MatrixXd one = MatrixXd::Identity(1, 1);
    // One cause: the square of the two-sided quantiles of t with 8 degrees and of the normal, 0.5 %.
    CHECK(quantile_of_largest(one, {}, 0.005, 1, 8) == about(3.833 * 3.833, 0.06));
    CHECK(quantile_of_largest(one, {}, 0.005, 1) == about(2.807 * 2.807, 0.04));
}

TEST_CASE("ensembles about different means show one scatter, with a degree of freedom lost for each") {
    Rng rng(3);
    std::vector<Ensemble> many;
    for (int k = 0; k < 300; ++k)
        many.push_back(drawn(rng, 4, 0.8, k));
    const Scatter scatter = pooled_scatter(many);
    CHECK(scatter.degrees == 900);
    // 1200 runs: deviations to 1 / sqrt(2 * 900) = 2.4 %, hardly any shrinkage.
    CHECK(std::sqrt(scatter.covariance(0, 0)) == about(2, 0.08));
    CHECK(std::sqrt(scatter.covariance(1, 1)) == about(3, 0.08));
    CHECK(std::sqrt(scatter.covariance(2, 2)) == about(0.1, 0.08));
    CHECK(scatter.covariance(0, 1) == about(0.8 * 6, 0.15));
    CHECK(scatter.shrinkage < 0.02);
}

TEST_CASE("few runs shrink correlations, so that the covariance can always be inverted") {
    Rng rng(4);
    const Scatter few = pooled_scatter({drawn(rng, 3, 0, 5)}); // two degrees of freedom, three numbers
    CHECK(few.degrees == 2);
    CHECK(few.shrinkage > 0.1);
    CHECK(few.covariance.determinant() > 0);
    Ensemble constant = drawn(rng, 4, 0, 5);
    constant.col(2).setConstant(7); // a number that no seed changes
    CHECK(pooled_scatter({constant}).covariance(2, 2) > 0);
}

TEST_CASE("a branch is the parabola through what was run, and a wave where the cause is an angle") {
    const auto parabola = [](double a) { return VectorXd(VectorXd::Constant(1, 3 * a - 0.5 * a * a)); };
    const Branch branch = Branch::through({2, -1}, {parabola(2), parabola(-1)}, false);
    CHECK(branch.lo == -1);
    CHECK(branch.hi == 2);
    CHECK(branch.change(1.3)[0] == about(parabola(1.3)[0]));
    CHECK(branch.slope(1.3)[0] == about(3 - 1.3));
    CHECK(branch.direction(false)[0] == about(3));
    const Branch one_sided = Branch::through({2, 1}, {parabola(2), parabola(1)}, false);
    CHECK(one_sided.change(1.5)[0] == about(parabola(1.5)[0]));
    // 4 sin + 2 (1 - cos), from a quarter turn to either side.
    const Branch wave = Branch::through({90, -90}, {VectorXd::Constant(1, 6), VectorXd::Constant(1, -2)}, true);
    CHECK(wave.change(180)[0] == about(4));
    CHECK(wave.change(30)[0] == about(2 + 2 - std::sqrt(3)));
    CHECK(wave.hi == 180);
    // Borne to one side hardly: what scatters there must not bend the rest.
    const Branch uneven = Branch::through({0.1, -2}, {VectorXd::Constant(1, 5), VectorXd::Constant(1, -4)}, false);
    CHECK(uneven.change(-1)[0] == about(-2));
    CHECK(uneven.hi == about(0.1));
    // To one side whichever way it acts: the chord, not the slope, which is nothing.
    const Branch bowl = Branch::through({2, -2}, {VectorXd::Constant(1, 4), VectorXd::Constant(1, 4)}, false);
    CHECK(bowl.odd().norm() == 0);
    CHECK(bowl.even()[0] == about(4));
    CHECK(bowl.direction(true)[0] == about(2));
}

} // namespace test_ensemble
