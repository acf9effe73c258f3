#include "about.h"
#include "sim3d/sandbox.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_wall_contact {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

using Triangle = std::array<Vector3d, 3>;

void add_square(std::vector<Triangle>& to, const Vector3d& corner, const Vector3d& u, const Vector3d& v, int cells) {
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            const Vector3d a = corner + u * i / cells + v * k / cells;
            const Vector3d b = a + u / cells;
            const Vector3d c = a + v / cells;
            to.push_back({a, b, b + v / cells});
            to.push_back({a, b + v / cells, c});
        }
}

scene::MeshShape mesh_floor(double half, int cells) {
    scene::MeshShape mesh;
    add_square(mesh.triangles, {-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}, cells);
    return mesh;
}

scene::MeshShape mesh_box(double half, int cells) {
    scene::MeshShape mesh;
    const double s = 2 * half;
    const Vector3d lo = Vector3d::Constant(-half);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, s}) {
            Vector3d u = Vector3d::Zero();
            Vector3d v = Vector3d::Zero();
            Vector3d corner = lo;
            u[(axis + 1) % 3] = s;
            v[(axis + 2) % 3] = s;
            corner[axis] += side;
            add_square(mesh.triangles, corner, u, v, cells);
        }
    return mesh;
}

/// Height above an opening of half width `half` at which a ball of radius r rests on n points of its rim, by Hertz: n
/// times the force's upward part carries the weight. Forces fall with height, so bisection finds it.
double resting_height(double r, double half, int points, double mass, double E_eff) {
    double low = 0, high = std::sqrt(r * r - half * half);
    for (int k = 0; k < 200; ++k) {
        const double height = (low + high) / 2, far = std::hypot(height, half);
        const double force = 4.0 / 3 * E_eff * std::sqrt(r) * std::pow(r - far, 1.5);
        (points * force * height / far > mass * 9.81 ? low : high) = height;
    }
    return low;
}

} // namespace

TEST_CASE("a ball comes to rest on a hole smaller than itself, in the middle, wherever on it it was dropped") {
    // The rim carries at its nearest point and the one across.
    const double r = 10e-3, hole = 8e-3, E_eff = 4.6e7 / (2 * (1 - 0.2887 * 0.2887));
    const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * 1666;
    for (const bool tube : {false, true})
        for (const double friction : {0.0, 0.3}) {
            Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, friction}, 1e-5);
            box.scene.gravity = {0, -9.81, 0};
            if (tube)
                box.wall(scene::CylinderShape{{0, -0.05, 0}, {0, 1, 0}, 0.05, hole});
            else
                box.wall(scene::DiscShape{{0, 0, 0}, {0, 1, 0}, 0.05, hole});
            box.start({placed(box.ball(r), {1e-4, 6.2e-3, 3e-5})});
            box.run(30000);
            const Vector3d at = box.body_now(0).position;
            const double height = resting_height(r, hole, 2, mass, E_eff);
            if (friction == 0) {
                CHECK(books_of(*box.world).contacts == 2);
                CHECK(std::hypot(at.x(), at.z()) < 1e-7);
                CHECK(at.y() == about(height, 1e-5));
            } else { // friction may hold it a little aside
                CHECK(std::hypot(at.x(), at.z()) < 1.1e-4);
                CHECK(at.y() == about(height, 1e-3));
            }
        }
}

TEST_CASE("a ball rests on the square hole of a sieve with four contacts, each with its share") {
    const double r = 6e-3, half = 5e-3, E_eff = 4.6e7 / (2 * (1 - 0.2887 * 0.2887));
    const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * 1666;
    scene::MeshShape sieve;
    for (int i = -1; i <= 1; ++i)
        for (int k = -1; k <= 1; ++k)
            if (i != 0 || k != 0)
                add_square(sieve.triangles, {(2 * i - 1) * half, 0, (2 * k - 1) * half}, {0, 0, 2 * half},
                           {2 * half, 0, 0}, 1);
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.3, 0.0}, 5e-6);
    box.scene.gravity = {0, -9.81, 0};
    box.wall(sieve);
    box.start({placed(box.ball(r), {0, 3.4e-3, 0})});
    box.run(40000);
    CHECK(books_of(*box.world).contacts == 4);
    CHECK(books_of(*box.world).kinetic_translation < 1e-12 * mass * 9.81 * r);
    CHECK(box.body_now(0).position.y() == about(resting_height(r, half, 4, mass, E_eff), 1e-6));
}

TEST_CASE("a ball that slides over the edges of coplanar triangles feels no jump in force") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.5, 0.3}, 2e-6);
    box.scene.gravity = {0, -9.81, 0};
    box.wall(mesh_floor(0.1, 12));
    const double r = 5e-3;
    const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * 1666;
    const double E_eff = 4.6e7 / (2 * (1 - 0.2887 * 0.2887));
    const double sink = std::pow(3 * mass * 9.81 / (4 * E_eff * std::sqrt(r)), 2.0 / 3.0);
    const double u = 0.5;
    box.start({placed(box.ball(r), {-0.05, r - sink, 0.0137}, {u, 0, 0.11}, {0.11 / r, 0, -u / r})});
    double lowest = 1e9;
    double highest = 0;
    Vector3d before = box.body_now(0).velocity;
    for (int step = 0; step < 60000; ++step) {
        box.run(1);
        const Vector3d now = box.body_now(0).velocity;
        const double push = mass * (9.81 + (now.y() - before.y()) / 2e-6);
        before = now;
        lowest = std::min(lowest, push);
        highest = std::max(highest, push);
    }
    CHECK(box.body_now(0).position.x() > 0);
    CHECK(lowest > mass * 9.81 * 0.999);
    CHECK(highest < mass * 9.81 * 1.001);
    CHECK(before.x() == about(u, 1e-3));
}

TEST_CASE("a ball that rolls over the ridge between two facets keeps the friction that turns it") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.2, 0.8}, 2e-6);
    box.scene.gravity = {0, -9.81, 0};
    // Two strips along z that fall by 20 degrees before x = 0 and by 30 after it.
    const auto down = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180;
        return Vector3d(std::cos(a), -std::sin(a), 0);
    };
    scene::MeshShape roof;
    add_square(roof.triangles, {-0.1 * down(20).x(), -0.1 * down(20).y(), -0.05}, {0, 0, 0.1}, 0.1 * down(20), 1);
    add_square(roof.triangles, {0, 0, -0.05}, {0, 0, 0.1}, 0.1 * down(30), 1);
    box.wall(roof);
    const double r = 5e-3;
    const Vector3d normal(-down(20).y(), down(20).x(), 0);
    box.start({placed(box.ball(r), -0.002 * down(20) + r * normal)});
    const auto stored = [&] { return books_of(*box.world).stored_tangential; };
    // The ball's centre passes the ridge between r sin 20 and r sin 30, slowly enough to stay on it.
    while (box.body_now(0).position.x() < 0.33 * r)
        box.run(20);
    const double before = stored();
    const double forgotten = books_of(*box.world).lost_history;
    CHECK(before > 0);
    double lowest = before;
    while (box.body_now(0).position.x() < 0.6 * r) {
        box.run(1);
        lowest = std::min(lowest, stored());
    }
    // Rolling down, friction is 2/7 of the weight's part along the slope, and more on the steeper one. Starting again
    // at either side of the ridge, the spring would pass through zero twice.
    CHECK(lowest > 0.5 * before);
    CHECK(books_of(*box.world).lost_history - forgotten < 0.2 * before);
}

TEST_CASE("a ball in a box of triangles flies as in the analytic box") {
    const auto fly = [](const scene::WallShape& shape) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.8, 0.4}, 2e-6);
        box.scene.gravity = {0, -9.81, 0};
        box.wall(shape);
        box.start({placed(box.ball(4e-3), {0.003, 0.002, -0.004}, {1.1, 0.4, -0.7}, {3, -8, 20})});
        box.run(100000);
        return box.body_now(0);
    };
    scene::BoxShape analytic;
    analytic.box = {Vector3d::Constant(-0.03), Vector3d::Constant(0.03)};
    const BodyState in_box = fly(analytic);
    for (const int cells : {1, 5}) {
        const BodyState in_mesh = fly(mesh_box(0.03, cells));
        CHECK((in_mesh.position - in_box.position).norm() < 1e-6);
        CHECK((in_mesh.velocity - in_box.velocity).norm() < 1e-4);
    }
}

TEST_CASE("a body rests in the corner of three walls with a third of nothing: each wall carries its share") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.2, 0.0}, 5e-6);
    box.scene.gravity = {-3, -9, -4};
    scene::BoxShape corner;
    corner.box = {Vector3d::Zero(), Vector3d::Constant(0.1)};
    box.wall(corner);
    const double r = 5e-3;
    box.start({placed(box.ball(r), Vector3d::Constant(1.05 * r))});
    box.run(100000);
    const double mass = 4.0 / 3.0 * std::numbers::pi * r * r * r * 1666;
    const double E_eff = 4.6e7 / (2 * (1 - 0.2887 * 0.2887));
    for (int axis = 0; axis < 3; ++axis) {
        const double weight = mass * std::abs(box.scene.gravity[axis]);
        const double sink = std::pow(3 * weight / (4 * E_eff * std::sqrt(r)), 2.0 / 3.0);
        CHECK(box.body_now(0).position[axis] == about(r - sink, 1e-9));
    }
    CHECK(books_of(*box.world).contacts == 3);
}

TEST_CASE("a shaking floor does the work that the ball gains, by the books") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.7, 0.4}, 2e-6);
    box.scene.gravity = {0, -9.81, 0};
    scene::Wall& floor = box.wall(scene::PlaneShape{});
    floor.motion.harmonics = {{{}, 1, 2e-3, 25, 0.7}, {{}, 0, 1e-3, 25, 2.2}};
    box.start({placed(box.ball(5e-3), {0, 6e-3, 0})});
    box.run(300000);
    const Books books = books_of(*box.world);
    CHECK(books.wall_work > 0);
    CHECK(std::abs(books.closure) < 2e-3 * books.wall_work);
}

TEST_CASE("a rotating disc drags a ball along at mu g until it rolls, at 2/7 of the disc's speed") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.3, 0.8}, 5e-6);
    box.scene.gravity = {0, -9.81, 0};
    scene::Wall& disc = box.wall(scene::DiscShape{{0, 0, 0}, {0, 1, 0}, 0.2, 0});
    disc.motion.rotations.push_back({{}, {0, 0, 0}, {0, 1, 0}, 3.0});
    const double r = 5e-3, belt = 3.0 * 0.05; // m/s, along -z
    box.start({placed(box.ball(r), {0.05, r, 0})});
    // The contact point gains v (1 + 5/2) on the disc, so slip ends at belt / (3.5 mu g) = 5.5 ms. Until then
    // friction's impulse is mu times the normal one, which carries the weight and whatever the ball moves up or down.
    box.run(800);
    const BodyState sliding = box.body_now(0);
    const double gained = 0.8 * (9.81 * 4e-3 + sliding.velocity.y());
    CHECK(sliding.velocity.z() == about(-gained, 0.01));
    CHECK(sliding.angular_velocity.x() == about(2.5 * gained / r, 0.01));
    box.run(1200);
    CHECK(box.body_now(0).velocity.z() == about(-belt / 3.5, 0.01));
    CHECK(books_of(*box.world).wall_work > 0);
}

TEST_CASE("a body over the border of a periodic box touches what stands on the other side") {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {1.0, 0.0}, 1e-6);
    box.scene.domain = {{{-0.02, -1, -1}, {0.02, 1, 1}}, {true, false, false}};
    const int ball = box.ball(4e-3);
    box.start({placed(ball, {0.0165, 0, 0}, {0.5, 0, 0}), placed(ball, {-0.0150, 0, 0}, {-0.5, 0, 0})});
    box.run(4000);
    // Equal masses, head on, elastic: they swap velocities.
    CHECK(box.body_now(0).velocity.x() == about(-0.5, 1e-4));
    CHECK(box.body_now(1).velocity.x() == about(0.5, 1e-4));
    CHECK(books_of(*box.world).contacts == 0);
}

TEST_CASE("two spheres of a clump that straddle the border rest on a periodic mesh floor as on a plane") {
    const auto rest = [](const scene::WallShape& shape, double x) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.3, 0.5}, 5e-6);
        box.scene.gravity = {0, -9.81, 0};
        box.scene.domain = {{{-0.03, -0.1, -0.03}, {0.03, 0.1, 0.03}}, {true, false, false}};
        const int body = box.body({{{-3e-3, 0, 0}, 3e-3}, {{3e-3, 0, 0}, 3e-3}});
        box.wall(shape);
        box.start({placed(body, {x, 3e-3, 0.001})});
        box.run(60000);
        return std::pair{box.body_now(0), books_of(*box.world).contacts};
    };
    const auto [on_plane, plane_contacts] = rest(scene::PlaneShape{}, 0);
    const auto [on_mesh, mesh_contacts] = rest(mesh_floor(0.03, 3), 0.0299);
    CHECK(plane_contacts == 2);
    CHECK(mesh_contacts == 2);
    CHECK(on_mesh.position.y() == about(on_plane.position.y(), 1e-9));
}

TEST_CASE(
    "a wall that could pass a whole sphere within one step stops the run, though they touch neither before nor after") {
    const auto goes = [](double speed) {
        Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.3, 0.5}, 1e-5);
        scene::PlaneShape plane;
        plane.point = {0, 0.0035, 0};
        box.wall(plane).motion.linears.push_back({{}, {0, speed, 0}});
        box.start({placed(box.ball(1e-3), {0, 5e-3, 0})});
        const auto problem = advance(*box.world, 2); // walls move from the second step on
        return problem ? problem->what : "";
    };
    // From half a millimetre below the sphere to half a millimetre above it.
    CHECK(goes(300).find("wall 'wall0' moves by 0.003 m in one step, more than the smallest sphere's radius") !=
          std::string::npos);
    CHECK(goes(49).empty()); // 0.49 mm
}

} // namespace test_wall_contact
