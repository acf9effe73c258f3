// Walls that move: they arrive where their motion says, carry what lies on them, and their work is booked.
#include "sandbox.h"

#include <cmath>
#include <numbers>

namespace test_walls {

using namespace tumble;
using namespace tumble::hard2d;
using namespace tumble::hard2d::testing;

TEST_CASE("a rising floor lifts a disc and does the work of its weight") {
    Sandbox box(0, 0.5, 1e-3);
    box.gravity();
    const int disc = box.disc(0.05);
    box.floor().motion.linears = {{{0.2, 1.2}, {0, 1.5, 0}}};
    box.put({at(disc, {0, 0.05})});
    box.run_for(0.2);
    const double before = books_of(*box.world).wall_work, low = box.body_at(0).position.y();
    box.run_for(0.8);
    CHECK(box.body_at(0).velocity.y() == about(1.5, 1e-3));
    const double risen = box.body_at(0).position.y() - low, mass = box.shape(disc).mass;
    CHECK(risen == about(0.8 * 1.5, 2e-3));
    // Setting it in motion from rest without rebound costs m v^2, of which half is lost; then m g h.
    CHECK(books_of(*box.world).wall_work - before == about(mass * (1.5 * 1.5 + g * risen), 0.01));
    CHECK(books_of(*box.world).lost_in_sum == about(mass * 1.5 * 1.5 / 2, 0.02));
}

TEST_CASE("a plate that shakes below one g carries its load, period after period, without drifting from its motion") {
    Sandbox box(0, 0.5, 5e-4);
    box.gravity();
    const double frequency = 10, w = 2 * std::numbers::pi * frequency, amplitude = 0.6 * g / (w * w);
    const int disc = box.disc(0.02);
    box.floor().motion.harmonics = {{{}, 1, amplitude, frequency, 0}};
    box.put({at(disc, {0, 0.02})});
    for (int period = 0; period < 20; ++period) {
        box.run_for(0.25 / frequency); // at the top
        CHECK(box.body_at(0).position.y() - 0.02 - amplitude > -3 * slop * 0.02);
        CHECK(box.body_at(0).position.y() - 0.02 - amplitude < slop * 0.02);
        box.run_for(0.75 / frequency);
        CHECK(std::abs(box.body_at(0).position.y() - 0.02) < 3 * slop * 0.02);
    }
}

TEST_CASE("a belt takes a block along: it slips for v / (mu g), and as much is lost as it gains") {
    Sandbox box(0, 0.3, 5e-4);
    box.gravity();
    const int block = box.block(0.05);
    box.floor().motion.linears = {{{}, {1, 0, 0}}};
    box.put({at(block, {0, 0.05})});
    box.run_for(0.5 / (0.3 * g));
    CHECK(box.body_at(0).velocity.x() == about(0.5, 5e-3));
    box.run_for(1 / (0.3 * g));
    CHECK(box.body_at(0).velocity.x() == about(1, 1e-3));
    const double mass = box.shape(block).mass;
    CHECK(books_of(*box.world).wall_work == about(mass, 0.01));
    CHECK(books_of(*box.world).lost_in_sum == about(mass / 2, 0.02));
}

TEST_CASE("a turning arm, round a point beside it and for many turns, pushes with the speed of its surface") {
    Sandbox box(1, 0, 2e-4);
    const double w = 20;
    const int disc = box.disc(0.05);
    box.wall(scene::SegmentShape{{0.2, 0}, {1, 0}}).motion.rotations = {{{}, {0, 0, 0}, {0, 0, 1}, w}};
    box.build();
    const double turn = 2 * std::numbers::pi / w;
    box.run_for(10 * turn);
    // Put just before the arm, which has come round to where it began: an elastic impact doubles its speed there.
    const double since = time_of(*box.world) - 10 * turn;
    const double height = 0.5 * std::tan(w * since) + 0.06;
    box.put({at(disc, {0.5, height})});
    box.run_for(0.01);
    CHECK(box.body_at(0).velocity.norm() == about(2 * w * 0.5, 0.03));
}

TEST_CASE("walls touch from both sides") {
    Sandbox box(1, 0, 5e-4);
    const int disc = box.disc(0.05);
    box.wall(scene::SegmentShape{{-1, 0}, {1, 0}});
    box.wall(scene::PolylineShape{{{2, -1}, {2.5, 0}, {2, 1}}, false});
    box.wall(scene::ArcShape{{-3, 0}, 0.5, 0, 2 * std::numbers::pi});
    box.put({at(disc, {0, 0.2}, {0, -1}), at(disc, {0.5, -0.2}, {0, 1}), at(disc, {2, 0}, {2, 0}),
             at(disc, {3, 0.1}, {-2, 0}), at(disc, {-3, 0}, {0, 3}), at(disc, {-3, 0.8}, {0, -1})});
    box.run_for(0.4);
    CHECK(box.body_at(0).velocity.y() == about(1, 1e-4));
    CHECK(box.body_at(1).velocity.y() == about(-1, 1e-4));
    CHECK(box.body_at(2).position.x() < 2.5); // it ran into the corner and came back
    CHECK(box.body_at(3).position.x() > 2.4);
    CHECK((box.body_at(4).position - Vector2d(-3, 0)).norm() < 0.45 + 1e-3);
    CHECK(box.body_at(5).velocity.y() == about(1, 1e-2));
}

} // namespace test_walls
