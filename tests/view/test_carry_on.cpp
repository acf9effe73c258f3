#include "../about.h"
#include "view/carry_on.h"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace tumble;
using namespace tumble::view;
using scene::pose_at;
using test::about;

namespace test_carry_on {

constexpr double step = 1e-5; // s
constexpr double pi = std::numbers::pi;

scene::Scene with(const scene::WallMotion& motion) {
    scene::Scene scene;
    scene.time_step = step;
    scene.walls.resize(1);
    scene.walls[0].motion = motion;
    return scene;
}

scene::Scene shaken(double amplitude, double frequency, double phase, double start) {
    scene::Harmonic harmonic;
    harmonic.active.start = start;
    harmonic.amplitude = amplitude;
    harmonic.frequency = frequency;
    harmonic.phase = phase;
    scene::WallMotion motion;
    motion.harmonics.push_back(harmonic);
    return with(motion);
}

scene::Scene turned(double speed, double start) {
    scene::Rotation rotation;
    rotation.active.start = start;
    rotation.angular_velocity = speed;
    rotation.centre = {0.1, 0, 0};
    scene::WallMotion motion;
    motion.rotations.push_back(rotation);
    return with(motion);
}

/// m or -, how far the wall's pose at `now` differs between two scenes.
double jump(const scene::Scene& before, const scene::Scene& after, double now) {
    const scene::WallPose a = pose_at(before.walls[0].motion, now), b = pose_at(after.walls[0].motion, now);
    return std::max((a.translation - b.translation).norm(), (a.rotation - b.rotation).norm());
}

TEST_CASE("a swing whose frequency drifts is left alone once it has begun, and taken over before") {
    scene::Scene running = shaken(2e-3, 25, 0.7, 0.1), wanted = shaken(3e-3, 30, -1.1, 0.1);
    running.walls[0].motion.harmonics[0].drift = wanted.walls[0].motion.harmonics[0].drift = 2;
    for (const double now : {0.2, 0.5})
        CHECK(carry_on(running, wanted, now).scene.walls[0].motion.harmonics[0].amplitude == 2e-3);
    CHECK(carry_on(running, wanted, 0.05).scene.walls[0].motion.harmonics[0].amplitude == 3e-3);
}

TEST_CASE("a harmonic takes up amplitude and phase where its period ends, where it stands at zero") {
    const scene::Scene running = shaken(2e-3, 25, 0.7, 0.1), wanted = shaken(3e-3, 25, -1.1, 0.1);
    const double within = 0.1 + 3.4 / 25; // in the fourth period
    const CarriedOn waits = carry_on(running, wanted, within);
    REQUIRE(waits.next);
    CHECK(*waits.next == about(0.1 + 4.0 / 25, 1e-12));
    CHECK(jump(running, waits.scene, within) == 0);
    const double end = step * std::ceil(*waits.next / step); // the first step that has passed it
    const CarriedOn taken = carry_on(waits.scene, wanted, end);
    CHECK(!taken.next);
    const scene::Harmonic& now = taken.scene.walls[0].motion.harmonics[0];
    CHECK(now.amplitude == 3e-3);
    CHECK(now.phase == -1.1);
    CHECK(now.active.start == about(0.26, 1e-12));
    // Both curves go through zero at the period's end; a step later they are apart by the difference of their speeds at
    // most.
    const double speeds = 2 * pi * 25 * (2e-3 + 3e-3);
    CHECK(jump(running, taken.scene, end) <= speeds * step);
    CHECK(pose_at(taken.scene.walls[0].motion, now.active.start).translation.norm() == 0);
}

TEST_CASE("harmonics of one file go on with another frequency at once, from where they stand, and keep their phases") {
    // A swing and its overtone: after any change of frequency the sum is a (sin u + sin(2 u + phase) / 2 - ...) of the
    // angle u that runs faster, so that the wall is at every angle where it was at that angle before.
    scene::Scene running = shaken(2e-3, 25, 0, 0.1), wanted = shaken(2e-3, 30, 0, 0.1);
    running.walls[0].motion.harmonics.push_back(shaken(1e-3, 50, 0.9, 0.1).walls[0].motion.harmonics[0]);
    wanted.walls[0].motion.harmonics.push_back(shaken(1e-3, 60, 0.9, 0.1).walls[0].motion.harmonics[0]);
    const double now = 0.1 + 3.4 / 25;
    const CarriedOn on = carry_on(running, wanted, now);
    CHECK(!on.next);
    CHECK(jump(running, on.scene, now) < 1e-15);
    for (const double turns : {0.1, 0.37, 2.2}) {
        const scene::WallPose before = pose_at(running.walls[0].motion, now + turns / 25);
        const scene::WallPose after = pose_at(on.scene.walls[0].motion, now + turns / 30);
        CHECK((before.translation - after.translation).norm() < 1e-14);
        CHECK(after.velocity.y() == about(1.2 * before.velocity.y(), 1e-9));
    }
    // The amplitudes wait, each for the end of its own period: of the overtone the earlier.
    scene::Scene louder = wanted;
    for (scene::Harmonic& harmonic : louder.walls[0].motion.harmonics)
        harmonic.amplitude *= 2;
    const CarriedOn waits = carry_on(on.scene, louder, now);
    REQUIRE(waits.next);
    CHECK(*waits.next == about(now + 0.2 / 60, 1e-12)); // 6.8 turns of the overtone have passed
    CHECK(jump(on.scene, waits.scene, now) < 1e-15);
}

TEST_CASE("a table goes over to other factors from where it stands, no faster than its rows go") {
    // 2 mm to and fro along x, a row every 10 ms, for 2 s: at most 0.2 m/s. Thrice as far and twice as often is
    // 1.2 m/s at most; while it goes over, the way from the one to the other comes on top: 4 mm in 5 ms.
    const auto table = [](double factor, double faster) {
        scene::MotionTable rows;
        rows.active.start = 0.1;
        for (int i = 0; i <= 200; ++i) {
            rows.time.push_back(0.01 * i / faster);
            rows.displacement.emplace_back(factor * 2e-3 * (i % 2), 0, 0);
        }
        scene::WallMotion motion;
        motion.tables.push_back(rows);
        return with(motion);
    };
    const scene::Scene running = table(1, 1), wanted = table(3, 2);
    const double now = 0.1 + 0.517; // on the way back from row 51, 0.6 mm out
    const CarriedOn on = carry_on(running, wanted, now);
    CHECK(!on.next);
    CHECK(pose_at(running.walls[0].motion, now).translation.x() == about(0.6e-3, 1e-9));
    CHECK(jump(running, on.scene, now) < 1e-12);
    double last = pose_at(on.scene.walls[0].motion, now).translation.x();
    for (double t = now + step; t < now + 0.05; t += step) {
        const double x = pose_at(on.scene.walls[0].motion, t).translation.x();
        CHECK(std::abs(x - last) <= (1.2 + 4e-3 / 5e-3) * step + 1e-12);
        last = x;
    }
    // Later it is the wanted table, which was at row 51.7 when the change came.
    const double later = 0.4;
    CHECK(pose_at(on.scene.walls[0].motion, now + later).translation.x() ==
          about(pose_at(wanted.walls[0].motion, 0.1 + 0.517 / 2 + later).translation.x(), 1e-9));
    // Asked for once more it stays as it is; over, it holds its last row.
    CHECK(carry_on(on.scene, wanted, now + later).scene.walls[0].motion.tables[0].time ==
          on.scene.walls[0].motion.tables[0].time);
    CHECK(jump(running, carry_on(running, wanted, 5).scene, 5) == 0);
}

TEST_CASE("before a harmonic begins, and while its amplitude is zero, nothing need be waited for") {
    const CarriedOn before = carry_on(shaken(2e-3, 25, 0, 0.5), shaken(1e-3, 50, 1, 0.5), 0.2);
    CHECK(!before.next);
    CHECK(before.scene.walls[0].motion.harmonics[0].active.start == 0.5);
    CHECK(before.scene.walls[0].motion.harmonics[0].amplitude == 1e-3);
    const scene::Scene still = shaken(0, 25, 0, 0);
    const CarriedOn woken = carry_on(still, shaken(1e-3, 25, 0.3, 0), 0.123);
    CHECK(!woken.next);
    CHECK(woken.scene.walls[0].motion.harmonics[0].active.start == 0.123);
    CHECK(jump(still, woken.scene, 0.123) == 0);
}

TEST_CASE("a motion that the scene has stopped stays where it stopped") {
    scene::Scene running = shaken(2e-3, 25, 0, 0);
    running.walls[0].motion.harmonics[0].active.stop = 0.33;
    scene::Scene wanted = shaken(5e-3, 25, 0, 0);
    wanted.walls[0].motion.harmonics[0].active.stop = 0.33;
    const CarriedOn on = carry_on(running, wanted, 0.5);
    CHECK(!on.next);
    CHECK(jump(running, on.scene, 0.5) == 0);
}

TEST_CASE("a rotation turns on from its angle at any speed, backwards too, rests where it was halted, and goes on") {
    // 7 rad/s for 1.3 s: 9.1 rad, a full turn and 2.817 rad.
    scene::Scene running = turned(7, 0.2);
    double now = 1.5;
    for (const double speed : {11.0, -4.0, 0.0, 0.0, 2.5, -2.5}) {
        CAPTURE(speed);
        const CarriedOn on = carry_on(running, turned(speed, 0.2), now);
        CHECK(!on.next);
        CHECK(jump(running, on.scene, now) < 1e-12);
        const double later = now + 0.37;
        const double turn = Eigen::AngleAxisd(pose_at(on.scene.walls[0].motion, now).rotation.transpose() *
                                              pose_at(on.scene.walls[0].motion, later).rotation)
                                .angle();
        // The angle of a rotation matrix is between 0 and pi.
        CHECK(turn == about(std::abs(std::remainder(speed * 0.37, 2 * pi)), 1e-9));
        CHECK(pose_at(on.scene.walls[0].motion, later).angular_velocity.y() == speed);
        running = on.scene;
        now = later;
    }
}

TEST_CASE("what is not a motion changes at once") {
    scene::Scene running = shaken(2e-3, 25, 0, 0);
    scene::Scene wanted = shaken(4e-3, 25, 0, 0);
    wanted.gravity = {1, -9, 0};
    const CarriedOn on = carry_on(running, wanted, 0.01);
    CHECK(on.next);
    CHECK(on.scene.gravity == wanted.gravity);
    CHECK(on.scene.walls[0].motion.harmonics[0].amplitude == 2e-3);
}

} // namespace test_carry_on
