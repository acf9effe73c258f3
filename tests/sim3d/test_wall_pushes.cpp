#include "about.h"
#include "scene/specimen.h"
#include "sim3d/sandbox.h"

#include <Eigen/Geometry>

namespace test_wall_pushes {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

scene::SpecimenShape tube() {
    scene::SpecimenShape shape;
    shape.part = solid::BoredCylinder{.length = 0.1,
                                      .radius = 0.015,
                                      .bore_radius = 0.005,
                                      .shell = 0.0015,
                                      .around = 60,
                                      .along = 12,
                                      .shell_rings = 1,
                                      .inner_rings = 1};
    shape.place = {Vector3d(0.01, -0.02, 0.03), Vector3d(0.6, 0, 0.8)};
    return scene::with_mesh(shape).value();
}

Sandbox room() {
    const contact::Material media{
        .name = "media", .density = 1665.71, .youngs_modulus = 4.6e7, .poisson_ratio = 0.2887};
    contact::PairProperties pair;
    pair.restitution = 0.67;
    pair.friction = 0.34;
    return {media, pair, 1e-6};
}

} // namespace

TEST_CASE("what pushes a specimen is what a body loses: momentum, at the facet that it names") {
    // A clump of two spheres flies at the tube obliquely and spins; over the impact the sum of force dt on the wall is
    // the momentum that the body lost, and at every step each foot lies on the facet of its triangle.
    Sandbox box = room();
    const scene::SpecimenShape specimen = tube();
    const int shape = box.body({{Vector3d(0.003, 0, 0), 0.004}, {Vector3d(-0.003, 0, 0), 0.004}});
    box.wall(specimen);
    const Vector3d middle = specimen.place.base + 0.052 * specimen.place.axis;
    const Vector3d start = middle + Vector3d(0, 0.025, 0.0005);
    box.start({placed(shape, start, Vector3d(0.4, -2, 0.3), Vector3d(20, 10, -30))});
    CHECK(wall_pushes_of(*box.world, 0).empty());

    const double mass = shapes_of(*box.world)[0].mass;
    const Vector3d before = box.body_now(0).velocity;
    Vector3d impulse = Vector3d::Zero();
    int touching = 0, at_once = 0;
    for (int step = 0; step < 8000; ++step) {
        box.run(1);
        const std::vector<WallPush> pushes = wall_pushes_of(*box.world, 0);
        for (const WallPush& push : pushes) {
            impulse += 1e-6 * push.force;
            const auto& mesh = *specimen.mesh;
            const int facet = push.triangle / 2;
            const Vector3d normal = mesh.area_of(facet).normalized();
            REQUIRE(std::abs(normal.dot(push.foot - mesh.centre_of(facet))) < 1e-12);
            REQUIRE(push.normal.norm() == about(1));
            REQUIRE(push.patch > 0);
            REQUIRE(push.patch < 0.002);            // overlaps stay below 1 mm: sqrt(4 mm 1 mm)
            REQUIRE(push.normal.dot(normal) > 0.9); // on the face, or on an edge between two that meet at 6 degrees
            if (touching == 0)
                CHECK((push.velocity - before).norm() < 0.02);
        }
        touching += pushes.empty() ? 0 : 1;
        at_once = std::max(at_once, static_cast<int>(pushes.size()));
    }
    REQUIRE(touching > 100);
    CHECK(at_once >= 1);
    CHECK(wall_pushes_of(*box.world, 0).empty()); // it has left
    const Vector3d lost = mass * (before - box.body_now(0).velocity);
    CHECK((impulse - lost).norm() < 1e-9 * lost.norm());
}

TEST_CASE("the circle of contact is that of Hertz for the force") {
    // A ball falls on the tube's round side without losing energy: at the deepest, where no dashpot acts, the force on
    // the solver's flat facet is F = 4/3 E* a^3 / R.
    contact::Material media{.name = "media", .density = 1665.71, .youngs_modulus = 4.6e7, .poisson_ratio = 0.2887};
    contact::PairProperties pair;
    pair.restitution = 1;
    Sandbox box{media, pair, 1e-6};
    const scene::SpecimenShape specimen = tube();
    const int shape = box.ball(0.004);
    box.wall(specimen);
    const Vector3d middle = specimen.place.base + 0.052 * specimen.place.axis;
    box.start({placed(shape, middle + Vector3d(0, 0.0192, 0), Vector3d(0, -1, 0))});
    double worst = 0;
    int touching = 0;
    for (int step = 0; step < 2000; ++step) {
        box.run(1);
        const auto pushes = wall_pushes_of(*box.world, 0);
        if (pushes.size() != 1)
            continue;
        ++touching;
        const double effective = 4.6e7 / (1 - 0.2887 * 0.2887) / 2; // both of the same material
        const double hertz = 4.0 / 3 * effective * std::pow(pushes[0].patch, 3) / 0.004;
        worst = std::max(worst, std::abs(-pushes[0].force.dot(pushes[0].normal) / hertz - 1));
    }
    REQUIRE(touching > 100);
    CHECK(worst < 1e-9);
}

TEST_CASE("looking at the pushes changes nothing, and two threads see the same") {
    const auto run = [](int threads, bool look) {
        Sandbox box = room();
        box.scene.gravity = Vector3d(0, -9.81, 0);
        const scene::SpecimenShape specimen = tube();
        const int shape = box.ball(0.003);
        box.wall(specimen);
        std::vector<BodyState> bodies;
        for (int k = 0; k < 30; ++k)
            bodies.push_back(placed(shape, specimen.place.base + 0.0033 * k * specimen.place.axis +
                                               Vector3d(0, 0.0185 + 0.0001 * (k % 7), 0)));
        box.start(bodies, threads);
        std::vector<double> seen;
        for (int step = 0; step < 12000; ++step) {
            box.run(1);
            if (look && step % 100 == 0)
                for (const WallPush& push : wall_pushes_of(*box.world, 0))
                    seen.insert(seen.end(), {static_cast<double>(push.body), push.foot.x(), push.force.y()});
        }
        seen.push_back(box.body_now(5).position.x());
        return seen;
    };
    const auto one = run(1, true);
    CHECK(one.size() > 60);
    CHECK(run(2, true) == one);
    CHECK(run(1, false).back() == one.back());
}

} // namespace test_wall_pushes
