#include "about.h"
#include "base/rng.h"
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_neighbours {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

struct Seen {
    std::int64_t contacts = 0;
    double deepest = 0; // m
};

std::vector<Disc> discs_of(const World& world, const BodyState& body) {
    std::vector<Disc> discs = shapes_of(world)[static_cast<std::size_t>(body.shape)].discs;
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    for (Disc& disc : discs)
        disc.centre = body.position +
                      Vector2d(c * disc.centre.x() - s * disc.centre.y(), s * disc.centre.x() + c * disc.centre.y());
    return discs;
}

/// Every disc with every other, in a box of side `period` that repeats along x and y.
Seen look_at_all(const World& world, double period) {
    Seen seen;
    const std::vector<BodyState> bodies = bodies_of(world);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = i + 1; j < bodies.size(); ++j)
            for (const Disc& a : discs_of(world, bodies[i]))
                for (const Disc& b : discs_of(world, bodies[j])) {
                    Vector2d apart = a.centre - b.centre;
                    for (int axis = 0; axis < 2; ++axis)
                        apart[axis] -= period * std::round(apart[axis] / period);
                    const double overlap = a.radius + b.radius - apart.norm();
                    seen.contacts += overlap > 0 ? 1 : 0;
                    seen.deepest = std::max(seen.deepest, overlap);
                }
    return seen;
}

/// A crowded gas of discs of two sizes and of clumps, of which one has discs of the largest size that stand far out, in
/// a box that repeats.
Sandbox gas(double period, int bodies) {
    Sandbox box(springs(2e6, 0.5, 0.9, 0.4), 2e-4);
    box.scene.domain.box = {{0, 0, -0.5}, {period, period, 0.5}};
    box.scene.domain.periodic = {true, true, false};
    box.disc(0.05);
    box.disc(0.08);
    box.body({{{0, 0, 0}, 0.05}, {{0.08, 0, 0}, 0.04}, {{0.04, 0.06, 0}, 0.03}});
    box.body({{{-0.1, 0, 0}, 0.08}, {{0.1, 0, 0}, 0.08}});
    const int shapes = static_cast<int>(box.scene.bodies.size());
    for (int shape = 0; shape < shapes; ++shape) {
        scene::Fill fill;
        fill.body = shape;
        fill.count = bodies / shapes;
        fill.region = box.scene.domain.box;
        box.scene.fills.push_back(fill);
    }
    box.build();
    return box;
}

/// A gas whose bodies fly and turn, with a skin of that width, m.
Sandbox thrown_gas(double period, int bodies, double skin) {
    const Sandbox plain = gas(period, bodies);
    std::vector<BodyState> states = bodies_of(*plain.world);
    Rng rng(5);
    for (BodyState& state : states) {
        state.velocity = {rng.uniform(-3, 3), rng.uniform(-3, 3)};
        state.angular_velocity = rng.uniform(-20, 20);
    }
    Sandbox box = gas(period, 4);
    box.scene.fills.clear();
    box.scene.skin = skin;
    box.build();
    box.put(states);
    return box;
}

} // namespace

TEST_CASE("no contact is missed and none counted twice: a gas of discs and clumps against brute force") {
    const double period = 2;
    const Sandbox box = thrown_gas(period, 80, 0);
    std::int64_t contacts = 0;
    for (int k = 0; k < 1500; ++k) {
        const Seen seen = look_at_all(*box.world, period);
        box.step();
        const Books books = books_of(*box.world);
        REQUIRE(books.contacts == seen.contacts);
        REQUIRE(books.overlap_max == about(seen.deepest, 1e-9));
        contacts += seen.contacts;
    }
    CHECK(contacts > 10000);
}

TEST_CASE("the skin changes how often lists are made, not what happens") {
    // Only the order in which forces are added depends on it: rounding, which collisions let grow. 0.06 s are about
    // one collision a body, after which nothing has grown a thousandfold.
    const auto end_of = [](double skin) {
        const Sandbox box = thrown_gas(2, 60, skin);
        box.step(300);
        CHECK(books_of(*box.world).lost_sliding > 0);
        return bodies_of(*box.world);
    };
    const auto one = end_of(0), other = end_of(0.03);
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        for (int axis = 0; axis < 2; ++axis) {
            // Lists are made at other times, so one may have moved a body back by a period that the other has not.
            const double apart = one[i].position[axis] - other[i].position[axis];
            CHECK(std::abs(apart - 2 * std::round(apart / 2)) < 1e-11);
        }
}

TEST_CASE("bodies that come in later find their neighbours, and old contacts keep their springs") {
    // A disc leans on an incline by its shear spring alone; others come in far away.
    Sandbox box(springs(1e6, 1, 0.5, 0.6), 1e-4);
    box.scene.gravity = {9.81 * std::sin(0.3), -9.81 * std::cos(0.3), 0};
    box.scene.contact.global_damping = 20;
    box.wall(scene::PolylineShape{{{-5, 5}, {-5, 0}, {5, 0}, {5, 5}}, false});
    const int block = box.body({{{-0.1, 0, 0}, 0.1}, {{0.1, 0, 0}, 0.1}});
    const int disc = box.disc(0.1);
    box.put({at(block, {0, 0.1})});
    box.step(20000);
    const double before = box.body_at(0).position.x();
    for (int k = 0; k < 5; ++k) {
        box.put({at(disc, {2 + 0.3 * k, 2})});
        box.step(50);
    }
    box.step(5000);
    CHECK(std::abs(box.body_at(0).position.x() - before) < 1e-7);
    CHECK(bodies_of(*box.world).size() == 6);
}

TEST_CASE("the books close also where gravity points along a period") {
    Sandbox box(springs(1e5, 0.5, 0.9, 0.4), 1e-3);
    box.scene.domain.box = {{0, 0, -0.5}, {2, 2, 0.5}};
    box.scene.domain.periodic = {true, true, false};
    box.scene.gravity = {3, -4, 0};
    const int disc = box.disc(0.05);
    box.put({at(disc, {1, 1})});
    box.step(3000); // falls through the box ten times
    const Books books = books_of(*box.world);
    CHECK(std::abs(books.closure) < 1e-9 * books.kinetic_translation);
    CHECK(books.kinetic_translation > 0);
}

} // namespace test_neighbours
