#include "about.h"
#include "base/rng.h"
#include "sandbox.h"
#include "sim2d/mean_flow.h"

#include <cmath>

namespace test_mean_flow {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using Eigen::Matrix2d;
using tumble::test::about;

namespace {

/// Discs far apart that move as v0 + G x.
Sandbox flowing(const Vector2d& v0, const Matrix2d& gradient, std::array<bool, 3> periodic = {}) {
    Sandbox box(springs(1e6, 1, 0.5, 0.3), 1e-6);
    box.scene.domain.periodic = periodic;
    const int disc = box.disc(1e-3);
    Rng rng(3);
    std::vector<BodyState> bodies;
    for (int k = 0; k < 40; ++k) {
        const Vector2d place(rng.uniform(-1, 1), 0.05 * k);
        bodies.push_back(at(disc, place, v0 + gradient * place));
    }
    box.put(bodies);
    box.step(); // makes the rows
    return box;
}

} // namespace

TEST_CASE("bodies that move as v0 + G x are seen to do so") {
    Matrix2d gradient;
    gradient << 0.1, -2, 1.5, -0.7;
    const Vector2d v0(0.3, -1);
    const Sandbox box = flowing(v0, gradient);
    const MeanFlow flow = fit_mean_flow(*box.world);
    // The fit is held back by a millionth of the bodies' spread, so that directions without spread get no gradient; and
    // the bodies have moved for a step.
    CHECK((flow.gradient - gradient).norm() < 1e-5 * gradient.norm());
    CHECK((flow.at({0.4, 1.1}) - (v0 + gradient * Vector2d(0.4, 1.1))).norm() < 1e-5);
}

TEST_CASE("along a periodic direction the flow does not change, or it would jump at the end of the period") {
    Matrix2d gradient = Matrix2d::Zero();
    gradient(1, 0) = 3; // v_y grows along the periodic x
    gradient(0, 1) = 2;
    const Sandbox box = flowing(Vector2d::Zero(), gradient, {true, false, false});
    const MeanFlow flow = fit_mean_flow(*box.world);
    CHECK(flow.gradient.col(0).norm() == 0);
    CHECK(flow.gradient(0, 1) == about(2, 1e-5));
}

TEST_CASE("a few bodies give a mean velocity and no gradient") {
    Sandbox box(springs(1e6, 1, 0.5, 0.3), 1e-6);
    const int disc = box.disc(1e-3);
    box.put({at(disc, {0, 0}, {1, 0}), at(disc, {1, 0}, {3, 2})});
    box.step();
    const MeanFlow flow = fit_mean_flow(*box.world);
    CHECK(flow.velocity == Vector2d(2, 1));
    CHECK(flow.gradient == Matrix2d::Zero());
}

TEST_CASE("a wall that moves with the flow goes no way beside it, and one that turns goes farthest at a corner") {
    MeanFlow flow;
    flow.lo = {-1, -1};
    flow.hi = {1, 2};
    flow.velocity = {0, 3};
    const WallFrame from;
    WallFrame to = from;
    to.translation = {0, 3e-3};
    CHECK(way_beside(flow, from, to, 1e-3) < 1e-15);

    flow.velocity.setZero();
    to.translation.setZero();
    const double angle = 0.01;
    to.rotation = Eigen::Rotation2Dd(angle).toRotationMatrix();
    // The corner farthest from the axis stands sqrt(1 + 4) m off and moves along the chord.
    CHECK(way_beside(flow, from, to, 1e-3) == about(2 * std::sin(angle / 2) * std::sqrt(5.0), 1e-9));
}

TEST_CASE("a wall at rest goes as far beside the flow as one that moves by nothing, to the bit") {
    MeanFlow flow;
    flow.lo = {-1, -1};
    flow.hi = {1, 2};
    flow.velocity = {0.3, 3};
    const WallFrame pose;
    CHECK(way_past_rest(flow, 1e-3) == way_beside(flow, pose, pose, 1e-3));
    CHECK(way_past_rest(flow, 1e-3) == about(flow.velocity.norm() * 1e-3));
    flow.gradient << 0, 2, 1, 0;
    CHECK(way_past_rest(flow, 1e-3) == way_beside(flow, pose, pose, 1e-3));
    CHECK(way_past_rest(flow, 1e-3) > flow.velocity.norm() * 1e-3);
}

} // namespace test_mean_flow
