// What lasts: bodies that lie, slide and roll, held to the mechanics of rigid bodies.
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_rest {

using namespace tumble;
using namespace tumble::hard2d;
using namespace tumble::hard2d::testing;

TEST_CASE("a block that slides stops after v^2 / (2 mu g)") {
    for (const double mu : {0.2, 0.5}) {
        CAPTURE(mu);
        Sandbox box(0, mu, 5e-4);
        box.gravity();
        const int block = box.block(0.05);
        box.floor();
        box.put({at(block, {-3, 0.05}, {2, 0})});
        box.run_for(1.2 * 2 / (mu * g));
        CHECK(box.body_at(0).velocity.norm() < 1e-3);
        CHECK(box.body_at(0).position.x() + 3 == about(4 / (2 * mu * g), 5e-3));
        // All its kinetic energy is gone, and nothing else but the fall by the slop has added to it.
        const double mass = box.shape(block).mass;
        CHECK(books_of(*box.world).lost_in_sum == about(mass * 2, 5e-3));
    }
}

TEST_CASE("on a slope a block stays below the angle of friction and goes down with g (sin - mu cos) above it") {
    const double mu = 0.4;
    const auto goes = [&](double angle) {
        Sandbox box(0, mu, 5e-4);
        box.gravity(angle);
        const int block = box.block(0.05);
        box.floor();
        box.put({at(block, {0, 0.05})});
        box.run_for(0.5);
        return box.body_at(0).velocity.x() / time_of(*box.world);
    };
    const double limit = std::atan(mu);
    CHECK(std::abs(goes(0.95 * limit)) < 1e-3);
    for (const double angle : {1.1 * limit, 1.5 * limit})
        CHECK(goes(angle) == about(g * (std::sin(angle) - mu * std::cos(angle)), 5e-3));
}

TEST_CASE("a disc rolls down a slope with two thirds of the block's pull") {
    Sandbox box(0, 0.5, 5e-4);
    const double angle = 0.3;
    box.gravity(angle);
    const int disc = box.disc(0.05);
    box.floor();
    box.put({at(disc, {0, 0.05})});
    box.run_for(0.5);
    CHECK(box.body_at(0).velocity.x() == about(2.0 / 3 * g * std::sin(angle) * 0.5, 5e-3));
    CHECK(box.body_at(0).angular_velocity * -0.05 == about(box.body_at(0).velocity.x(), 1e-3));
}

TEST_CASE("a column of discs stands still, each sunk into the one below by no more than Box2D's slop") {
    Sandbox box(0.5, 0.5, 1e-3);
    box.gravity();
    const double radius = 0.05;
    const int disc = box.disc(radius);
    box.floor();
    box.wall(scene::SegmentShape{{-radius, 0}, {-radius, 2}});
    box.wall(scene::SegmentShape{{radius, 0}, {radius, 2}});
    std::vector<BodyState> column;
    for (int k = 0; k < 10; ++k)
        column.push_back(at(disc, {0, (2 * k + 1) * radius}));
    box.put(column);
    box.run_for(1);
    const Books books = books_of(*box.world);
    CHECK(books.contacts >= 10);
    CHECK(books.speed_max < 2 * g * 1e-3);
    // Box2D takes a fifth of what exceeds the slop back in each pass, gravity adds g dt^2 = 1e-5 m, 0.04 slops, in a
    // step.
    CHECK(books.overlap_ratio_max < 1.05 * slop);
    double below = 0; // m, where the surface of what carries the disc stands
    for (std::size_t k = 0; k < 10; ++k) {
        CAPTURE(k);
        const double at_height = box.body_at(k).position.y() - radius;
        CHECK(below - at_height < 1.05 * slop * radius);
        CHECK(below - at_height > -0.05 * slop * radius);
        below = at_height + 2 * radius;
    }
}

TEST_CASE("a disc rolls over the joints of a straight wall as if there were none") {
    const auto rolled = [](int pieces) {
        Sandbox box(0.5, 0.5, 1e-3);
        box.gravity();
        scene::PolylineShape floor;
        for (int k = 0; k <= pieces; ++k)
            floor.points.emplace_back(-4 + 8.0 * k / pieces, 0);
        box.wall(floor);
        const int disc = box.disc(0.05);
        box.put({at(disc, {-3, 0.05}, {2, 0}, -2 / 0.05)});
        box.run_for(2);
        return box.body_at(0);
    };
    const BodyState plain = rolled(1), jointed = rolled(100);
    CHECK(plain.velocity.x() == about(2, 1e-3));
    CHECK(jointed.velocity.x() == about(2, 1e-3));
    CHECK(jointed.position.x() == about(1, 2e-3));
    CHECK(std::abs(jointed.position.y() - plain.position.y()) < slop * 0.05);
}

TEST_CASE("a disc without friction swings in a round wall as a pendulum of length R - r") {
    Sandbox box(0, 0, 5e-4);
    box.gravity();
    const double radius = 1, small = 0.05, length = radius - small, amplitude = 0.2;
    box.wall(scene::ArcShape{{0, 0}, radius, 0, 2 * std::numbers::pi});
    const int disc = box.disc(small);
    box.put({at(disc, length * Vector2d(std::sin(amplitude), -std::cos(amplitude)))});
    double passed = 0;
    int passes = 0;
    double before = box.body_at(0).position.x();
    while (passes < 5) { // every half period
        box.step();
        const double now = box.body_at(0).position.x();
        passes += now * before <= 0 ? 1 : 0;
        before = now;
        passed = time_of(*box.world);
    }
    // The first passage comes after a quarter; amplitude 0.2 makes it longer by 1/16 of its square.
    const double period = 2 * std::numbers::pi * std::sqrt(length / g) * (1 + amplitude * amplitude / 16);
    CHECK(passed == about(2.25 * period, 0.01));
}

TEST_CASE("the same world, a thousand times larger and seen in slow motion, moves alike") {
    const auto after = [](double scale) {
        const double time = std::sqrt(scale); // gravity is the same
        Sandbox box(0.5, 0.4, 1e-3 * time);
        box.scene.domain.box = {{-scale, -scale, -0.5}, {scale, scale, 0.5}};
        box.gravity();
        box.wall(scene::TroughShape{.radius = 0.5 * scale, .floor = 0, .rim = 0.8 * scale});
        const int disc = box.disc(0.05 * scale);
        std::vector<BodyState> bodies;
        for (int k = 0; k < 8; ++k)
            bodies.push_back(at(disc, scale * Vector2d(0.11 * (k % 3) - 0.1, 0.3 + 0.11 * (k / 3))));
        box.put(bodies);
        box.step(200);
        return Vector2d(box.body_at(7).position / scale);
    };
    CHECK((after(0.002) - after(2)).norm() < 1e-3);
}

} // namespace test_rest
