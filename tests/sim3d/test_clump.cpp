#include "about.h"
#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <cmath>
#include <numbers>

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

Vector3d angular_momentum(const BodyState& body, const Vector3d& inertia) {
    const Eigen::Matrix3d r = body.orientation.toRotationMatrix();
    return r * inertia.asDiagonal() * r.transpose() * body.angular_velocity;
}

/// n touching spheres in a square pattern that land flat; restitution of the body.
double flat_landing(int per_side_x, int per_side_z, double e, bool share) {
    const double r = 5e-3;
    std::vector<scene::Sphere> spheres;
    for (int i = 0; i < per_side_x; ++i)
        for (int k = 0; k < per_side_z; ++k)
            spheres.push_back({{(2 * i - per_side_x + 1) * r, 0, (2 * k - per_side_z + 1) * r}, r});
    Sandbox box({"media", 2000, 1e8, 0.3}, {e, 0.5, 1e5, 1e5}, 5e-7);
    box.scene.contact = {scene::NormalLaw::linear, scene::TangentialLaw::linear, false, share, 0, 0.05, {}};
    box.wall(scene::PlaneShape{});
    BodyState body = placed(box.body(spheres), {0, r + 1e-7, 0}, {0, -1, 0});
    auto probe = build_world(box.scene, 1);
    body.orientation = shapes_of(**probe)[0].written_from_principal;
    box.start({body});
    int contact_steps = 0;
    do {
        box.run(1);
        const auto contacts = books_of(*box.world).contacts;
        contact_steps += contacts > 0 ? 1 : 0;
        if (contacts > 0)
            CHECK(contacts == per_side_x * per_side_z);
    } while ((contact_steps == 0 || books_of(*box.world).contacts > 0) && contact_steps < 200000);
    return box.body_now(0).velocity.y();
}

} // namespace

TEST_CASE("an asymmetric body without torque keeps its angular momentum to rounding and its energy to second order") {
    const auto drift = [](double dt) {
        Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, dt);
        const int body =
            box.body({{{0, 0, 0}, 3e-3}, {{4e-3, 0, 0}, 2e-3}, {{0, 5e-3, 1e-3}, 2.5e-3}, {{-2e-3, 1e-3, 3e-3}, 1e-3}});
        box.start({placed(body, {0, 0, 0}, {0, 0, 0}, {150, 220, -90})});
        const Vector3d inertia = shapes_of(*box.world)[0].inertia;
        CHECK(inertia.maxCoeff() > 1.2 * inertia.minCoeff());
        const Vector3d before(box.world->turn[0].momentum);
        box.run(1);
        const double energy = books_of(*box.world).kinetic_rotation;
        box.run(static_cast<std::int64_t>(0.5 / dt));
        const Books books = books_of(*box.world);
        const Vector3d after(box.world->turn[0].momentum);
        CHECK((after - before).norm() <= 1e-15 * before.norm());
        CHECK((angular_momentum(box.body_now(0), inertia) - before).norm() < 1e-2 * before.norm()); // half a step apart
        CHECK(std::abs(books.closure) < 1e-2 * energy);
        return std::abs(books.kinetic_rotation / energy - 1);
    };
    const double coarse = drift(4e-5);
    const double fine = drift(1e-5);
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 12);
}

TEST_CASE("a fast spin about the middle axis tumbles over, as the intermediate axis theorem has it") {
    Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, 1e-5);
    const int body = box.body({{{0, 0, 0}, 3e-3},
                               {{4e-3, 0, 0}, 2.5e-3},
                               {{-4e-3, 0, 0}, 2.5e-3},
                               {{0, 0, 2e-3}, 2.4e-3},
                               {{0, 0, -2e-3}, 2.4e-3}});
    auto probe = build_world(box.scene, 1);
    const Vector3d inertia = shapes_of(**probe)[0].inertia;
    int middle = 0;
    for (int k = 0; k < 3; ++k)
        if (inertia[k] != inertia.maxCoeff() && inertia[k] != inertia.minCoeff())
            middle = k;
    Vector3d spin = Vector3d::Constant(0.01);
    spin[middle] = 300;
    box.start({placed(body, {0, 0, 0}, {0, 0, 0}, spin)});
    double least = 1;
    for (int k = 0; k < 400; ++k) {
        box.run(50);
        Vector3d axis = Vector3d::Zero();
        axis[middle] = 1;
        least = std::min(least, (box.body_now(0).orientation * axis)[middle]);
    }
    CHECK(least < -0.95);
}

TEST_CASE("n spheres that land flat are n parallel springs and dashpots: restitution falls as docs/bodies.md tells") {
    struct Row {
        int x, z;
        double e, predicted;
    };
    // One contact has damping ratio b = -ln e / sqrt(pi^2 + ln^2 e); n have sqrt(n) b, and e_n = exp(-pi b_n / sqrt(1 -
    // b_n^2)).
    for (const Row& row : {Row{2, 1, 0.9, 0.861}, Row{2, 1, 0.5, 0.366}, Row{2, 2, 0.9, 0.810}, Row{2, 2, 0.7, 0.483},
                           Row{2, 2, 0.5, 0.223}, Row{3, 3, 0.9, 0.728}, Row{3, 3, 0.7, 0.323}}) {
        const int n = row.x * row.z;
        const double b = std::sqrt(n) * -std::log(row.e) / std::hypot(std::numbers::pi, std::log(row.e));
        CHECK(std::exp(-std::numbers::pi * b / std::sqrt(1 - b * b)) == about(row.predicted, 2e-3));
        CAPTURE(n);
        CAPTURE(row.e);
        CHECK(flat_landing(row.x, row.z, row.e, false) == about(row.predicted, 0.01));
        CHECK(flat_landing(row.x, row.z, row.e, true) == about(row.e, 0.01));
    }
}

TEST_CASE("a body of one sphere with an inertia of its own turns as that inertia says") {
    Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, 1e-5);
    const int bead = box.ball(3e-3);
    box.scene.bodies[0].principal_inertia = Vector3d(1e-8, 2e-8, 2.5e-8);
    box.start({placed(bead, {0, 0, 0}, {0, 0, 0}, {0, 100, 0})});
    box.run(1000);
    CHECK(books_of(*box.world).kinetic_rotation == about(0.5 * 2e-8 * 1e4, 1e-9));
    CHECK(std::abs(books_of(*box.world).closure) < 1e-9 * 1e-4);
}
