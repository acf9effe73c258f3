#include "about.h"
#include "sandbox.h"

namespace test_worked_example {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

TEST_CASE("two discs between closing walls move as (3.10) to (3.17) say, digit for digit") {
    const double k = 1000;         // N/m
    const double v = 0.1;          // m/s, of each wall
    const double dt = 0.01;        // s
    const double m_x = 1, m_y = 2; // kg
    Sandbox box(springs(k, 1, 1, 0), dt);
    const int x = box.disc(1), y = box.disc(1);
    box.scene.bodies[static_cast<std::size_t>(x)].mass = m_x;
    box.scene.bodies[static_cast<std::size_t>(y)].mass = m_y;
    box.wall(scene::SegmentShape{{-1, -2}, {-1, 2}}).motion.linears = {{{}, {v, 0, 0}}};
    box.wall(scene::SegmentShape{{3, -2}, {3, 2}}).motion.linears = {{{}, {-v, 0, 0}}};
    box.put({at(x, {0, 0}), at(y, {2, 0})});
    const auto moved = [&](std::size_t id, double from) { return box.body_at(id).position.x() - from; };

    // t0 to t1: the walls move, the discs have not felt it yet.
    box.step();
    CHECK(moved(0, 0) == 0);
    CHECK(moved(1, 2) == 0);

    // t1: overlaps (3.10), forces (3.11, 3.12), accelerations (3.13), velocities until t2 (3.14).
    const double n_1 = v * dt;
    const double f_x1 = k * n_1, f_y1 = -k * n_1;
    const double x_1 = f_x1 / m_x * dt, y_1 = f_y1 / m_y * dt;
    CHECK(f_x1 == about(1));
    box.step();
    CHECK(moved(0, 0) == about(x_1 * dt, 1e-12));
    CHECK(moved(1, 2) == about(y_1 * dt, 1e-11));

    // t2: increments of the overlaps (3.15), (3.16), (3.17), from what has moved.
    const double n_a = (v - x_1) * dt, n_b = (x_1 - y_1) * dt, n_c = (y_1 + v) * dt;
    CHECK(n_a == about(0.0009));
    CHECK(n_b == about(0.00015));
    CHECK(n_c == about(0.00095));
    CHECK(v * dt - moved(0, 0) == about(n_a, 1e-12));
    CHECK(moved(0, 0) - moved(1, 2) == about(n_b, 1e-11));
    CHECK(moved(1, 2) + v * dt == about(n_c, 1e-11));

    // The forces add up over the increments (3.27) and move the discs until t3.
    const double x_2 = x_1 + k * ((n_1 + n_a) - n_b) / m_x * dt;
    const double y_2 = y_1 + k * (n_b - (n_1 + n_c)) / m_y * dt;
    box.step();
    CHECK(moved(0, 0) == about((x_1 + x_2) * dt, 1e-11));
    CHECK(moved(1, 2) == about((y_1 + y_2) * dt, 1e-11));
}

} // namespace test_worked_example
