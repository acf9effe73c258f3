#include "about.h"
#include "base/rng.h"
#include "sandbox.h"
#include "sim3d/wall_surface.h"
#include "sim3d/world.h"

#include <array>
#include <cmath>
#include <numbers>

namespace test_bowl {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double g = 9.81;
const contact::Material plastic{"plastic", 1500, 1e7, 0.3};

scene::BowlDiscShape disc(int ribs) {
    return {Vector3d::Zero(), 0.16, 0.03, 0.03, 0.25, {ribs, 0.004, 0.012, 0.006}};
}

/// A ball at rest on a disc that begins to turn at once, 0.1 m from the axis and midway between two of twelve ribs.
Sandbox ball_on(const scene::WallShape& shape, double friction, double speed, const contact::PairProperties& base) {
    contact::PairProperties pair = base;
    pair.friction = friction;
    Sandbox box(plastic, pair, 1e-5);
    box.scene.gravity = {0, -g, 0};
    const int ball = box.ball(0.005);
    scene::Rotation turning;
    turning.angular_velocity = speed;
    box.wall(shape).motion.rotations = {turning};
    const double angle = std::numbers::pi / 12;
    box.start({placed(ball, {0.1 * std::cos(angle), 0.005, 0.1 * std::sin(angle)})});
    return box;
}

contact::PairProperties damped() {
    contact::PairProperties pair;
    pair.restitution = 0.2;
    return pair;
}

std::vector<WallTouch> touches(const WallSurface& surface, const Vector3d& centre, double radius) {
    std::vector<int> near;
    surface.primitives_near(centre, radius, near);
    std::array<WallTouch, 16> out;
    return {out.begin(), out.begin() + surface.touches(centre, radius, near, out)};
}

/// Every touch there is now, of each sphere with the disc and with each sphere of another body, found without lists.
std::int64_t touches_now(const World& world, const WallSurface& surface) {
    struct Placed {
        std::int64_t body;
        Vector3d centre;
        double radius;
    };
    std::vector<Placed> spheres;
    for (const BodyState& body : bodies_of(world))
        for (const scene::Sphere& s : shapes_of(world)[static_cast<std::size_t>(body.shape)].spheres)
            spheres.push_back({body.id, body.position + body.orientation * s.centre, s.radius});
    const scene::WallPose pose = walls_of(world).front();
    std::size_t count = 0;
    for (const Placed& a : spheres) {
        count += touches(surface, pose.rotation.transpose() * (a.centre - pose.translation), a.radius).size();
        for (const Placed& b : spheres)
            count += a.body < b.body && (a.centre - b.centre).norm() < a.radius + b.radius ? 1 : 0;
    }
    return static_cast<std::int64_t>(count);
}

} // namespace

TEST_CASE("no touch of clumps with a fast ribbed disc is ever missed or imagined") {
    Sandbox box(plastic, damped(), 1e-5);
    box.scene.gravity = {0, -g, 0};
    const int clump = box.body({{{-2e-3, 0, 0}, 3e-3}, {{2e-3, 0, 0}, 2.5e-3}, {{0, 2e-3, 1e-3}, 2e-3}});
    scene::Rotation turning;
    turning.angular_velocity = 21; // 200 rpm
    box.wall(disc(12)).motion.rotations = {turning};
    Rng rng(11);
    std::vector<BodyState> bodies;
    for (int ring = 0; ring < 4; ++ring)
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * std::numbers::pi * i / 16, away = 0.05 + 0.025 * ring;
            const Vector3d place(away * std::cos(angle), 0.012 + 0.006 * ring, away * std::sin(angle));
            bodies.push_back(placed(clump, place, {rng.uniform(-1, 1), -1, rng.uniform(-1, 1)},
                                    50 * Vector3d(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1))));
        }
    box.start(bodies);
    const auto surface = WallSurface::make(box.scene.walls.front().shape, box.scene.domain).value();
    std::int64_t seen = 0;
    for (int step = 0; step < 3000; ++step) {
        const std::int64_t expected = touches_now(*box.world, surface);
        box.run(1);
        CAPTURE(step);
        REQUIRE(books_of(*box.world).contacts == expected);
        seen += expected;
    }
    CHECK(seen > 10000);
}

TEST_CASE("without friction a smooth disc turns beneath a ball, and a rib takes it along") {
    const double speed = 4;
    Sandbox smooth = ball_on(disc(0), 0, speed, damped());
    smooth.run(20000);
    CHECK(smooth.body_now(0).velocity.norm() < 1e-3);
    Sandbox ribbed = ball_on(disc(12), 0, speed, damped());
    // The next rib is 15 degrees less its half width away: 0.052 s at 4 rad/s. Struck, the ball goes as fast as the rib
    // there or faster, e of the approach being given back.
    ribbed.run(7000);
    CHECK(ribbed.body_now(0).velocity.norm() > 0.1 * speed * 0.9);
    CHECK(ribbed.body_now(0).velocity.norm() < 0.1 * speed * 1.5);
}

TEST_CASE("a disc that turns in place drags a ball by mu g while it slides, and its list stays") {
    for (const scene::WallShape& shape :
         {scene::WallShape(disc(0)),
          scene::WallShape(scene::DiscShape{Vector3d::Zero(), Vector3d::UnitY(), 0.16, 0})}) {
        Sandbox box = ball_on(shape, 0.3, 20, damped()); // the surface passes at 2 m/s
        box.run(200);                                    // pressed to its resting depth
        const std::int64_t rebuilds = box.world->rebuilds;
        const Vector3d before = box.body_now(0).velocity;
        box.run(1000);
        CHECK((box.body_now(0).velocity - before).norm() == about(0.3 * g * 0.01, 0.02));
        CHECK(box.world->rebuilds == rebuilds);
    }
}

TEST_CASE("only a round shape that turns about its own axis turns in place") {
    scene::Wall wall;
    wall.shape = disc(0);
    CHECK(!turns_in_place(wall)); // at rest
    scene::Rotation turning;
    turning.angular_velocity = 1;
    wall.motion.rotations = {turning};
    CHECK(turns_in_place(wall));
    wall.shape = disc(12);
    CHECK(!turns_in_place(wall));
    wall.shape = scene::CylinderShape{Vector3d(0.1, 0, 0), Vector3d::UnitY(), 1, 0.1};
    CHECK(!turns_in_place(wall));
    wall.motion.rotations[0].centre = {0.1, 7, 0};
    CHECK(turns_in_place(wall));
    wall.motion.linears.push_back({{}, Vector3d::UnitY()});
    CHECK(!turns_in_place(wall));
}

TEST_CASE("a ball on the flat part, on a facet of the rim and in the middle of a rib's crest touches once") {
    const auto surface =
        WallSurface::make(disc(12), {{Vector3d::Constant(-1), Vector3d::Constant(1)}, {false, false, false}}).value();
    const double between = std::numbers::pi / 12, slope = std::numbers::pi / 4;
    for (const double out : {0.02, 0.06, 0.1}) // hub and flat part, across the edges between its triangles
        for (int i = -20; i <= 20; ++i) {
            const double angle = between + 0.002 * i;
            CHECK(touches(surface, {out * std::cos(angle), 0.0029, out * std::sin(angle)}, 0.003).size() == 1);
        }
    // A facet of the rim: from the rib's facet to its mirror image there are six, and the middle is a corner.
    const double facet = 1.25 * std::asin(0.006 / 0.13), middle = between + (between - facet) / 6;
    const Vector3d rim(0.145 * std::cos(middle), 0.0145, 0.145 * std::sin(middle));
    const Vector3d up(-std::sin(slope) * std::cos(middle), std::cos(slope), -std::sin(slope) * std::sin(middle));
    CHECK(touches(surface, rim + 0.0028 * up, 0.003).size() == 1);
    const auto crest = touches(surface, {0.1, 0.004 + 0.0029, 0.0005}, 0.003);
    REQUIRE(crest.size() == 1);
    CHECK(crest[0].normal.y() == about(1));
    CHECK(crest[0].gap == about(-0.0001));
}

} // namespace test_bowl
