#include "sandbox.h"

#include <cmath>

namespace test_determinism {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;

namespace {

/// 400 discs and 200 clumps fall into a box that shakes.
Sandbox crowd(int threads, double restitution = 0.6) {
    Sandbox box(springs(4e6, 0.5, restitution, 0.4), 5e-5);
    box.scene.gravity = {0, -9.81, 0};
    box.scene.domain.box = {{-1, -1, -0.5}, {3, 6, 0.5}};
    scene::BoxShape shape;
    shape.box = {{0, 0, -0.5}, {2, 5, 0.5}};
    box.wall(shape).motion.harmonics = {{{}, 1, 0.02, 8, 0}};
    box.disc(0.03);
    box.body({{{0, 0, 0}, 0.03}, {{0.04, 0, 0}, 0.02}});
    for (int body = 0; body < 2; ++body) {
        scene::Fill fill;
        fill.body = body;
        fill.count = body == 0 ? 400 : 200;
        fill.region = {{0, 0, -0.5}, {2, 3, 0.5}};
        box.scene.fills.push_back(fill);
    }
    box.build(threads);
    return box;
}

} // namespace

TEST_CASE("one thread and two give the same bits") {
    const Sandbox one = crowd(1), two = crowd(2);
    one.step(6000);
    two.step(6000);
    const auto a = bodies_of(*one.world), b = bodies_of(*two.world);
    REQUIRE(a.size() == 600);
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].position == b[i].position);
        REQUIRE(a[i].angle == b[i].angle);
        REQUIRE(a[i].velocity == b[i].velocity);
        REQUIRE(a[i].angular_velocity == b[i].angular_velocity);
    }
    CHECK(books_of(*one.world).closure == books_of(*two.world).closure);
}

TEST_CASE("the books of a shaken crowd close, the better the shorter the step") {
    const auto missed = [](double restitution, double dt) {
        Sandbox box = crowd(1, restitution);
        box.scene.time_step = dt;
        box.build();
        box.step(std::llround(0.8 / dt));
        const Books books = books_of(*box.world);
        CHECK(books.lost_sliding > 0);
        return std::abs(books.closure) / (books.inserted + books.wall_work);
    };
    // Springs and sliding alone are of second order: 16 times better, less what is chance.
    const double coarse = missed(1, 5e-5), fine = missed(1, 1.25e-5);
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 8);
    // A dashpot's force jumps where contacts begin and end, anywhere between two steps: errors of first order each, of
    // either sign.
    const double damped = missed(0.6, 5e-5), finely_damped = missed(0.6, 1.25e-5);
    CHECK(damped < 2e-3);
    CHECK(finely_damped < damped / 4);
}

} // namespace test_determinism
