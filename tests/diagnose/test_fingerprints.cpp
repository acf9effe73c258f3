// What a residual follows, against slopes that were put into it.
#include "about.h"
#include "diagnose/fingerprints.h"

#include <cmath>
#include <doctest/doctest.h>

namespace test_fingerprints {

using namespace tumble::diagnose;
using tumble::test::about;

namespace {

constexpr Eigen::Index readings = 40;

/// Readings of scatter 1 about 2 + 0.3 t; directions: a constant and time, each brought to length 1.
Evidence evidence() {
    const VectorXd time = VectorXd::LinSpaced(readings, -1, 1);
    Evidence all;
    all.residual = 2 + 0.3 * time.array();
    all.nuisances = MatrixXd::Zero(readings, 0);
    all.effects = MatrixXd(readings, 2);
    all.effects.col(0) = 5 * time;
    all.effects.col(1).setZero();
    all.causes = {{.id = "drift", .lo = -1, .hi = 1}, {.id = "nothing", .lo = -1, .hi = 1}};
    all.directions.names = {"a constant (way)", "time (way)"};
    all.directions.units = {"m", "m/s"};
    all.directions.own = {"", ""};
    all.directions.prints = MatrixXd(readings, 2);
    all.directions.prints << VectorXd::Ones(readings), time;
    all.directions.lengths = all.directions.prints.colwise().norm();
    all.directions.prints = unit_columns(all.directions.prints);
    return all;
}

} // namespace

TEST_CASE("a slope is what was put in, its error that of a straight line through readings of scatter 1") {
    const Evidence all = evidence();
    const auto prints = fingerprints_of(all, {});
    REQUIRE(prints.size() == 2);
    REQUIRE(prints[0].scene);
    CHECK(prints[0].scene->slope == about(2, 1e-9));
    CHECK(prints[0].scene->error == about(1 / std::sqrt(readings), 1e-9));
    CHECK(prints[1].scene->slope == about(0.3, 1e-9));
    CHECK(prints[1].scene->error == about(1 / VectorXd::LinSpaced(readings, -1, 1).norm(), 1e-9));
    CHECK(prints[1].scene->z == about(0.3 / prints[1].scene->error, 1e-9));
    CHECK(prints[1].unit == "m/s");
    CHECK(!prints[1].best);
}

TEST_CASE("a direction that a nuisance takes up has no slope, and one that the best explanation does is gone") {
    Evidence all = evidence();
    all.nuisances = VectorXd::Ones(readings);
    Decision decision;
    decision.best = refit_linear(all, {0});
    const auto prints = fingerprints_of(all, decision);
    CHECK(!prints[0].scene);
    REQUIRE(prints[1].scene);
    CHECK(prints[1].scene->slope == about(0.3, 1e-9));
    CHECK(!prints[1].best);
}

TEST_CASE("a cause is like the direction that its effect takes, and one that does nothing like none") {
    const Evidence all = evidence();
    const auto like = likest(all, 0);
    REQUIRE(like);
    CHECK(like->direction == 1);
    CHECK(like->share == about(1, 1e-9));
    CHECK(!likest(all, 1));
}

TEST_CASE("where nobody named directions there are no fingerprints, and slopes only where lengths are known") {
    Evidence all = evidence();
    all.directions.lengths.resize(0);
    const auto prints = fingerprints_of(all, {});
    REQUIRE(prints[1].scene);
    CHECK(std::isnan(prints[1].scene->slope));
    CHECK(prints[1].scene->z > 0);
    all.directions.names.clear();
    CHECK(fingerprints_of(all, {}).empty());
}

} // namespace test_fingerprints
