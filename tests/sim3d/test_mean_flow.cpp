#include "about.h"
#include "base/rng.h"
#include "sim3d/mean_flow.h"
#include "sim3d/sandbox.h"

#include <cmath>

namespace test_mean_flow {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using Eigen::Matrix3d;
using tumble::test::about;

namespace {

const contact::Material glass{"glass", 2500, 1e7, 0.25};

/// Balls far apart that move as v0 + G x.
Sandbox flowing(const Vector3d& v0, const Matrix3d& gradient, std::array<bool, 3> periodic = {}) {
    Sandbox box(glass, {0.5, 0.3}, 1e-6);
    box.scene.domain.periodic = periodic;
    const int ball = box.ball(1e-3);
    Rng rng(3);
    std::vector<BodyState> bodies;
    for (int k = 0; k < 40; ++k) {
        const Vector3d at(rng.uniform(-1, 1), 0.05 * k, rng.uniform(-1, 1));
        bodies.push_back(placed(ball, at, v0 + gradient * at));
    }
    box.start(bodies);
    return box;
}

} // namespace

TEST_CASE("bodies that move as v0 + G x are seen to do so") {
    Matrix3d gradient;
    gradient << 0.1, -2, 0.3, 1.5, 0, -0.7, 0.2, 0.4, -0.1;
    const Vector3d v0(0.3, -1, 2);
    const Sandbox box = flowing(v0, gradient);
    const MeanFlow flow = fit_mean_flow(*box.world);
    // The fit is held back by a millionth of the bodies' spread, so that directions without spread get no gradient.
    CHECK((flow.gradient - gradient).norm() < 1e-5 * gradient.norm());
    CHECK((flow.at({0.4, 1.1, -0.3}) - (v0 + gradient * Vector3d(0.4, 1.1, -0.3))).norm() < 1e-5);
}

TEST_CASE("along a periodic direction the flow does not change, or it would jump at the end of the period") {
    Matrix3d gradient = Matrix3d::Zero();
    gradient(1, 0) = 3; // v_y grows along the periodic x
    gradient(0, 1) = 2;
    const MeanFlow flow = fit_mean_flow(*flowing(Vector3d::Zero(), gradient, {true, false, false}).world);
    CHECK(flow.gradient.col(0).norm() == 0);
    CHECK(flow.gradient(0, 1) == about(2, 1e-5));
}

TEST_CASE("a few bodies give a mean velocity and no gradient") {
    Sandbox box(glass, {0.5, 0.3}, 1e-6);
    const int ball = box.ball(1e-3);
    box.start({placed(ball, {0, 0, 0}, {1, 0, 0}), placed(ball, {1, 0, 0}, {3, 2, 0})});
    const MeanFlow flow = fit_mean_flow(*box.world);
    CHECK(flow.velocity == Vector3d(2, 1, 0));
    CHECK(flow.gradient == Matrix3d::Zero());
}

TEST_CASE("a wall that moves with the flow goes no way beside it, and one that turns goes farthest at a corner") {
    MeanFlow flow;
    flow.box = {{-1, -1, -1}, {1, 2, 1}};
    flow.velocity = {0, 3, 0};
    const scene::WallPose from{};
    scene::WallPose to = from;
    to.translation = {0, 3e-3, 0};
    CHECK(way_beside(flow, from, to, 1e-3) < 1e-15);

    flow.velocity.setZero();
    to.translation.setZero();
    const double angle = 0.01;
    to.rotation = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    // The corner farthest from the axis stands sqrt(1 + 4) m off and moves along the chord.
    CHECK(way_beside(flow, from, to, 1e-3) == about(2 * std::sin(angle / 2) * std::sqrt(5.0)));
}

TEST_CASE("a wall at rest goes as far beside the flow as one that moves by nothing, to the bit") {
    MeanFlow flow;
    flow.box = {{-1, -1, -1}, {1, 2, 1}};
    flow.velocity = {0.3, 3, 1};
    const scene::WallPose pose{};
    CHECK(way_past_rest(flow, 1e-3) == way_beside(flow, pose, pose, 1e-3));
    CHECK(way_past_rest(flow, 1e-3) == about(flow.velocity.norm() * 1e-3));
    flow.gradient << 0, 2, 0, 1, 0, 0, 0, 0, -3;
    CHECK(way_past_rest(flow, 1e-3) == way_beside(flow, pose, pose, 1e-3));
    CHECK(way_past_rest(flow, 1e-3) > flow.velocity.norm() * 1e-3);
}

} // namespace test_mean_flow
