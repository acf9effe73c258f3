#include "sandbox.h"
#include "sim2d/world.h"

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

void same_bits(const Sandbox& one, const Sandbox& other) {
    const auto a = bodies_of(*one.world), b = bodies_of(*other.world);
    REQUIRE(a.size() == 600);
    REQUIRE(b.size() == 600);
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].position == b[i].position);
        REQUIRE(a[i].angle == b[i].angle);
        REQUIRE(a[i].velocity == b[i].velocity);
        REQUIRE(a[i].angular_velocity == b[i].angular_velocity);
    }
    CHECK(books_of(*one.world).closure == books_of(*other.world).closure);
}

/// The laws that kernels are built for.
enum class Law { linear, hertz, full };

Sandbox crowd_under(Law law, const Kernels* kernels) {
    Sandbox box = crowd(1);
    if (law != Law::linear) {
        box.scene.materials[0].youngs_modulus = 1e9;
        box.scene.materials[0].poisson_ratio = 0.3;
        box.scene.contact.normal = scene::NormalLaw::hertz;
        box.scene.contact.tangential = scene::TangentialLaw::mindlin;
    }
    if (law == Law::full) {
        box.scene.pairs[0].rolling_friction = 0.05;
        box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
    }
    box.build();
    box.world->kernels = kernels;
    box.step(12000);
    return box;
}

} // namespace

TEST_CASE("one thread and two give the same bits") {
    const Sandbox one = crowd(1), two = crowd(2);
    one.step(6000);
    two.step(6000);
    same_bits(one, two);
}

TEST_CASE("every instruction set that this machine has gives the same bits, whatever the law") {
    for (const Law law : {Law::linear, Law::hertz, Law::full}) {
        CAPTURE(static_cast<int>(law));
        const Sandbox baseline = crowd_under(law, kernels_named("baseline"));
        CHECK(books_of(*baseline.world).contacts > 300);
        for (const char* name : {"x86-64-v3", "x86-64-v4"})
            if (const Kernels* kernels = kernels_named(name))
                same_bits(baseline, crowd_under(law, kernels));
            else
                MESSAGE("this processor lacks " << name);
    }
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
