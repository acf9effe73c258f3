// The two solvers held together: spheres that stay in a plane move like discs of equal mass, inertia and law. Not to
// the last digit: in space a shear spring is projected on the contact's plane, which shortens it by half the square of
// the angle that the contact turns in a step; in the plane it turns with the contact.
#include "about.h"
#include "sim2d/solver.h"
#include "sim3d/solver.h"

#include <doctest/doctest.h>
#include <functional>

namespace test_twins {

using namespace tumble;
using Eigen::Vector2d;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

constexpr double radius = 0.05;
constexpr double mass = 0.8;
constexpr double inertia = 0.4 * mass * radius * radius;

scene::Scene in_common(scene::NormalLaw normal, scene::TangentialLaw tangential) {
    scene::Scene scene;
    scene.time_step = 2e-5;
    scene.duration = 1;
    scene.gravity = {0, -9.81, 0};
    scene.domain.box = {{-2, -1, -1}, {2, 3, 1}};
    scene.materials = {{"stone", 2500, 5e6, 0.3}};
    contact::PairProperties pair;
    pair.restitution = 0.7;
    pair.friction = 0.4;
    pair.normal_stiffness = 2e4;
    pair.tangential_stiffness = 1e4;
    scene.pairs = {pair};
    // No contact pulls: the force of one that does ends with a jump, in one solver a step sooner than in the other, and
    // discs bear no friction while it pulls (docs/theory-2d.md).
    scene.contact = {normal, tangential, true, false, 0, 0, 0.05, {}};
    scene::BodyTemplate ball;
    ball.name = "ball";
    ball.spheres = {{Vector3d::Zero(), radius}};
    ball.mass = mass;
    ball.principal_inertia = Vector3d::Constant(inertia);
    scene.bodies = {ball};
    scene::Wall floor;
    floor.name = "floor";
    // A floor that shakes and rocks.
    floor.motion.harmonics = {{{}, 1, 0.01, 7, 0}};
    floor.motion.rockings = {{{}, {0, 0, 0}, {0, 0, 1}, 0.05, 3, 0}};
    floor.shape = scene::PlaneShape{{0, 0, 0}, {0, 1, 0}};
    floor.outline = scene::SegmentShape{{-2, 0}, {2, 0}};
    scene.walls = {floor};
    return scene;
}

struct Start {
    Vector2d position, velocity;
    double spin;
};
// A small heap in the air, and some that fly into it.
const std::vector<Start> starts{{{0, 0.06}, {0, 0}, 0},       {{0.11, 0.06}, {0, 0}, 3},
                                {{0.05, 0.16}, {0, -1}, -5},  {{0.4, 0.12}, {-2, 0.3}, 10},
                                {{-0.4, 0.1}, {2, 0.5}, -20}, {{0.06, 0.4}, {0.2, -2}, 0}};

/// Two spheres or discs of that radius in a row, with the ball's mass: the union's centre is the middle in both.
scene::BodyTemplate dumbbell(const scene::Scene& scene) {
    scene::BodyTemplate body = scene.bodies.front();
    body.name = "dumbbell";
    body.spheres = {{{-0.02, 0, 0}, 0.03}, {{0.02, 0, 0}, 0.03}};
    return body;
}

std::vector<sim2d::BodyState> discs_of(const scene::Scene& scene) {
    std::vector<sim2d::BodyState> discs;
    for (const Start& start : starts) {
        sim2d::BodyState disc;
        disc.shape = static_cast<int>(discs.size() % scene.bodies.size());
        disc.position = start.position;
        disc.velocity = start.velocity;
        disc.angular_velocity = start.spin;
        discs.push_back(disc);
    }
    return discs;
}

sim2d::WorldPtr plane_of(scene::Scene scene) {
    scene.dimension = 2;
    scene.depth = 1;
    auto plane = sim2d::build_world(scene, 1);
    REQUIRE_MESSAGE(plane.ok(), to_string(plane.problems()));
    REQUIRE(!sim2d::insert(**plane, discs_of(scene)));
    return std::move(*plane);
}

/// `change` is what both scenes have beyond in_common; with a second template every other body is of it. Gives the
/// discs' books.
Books compare(
    scene::NormalLaw normal, scene::TangentialLaw tangential,
    const std::function<void(scene::Scene&)>& change = [](scene::Scene&) {}) {
    scene::Scene scene = in_common(normal, tangential);
    change(scene);
    auto space = sim3d::build_world(scene, 1);
    REQUIRE_MESSAGE(space.ok(), to_string(space.problems()));
    std::vector<sim3d::BodyState> spheres;
    for (const sim2d::BodyState& disc : discs_of(scene)) {
        sim3d::BodyState sphere;
        sphere.shape = disc.shape;
        sphere.position = {disc.position.x(), disc.position.y(), 0};
        sphere.velocity = {disc.velocity.x(), disc.velocity.y(), 0};
        sphere.angular_velocity = {0, 0, disc.angular_velocity};
        spheres.push_back(sphere);
    }
    REQUIRE(!sim3d::insert(**space, spheres));
    const sim2d::WorldPtr plane = plane_of(scene);
    for (int part = 0; part < 20; ++part) {
        REQUIRE(!sim3d::advance(**space, 500));
        REQUIRE(!sim2d::advance(*plane, 500));
        const auto a = sim3d::bodies_of(**space);
        const auto b = sim2d::bodies_of(*plane);
        for (std::size_t i = 0; i < a.size(); ++i) {
            CAPTURE(part);
            CAPTURE(i);
            REQUIRE((a[i].position.head<2>() - b[i].position).norm() < 1e-6);
            REQUIRE(std::abs(a[i].position.z()) < 1e-12);
            REQUIRE((a[i].velocity.head<2>() - b[i].velocity).norm() < 1e-4);
            REQUIRE(std::abs(a[i].angular_velocity.z() - b[i].angular_velocity) < 1e-2);
        }
    }
    const Books in_space = sim3d::books_of(**space), in_plane = sim2d::books_of(*plane);
    CHECK(in_plane.lost_normal_damping == about(in_space.lost_normal_damping, 1e-4));
    CHECK(in_plane.lost_sliding == about(in_space.lost_sliding, 1e-4));
    CHECK(in_plane.lost_rolling == about(in_space.lost_rolling, 1e-4));
    // Either account reckons with a round body's own half kick: a disc gives way to shear as m*/3, a sphere as m*/3.5.
    CHECK(in_plane.lost_tangential_damping == about(in_space.lost_tangential_damping, 0.01));
    CHECK(in_plane.wall_work == about(in_space.wall_work, 1e-4));
    CHECK((in_plane.lost_sliding > 0.01 || tangential == scene::TangentialLaw::none));
    return in_plane;
}

} // namespace

TEST_CASE("spheres in a plane move like discs of equal mass, inertia and law: linear") {
    compare(scene::NormalLaw::linear, scene::TangentialLaw::linear);
}

TEST_CASE("spheres in a plane move like discs of equal mass, inertia and law: Hertz and Mindlin") {
    compare(scene::NormalLaw::hertz, scene::TangentialLaw::mindlin);
}

TEST_CASE("spheres in a plane move like discs of equal mass, inertia and law: without friction") {
    compare(scene::NormalLaw::hertz, scene::TangentialLaw::none);
}

TEST_CASE("dumbbells of two spheres in a plane move like those of two discs") {
    for (const auto& [normal, tangential] : {std::pair{scene::NormalLaw::linear, scene::TangentialLaw::linear},
                                             std::pair{scene::NormalLaw::hertz, scene::TangentialLaw::mindlin}})
        compare(normal, tangential, [](scene::Scene& scene) { scene.bodies.push_back(dumbbell(scene)); });
}

TEST_CASE("spheres in a plane move like discs where a constant torque resists their rolling") {
    for (const auto& [normal, tangential] : {std::pair{scene::NormalLaw::linear, scene::TangentialLaw::linear},
                                             std::pair{scene::NormalLaw::hertz, scene::TangentialLaw::mindlin}}) {
        const Books books = compare(normal, tangential, [](scene::Scene& scene) {
            scene.contact.additions.rolling = contact::RollingLaw::cdt;
            scene.pairs[0].rolling_friction = 0.1;
        });
        // A tenth of a ball's weight of 7.8 N, at 0.05 m, against 10 rad/s for 0.2 s is 0.08 J.
        CHECK(books.lost_rolling > 0.1);
    }
}

TEST_CASE("where contacts may pull, which they may not in the cases above, the same discs lose other energy") {
    for (const auto& [normal, tangential] : {std::pair{scene::NormalLaw::linear, scene::TangentialLaw::linear},
                                             std::pair{scene::NormalLaw::hertz, scene::TangentialLaw::mindlin}}) {
        const auto lost = [normal = normal, tangential = tangential](bool limit_force) {
            scene::Scene scene = in_common(normal, tangential);
            scene.contact.limit_force = limit_force;
            const sim2d::WorldPtr plane = plane_of(scene);
            REQUIRE(!sim2d::advance(*plane, 10000));
            return sim2d::books_of(*plane).lost_normal_damping;
        };
        CHECK(std::abs(lost(true) - lost(false)) > 0.01 * lost(true));
    }
}

} // namespace test_twins
