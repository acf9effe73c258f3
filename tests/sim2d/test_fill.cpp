// Where fills put bodies. A closed wall has two sides: a region that reaches through it fills the one it mostly lies
// on.
#include "sandbox.h"
#include "sim2d/wall_line.h"

#include <cmath>
#include <numbers>

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;

namespace {

/// 60 discs of radius 0.05 m at random in |x|, |y| <= half (m).
scene::Fill square(double half, int body) {
    scene::Fill fill;
    fill.body = body;
    fill.count = 60;
    fill.region = {{-half, -half, -0.5}, {half, half, 0.5}};
    return fill;
}

constexpr double turn = 2 * std::numbers::pi;

} // namespace

TEST_CASE("a square region about a round drum fills the drum, and nothing comes in behind its wall") {
    Sandbox box(springs(1e5, 1, 1, 0), 1e-4);
    box.wall(scene::ArcShape{{0, 0}, 1, 0, turn});
    box.scene.fills = {square(1, box.disc(0.05))};
    box.build();
    REQUIRE(bodies_of(*box.world).size() == 60);
    for (const BodyState& body : bodies_of(*box.world))
        CHECK(body.position.norm() <= 0.95);
}

TEST_CASE(
    "a small closed wall inside of a region is an obstacle, wherever it has moved to: nothing comes in inside of it") {
    for (const double shift : {0.0, 0.3}) {
        CAPTURE(shift);
        Sandbox box(springs(1e5, 1, 1, 0), 1e-4);
        const double half = 0.4;
        scene::Wall& block =
            box.wall(scene::PolylineShape{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true});
        block.motion.linears = {{{}, {shift / 0.01, 0, 0}}};
        box.scene.fills = {square(1, box.disc(0.05))};
        box.scene.fills[0].start = box.scene.fills[0].until = 0.01;
        box.build();
        box.step(101);
        REQUIRE(bodies_of(*box.world).size() == 60);
        for (const BodyState& body : bodies_of(*box.world))
            CHECK((body.position - Vector2d(shift, 0)).cwiseAbs().maxCoeff() > half);
    }
}

TEST_CASE("walls with an open end have no inside") {
    const scene::Domain domain{{{-5, -5, -1}, {5, 5, 1}}, {false, false, false}};
    CHECK(WallLine(scene::ArcShape{{0, 0}, 1, 0, turn}, domain).closed());
    CHECK(WallLine(scene::BoxShape{{{-1, -1, 0}, {1, 1, 0}}, {}}, domain).closed());
    CHECK(!WallLine(scene::ArcShape{{0, 0}, 1, 0, 0.9 * turn}, domain).closed());
    CHECK(!WallLine(scene::PolylineShape{{{0, 0}, {1, 0}, {1, 1}}, false}, domain).closed());
    const WallLine ring(scene::ArcShape{{0, 0}, 1, 0, turn}, domain);
    CHECK(ring.encloses({0.7, -0.7}));
    CHECK(!ring.encloses({0.72, -0.72}));
    CHECK(!WallLine(scene::SegmentShape{{-1, 0}, {1, 0}}, domain).encloses({0, 0}));
}
