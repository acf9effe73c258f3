#include "about.h"
#include "scene/motion.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace test_motion {

using namespace tumble::scene;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

WallMotion everything() {
    WallMotion motion;
    motion.harmonics = {{{0.0, infinite}, 1, 2e-3, 25.0, 0.4},
                        {{0.1, 0.9}, 2, 1e-3, 50.0, -1.1},
                        {{0.05, 0.8}, 0, 1e-3, 30.0, 0.2, 12}};
    motion.rotations = {{{0.05, infinite}, Vector3d(0.1, 0, 0.2), Vector3d(0, 0.6, 0.8), 3.0}};
    motion.rockings = {{{0.0, infinite}, Vector3d(0, 0.3, 0), Vector3d::UnitX(), 0.2, 4.0, 0.7},
                       {{0.0, infinite}, Vector3d(0, 0, 0.1), Vector3d::UnitZ(), 0.1, 7.0, 0.0, -0.3}};
    motion.linears = {{{0.0, infinite}, Vector3d(0.01, -0.02, 0.03)}};
    motion.tables = {
        {{0.2, infinite}, {0, 0.3, 0.5}, {Vector3d::Zero(), Vector3d(0.01, 0, 0), Vector3d(0, 0.02, 0.01)}}};
    return motion;
}

/// Central differences of the pose against the rates that come with it; the time is away from any start, stop or row.
void check_rates(const WallMotion& motion, double t) {
    const double h = 1e-6;
    const WallPose before = pose_at(motion, t - h), now = pose_at(motion, t), after = pose_at(motion, t + h);
    for (const Vector3d& local : {Vector3d(0, 0, 0), Vector3d(0.3, -0.2, 0.5)}) {
        const Vector3d moved =
            after.rotation * local + after.translation - before.rotation * local - before.translation;
        const Vector3d rate = now.velocity_at(now.rotation * local + now.translation);
        CHECK((moved / (2 * h) - rate).norm() < 1e-8 * std::max(1.0, rate.norm()));
    }
    CHECK((now.rotation.transpose() * now.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-14);
}

} // namespace

TEST_CASE("harmonics with phases are exact after a million steps") {
    // f dt is a ratio of whole numbers, so the phase at step n is known without rounding: f = 25 Hz, dt = 1/350000 s
    // gives n / 14000 turns; n = 1 000 003 leaves 6003 / 14000 of a turn. The odd one: f = 175/4 Hz gives n / 8000.
    const std::int64_t n = 1'000'003;
    const double t = static_cast<double>(n) / 350000.0;
    WallMotion motion;
    motion.harmonics = {{{}, 1, 4e-3, 25.0, 0.3}, {{}, 2, 8e-4, 43.75, -2.0}, {{}, 1, 1e-3, 175.0, 1.5}};
    const double a = 2 * pi * (static_cast<double>(n % 14000) / 14000.0) + 0.3;
    const double b = 2 * pi * (static_cast<double>(n % 8000) / 8000.0) - 2.0;
    const double c = 2 * pi * (static_cast<double>(n % 2000) / 2000.0) + 1.5;
    const WallPose pose = pose_at(motion, t);
    const double y = 4e-3 * (std::sin(a) - std::sin(0.3)) + 1e-3 * (std::sin(c) - std::sin(1.5));
    const double z = 8e-4 * (std::sin(b) - std::sin(-2.0));
    CHECK(std::abs(pose.translation.y() - y) < 1e-9 * 1e-3);
    CHECK(std::abs(pose.translation.z() - z) < 1e-9 * 8e-4);
    CHECK(pose.translation.x() == 0);
    const double vy = 4e-3 * 50 * pi * std::cos(a) + 1e-3 * 350 * pi * std::cos(c);
    CHECK(std::abs(pose.velocity.y() - vy) < 1e-9 * 1e-3 * 350 * pi);
    CHECK(std::abs(pose.velocity.z() - 8e-4 * 87.5 * pi * std::cos(b)) < 1e-9 * 8e-4 * 87.5 * pi);
    CHECK((pose.rotation - Eigen::Matrix3d::Identity()).norm() == 0);
}

TEST_CASE("a harmonic starts without a jump whatever its phase, and starts at its own time") {
    WallMotion motion;
    motion.harmonics = {{{0.5, infinite}, 0, 0.01, 10.0, 1.0}};
    CHECK(pose_at(motion, 0.499).translation.norm() == 0);
    CHECK(pose_at(motion, 0.499).velocity.norm() == 0);
    CHECK(pose_at(motion, 0.5).translation.norm() < 1e-17);
    CHECK(pose_at(motion, 0.5).velocity.x() == about(0.01 * 20 * pi * std::cos(1.0), 1e-14));
    CHECK(pose_at(motion, 0.525).translation.x() == about(0.01 * (std::sin(pi / 2 + 1.0) - std::sin(1.0)), 1e-12));
}

TEST_CASE("a frequency that drifts is f + drift t after t, and its phase runs ahead with the square of time") {
    WallMotion motion;
    motion.harmonics = {{{0.5, infinite}, 1, 2e-3, 20.0, 0.3, 4.0}};
    // After 3 s: 20 * 3 + 4 * 9 / 2 = 78 turns; after 2.5 s: 50 + 12.5, half a turn more.
    CHECK(std::abs(pose_at(motion, 3.5).translation.y()) < 1e-15);
    CHECK(pose_at(motion, 3.5).velocity.y() == about(2e-3 * 2 * pi * (20 + 12) * std::cos(0.3), 1e-12));
    CHECK(pose_at(motion, 3.0).translation.y() == about(-2 * 2e-3 * std::sin(0.3), 1e-12));
    WallMotion steady = motion, none = motion;
    steady.harmonics[0].drift = 0;
    none.harmonics[0] = {{0.5, infinite}, 1, 2e-3, 20.0, 0.3};
    for (double t = 0; t < 4; t += 0.013)
        CHECK(pose_at(steady, t).translation == pose_at(none, t).translation);
}

TEST_CASE("every part holds at its stop what it had reached, with no velocity") {
    WallMotion motion = everything();
    const double stop = 0.37;
    for (auto& part : motion.harmonics)
        part.active.stop = stop;
    for (auto& part : motion.rotations)
        part.active.stop = stop;
    for (auto& part : motion.rockings)
        part.active.stop = stop;
    for (auto& part : motion.linears)
        part.active.stop = stop;
    for (auto& part : motion.tables)
        part.active.stop = stop;
    const WallPose running = pose_at(everything(), stop);
    for (double t : {stop, 0.5, 1e3}) {
        const WallPose held = pose_at(motion, t);
        CHECK(held.velocity.norm() == 0);
        CHECK(held.angular_velocity.norm() == 0);
        CHECK((held.translation - running.translation).norm() < 1e-15);
        CHECK((held.rotation - running.rotation).norm() < 1e-14);
    }
    CHECK(running.velocity.norm() > 0.01);
}

TEST_CASE("a part whose stop is not after its start never acts") {
    WallMotion motion;
    motion.linears = {{{0.5, 0.5}, Vector3d::UnitX()}};
    motion.rotations = {{{0.5, 0.2}, Vector3d::Zero(), Vector3d::UnitY(), 1.0}};
    CHECK(pose_at(motion, 2).translation.norm() == 0);
    CHECK((pose_at(motion, 2).rotation - Eigen::Matrix3d::Identity()).norm() == 0);
    CHECK(speed_bound(motion, Vector3d::Zero(), 1) == 0);
}

TEST_CASE("a rotation turns points about its centre and is exact after ten thousand turns") {
    WallMotion motion;
    motion.rotations = {{{}, Vector3d(1, 0, 0), Vector3d::UnitY(), 20 * pi}};
    const WallPose pose = pose_at(motion, 1000.025); // 10000.25 turns
    const Vector3d world = pose.rotation * Vector3d(3, 5, 0) + pose.translation;
    CHECK((world - Vector3d(1, 5, -2)).norm() < 1e-10); // +x turns to -z about +y
    CHECK((pose.velocity_at(world) - 20 * pi * Vector3d(-2, 0, 0)).norm() < 1e-8);
}

TEST_CASE("rocking swings by its amplitude and its velocity peaks in the middle") {
    WallMotion motion;
    motion.rockings = {{{}, Vector3d(0, 1, 0), Vector3d::UnitX(), 0.1, 2.0, 0.0}};
    const WallPose middle = pose_at(motion, 0.5);
    CHECK((middle.rotation - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK((middle.angular_velocity - Vector3d(0.1 * 4 * pi, 0, 0)).norm() < 1e-13);
    const WallPose end = pose_at(motion, 0.125);
    const Vector3d low = end.rotation * Vector3d(0, 0, 0) + end.translation;
    CHECK((low - Vector3d(0, 1 - std::cos(0.1), -std::sin(0.1))).norm() < 1e-14);
    CHECK(end.velocity_at(low).norm() < 1e-14);
}

TEST_CASE("two rotations act one after the other about points of the unmoved wall") {
    WallMotion motion;
    motion.rotations = {{{}, Vector3d(1, 0, 0), Vector3d::UnitZ(), pi / 2},
                        {{}, Vector3d::Zero(), Vector3d::UnitX(), pi / 2}};
    motion.linears = {{{}, Vector3d(0, 0, 7)}};
    const WallPose pose = pose_at(motion, 1.0);
    // (2,0,0) -> about (1,0,0), z: (1,1,0) -> about 0, x: (1,0,1) -> shifted by 7 z
    CHECK((pose.rotation * Vector3d(2, 0, 0) + pose.translation - Vector3d(1, 0, 8)).norm() < 1e-14);
}

TEST_CASE("a table is linear between its rows and holds its last row") {
    WallMotion motion;
    motion.tables = {{{1.0, infinite}, {0, 0.1, 0.3}, {Vector3d::Zero(), Vector3d(0, 0.02, 0), Vector3d(0.04, 0, 0)}}};
    CHECK(pose_at(motion, 0.9).translation.norm() == 0);
    CHECK((pose_at(motion, 1.05).translation - Vector3d(0, 0.01, 0)).norm() < 1e-15);
    CHECK((pose_at(motion, 1.05).velocity - Vector3d(0, 0.2, 0)).norm() < 1e-14);
    CHECK((pose_at(motion, 1.2).translation - Vector3d(0.02, 0.01, 0)).norm() < 1e-15);
    CHECK((pose_at(motion, 1.2).velocity - Vector3d(0.2, -0.1, 0)).norm() < 1e-14);
    CHECK((pose_at(motion, 5).translation - Vector3d(0.04, 0, 0)).norm() == 0);
    CHECK(pose_at(motion, 5).velocity.norm() == 0);
}

TEST_CASE("surface velocity is the derivative of position for every kind of motion and for all together") {
    const WallMotion all = everything();
    WallMotion alone;
    for (double t : {0.03, 0.17, 0.333, 0.61, 1.3}) {
        check_rates(all, t);
        alone = {}, alone.harmonics = all.harmonics, check_rates(alone, t);
        alone = {}, alone.rotations = all.rotations, check_rates(alone, t);
        alone = {}, alone.rockings = all.rockings, check_rates(alone, t);
        alone = {}, alone.linears = all.linears, check_rates(alone, t);
        alone = {}, alone.tables = all.tables, check_rates(alone, t);
    }
}

TEST_CASE("displacements add up and do not depend on what else moves") {
    const WallMotion all = everything();
    WallMotion turns, shifts;
    turns.rotations = all.rotations, turns.rockings = all.rockings;
    shifts.harmonics = all.harmonics, shifts.linears = all.linears, shifts.tables = all.tables;
    const double t = 0.61;
    CHECK((pose_at(all, t).translation - pose_at(turns, t).translation - pose_at(shifts, t).translation).norm() <
          1e-16);
    CHECK((pose_at(all, t).rotation - pose_at(turns, t).rotation).norm() == 0);
}

TEST_CASE("no point moves faster than the speed bound, and one harmonic reaches it") {
    const WallMotion all = everything();
    const Vector3d centre(0.2, 0.1, -0.3);
    const double bound = speed_bound(all, centre, 0.5);
    double fastest = 0;
    for (int i = 0; i < 2000; ++i) {
        const WallPose pose = pose_at(all, i * 1e-3);
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d way(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            const Vector3d local = centre + 0.5 * way.normalized();
            fastest = std::max(fastest, pose.velocity_at(pose.rotation * local + pose.translation).norm());
        }
    }
    CHECK(fastest < bound);
    CHECK(bound < 4 * fastest);
    WallMotion one;
    one.harmonics = {{{}, 1, 4e-3, 25.0, 0.3}};
    CHECK(speed_bound(one, centre, 10) == about(4e-3 * 50 * pi, 1e-14));
    one.harmonics[0].drift = 1; // it may double
    CHECK(speed_bound(one, centre, 10) == about(4e-3 * 100 * pi, 1e-14));
    CHECK(speed_bound({}, centre, 10) == 0);
}

} // namespace test_motion
