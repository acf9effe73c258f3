#include "about.h"
#include "frames.h"
#include "observe/bulk.h"

#include <doctest/doctest.h>

namespace test_bulk {

using namespace tumble;
using namespace tumble::test;

namespace {

/// A grid of balls in the y-z plane about `centre`.
observe::Frame grid(const Vector3d& centre) {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 0.5));
    for (int j = -3; j <= 3; ++j)
        for (int k = -5; k <= 5; ++k)
            add_body(frame, centre + Vector3d(0.01 * j * k, 0.02 * j, 0.02 * k));
    return frame;
}

} // namespace

TEST_CASE("a bulk that turns like a rigid body circulates at exactly that rate, wherever it drifts") {
    const double omega = -0.37; // rad/s about +x
    const Vector3d drift(0.3, -1.1, 0.8);
    observe::Frame frame = grid({0.0, 0.2, -0.1});
    for (std::size_t i = 0; i < frame.bodies(); ++i)
        frame.velocity[i] = drift + Vector3d(omega, 0, 0).cross(frame.position[i] - Vector3d(0, 0.2, -0.1));
    const observe::BulkMotion bulk = observe::bulk_motion(frame);
    CHECK(bulk.circulation == about(omega, 1e-13));
    CHECK((bulk.centre - Vector3d(0, 0.2, -0.1)).norm() < 1e-14);
    CHECK((bulk.velocity - drift).norm() < 1e-14);
}

TEST_CASE("positive circulation turns y towards z") {
    observe::Frame frame;
    frame.layout = open_layout(ball(0.01, 1));
    add_body(frame, {0, 0.1, 0}, {0, 0, 0.2});   // above the centre, towards +z
    add_body(frame, {0, -0.1, 0}, {0, 0, -0.2}); // below, towards -z
    CHECK(observe::bulk_motion(frame).circulation == about(2.0));
}

TEST_CASE("bodies that only spin, or a bulk that only shears along x, do not circulate") {
    observe::Frame frame = grid({0, 0, 0});
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        frame.angular_velocity[i] = {50, 0, 0};
        frame.velocity[i] = {3 * frame.position[i].y(), 0, 0};
    }
    CHECK(observe::bulk_motion(frame).circulation == 0.0);
}

TEST_CASE("pure shear turns a round bulk at half the shear rate") {
    observe::Frame frame; // four bodies on a circle; v_z = g y has vorticity g and rigid part g/2
    frame.layout = open_layout(ball(0.01, 1));
    for (const Vector3d& at : {Vector3d(0, 0.1, 0), Vector3d(0, -0.1, 0), Vector3d(0, 0, 0.1), Vector3d(0, 0, -0.1)})
        add_body(frame, at, {0, 0, 3.0 * at.y()});
    CHECK(observe::bulk_motion(frame).circulation == about(1.5));
}

TEST_CASE("kinetic energy splits into translation and rotation of the principal frame") {
    observe::Frame frame;
    observe::FrameShape shape = ball(0.01, 2.0);
    shape.inertia = {1e-4, 2e-4, 5e-4};
    frame.layout = open_layout(shape);
    add_body(frame, {0, 0, 0}, {3, 0, 4}, {0, 0, 10});
    // A quarter turn about x brings the principal y axis to the world's z axis: its 2e-4 kg m2 counts.
    frame.orientation[0] = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX());
    const observe::BulkMotion bulk = observe::bulk_motion(frame);
    CHECK(bulk.kinetic_translation == about(0.5 * 2.0 * 25));
    CHECK(bulk.kinetic_rotation == about(0.5 * 2e-4 * 100));
    CHECK(bulk.mean_speed == about(5.0));
    CHECK(bulk.mean_angular_speed == about(10.0));
}

TEST_CASE("means weigh by mass") {
    auto layout = open_layout(ball(0.01, 1));
    layout->shapes.push_back(ball(0.02, 3));
    observe::Frame frame;
    frame.layout = layout;
    add_body(frame, {0, 0, 0}, {0, 2, 0});
    add_body(frame, {0, 4, 0}, {0, -2, 0});
    frame.shape[1] = 1;
    const observe::BulkMotion bulk = observe::bulk_motion(frame);
    CHECK(bulk.mass == 4);
    CHECK(bulk.centre.y() == about(3.0));     // (1*0 + 3*4)/4
    CHECK(bulk.velocity.y() == about(-1.0));  // (2 - 6)/4
    CHECK(bulk.rms_velocity.y() == about(2)); // both move at 2
}

TEST_CASE("without bodies or across a periodic z there is no circulation") {
    observe::Frame empty;
    empty.layout = open_layout(ball(0.01, 1));
    CHECK(std::isnan(observe::bulk_motion(empty).circulation));
    CHECK(std::isnan(observe::bulk_motion(empty).centre.y()));
    CHECK(observe::bulk_motion(empty).kinetic_translation == 0);
    observe::Frame frame = grid({0, 0, 0});
    auto layout = open_layout(ball(0.01, 1));
    layout->periodic[2] = true;
    frame.layout = layout;
    CHECK(std::isnan(observe::bulk_motion(frame).circulation));
}

} // namespace test_bulk
