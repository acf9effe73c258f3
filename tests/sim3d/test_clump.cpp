#include "about.h"
#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <cmath>
#include <numbers>
#include <tuple>

namespace test_clump {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

/// n touching spheres in a square pattern that land flat; restitution of the body.
double flat_landing(int per_side_x, int per_side_z, double e, bool share, bool hertz = false, double shared = 0) {
    const double r = 5e-3;
    std::vector<scene::Sphere> spheres;
    for (int i = 0; i < per_side_x; ++i)
        for (int k = 0; k < per_side_z; ++k)
            spheres.push_back({{(2 * i - per_side_x + 1) * r, 0, (2 * k - per_side_z + 1) * r}, r});
    Sandbox box({"media", 2000, 1e8, 0.3}, {e, 0.5, 1e5, 1e5}, 5e-7);
    if (!hertz) {
        box.scene.contact.normal = scene::NormalLaw::linear;
        box.scene.contact.tangential = scene::TangentialLaw::linear;
    }
    box.scene.contact.share_among_body_contacts = share;
    box.scene.contact.damping_shared = shared;
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

TEST_CASE("an asymmetric body without torque keeps its energy to second order in the step") {
    const auto drift = [](double dt) {
        Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, dt);
        const int body =
            box.body({{{0, 0, 0}, 3e-3}, {{4e-3, 0, 0}, 2e-3}, {{0, 5e-3, 1e-3}, 2.5e-3}, {{-2e-3, 1e-3, 3e-3}, 1e-3}});
        box.start({placed(body, {0, 0, 0}, {0, 0, 0}, {150, 220, -90})});
        const Vector3d inertia = shapes_of(*box.world)[0].inertia;
        CHECK(inertia.maxCoeff() > 1.2 * inertia.minCoeff());
        box.run(1);
        const double energy = books_of(*box.world).kinetic_rotation;
        box.run(static_cast<std::int64_t>(0.5 / dt));
        const Books books = books_of(*box.world);
        CHECK(std::abs(books.closure) < 1e-2 * energy);
        return std::abs(books.kinetic_rotation / energy - 1);
    };
    const double coarse = drift(4e-5);
    const double fine = drift(1e-5);
    CHECK(coarse < 1e-3);
    CHECK(fine < coarse / 12);
}

TEST_CASE("a symmetric top without torque nods about its angular momentum at L / I1, to second order in the step") {
    // Euler: the axis goes round L at L / I1, while the body turns about its axis by w3 (1 - I3 / I1) beside.
    const double I1 = 1e-9, I3 = 1.6e-9, across = 120, along = 200, time = 0.1;
    const auto error = [&](double dt) {
        Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, dt);
        const int top = box.ball(3e-3);
        box.scene.bodies[0].principal_inertia = Vector3d(I1, I1, I3);
        box.start({placed(top, {0, 0, 0}, {0, 0, 0}, {across, 0, along})});
        box.run(std::llround(time / dt));
        const Vector3d momentum(I1 * across, 0, I3 * along);
        const Eigen::Quaterniond predicted = Eigen::AngleAxisd(momentum.norm() / I1 * time, momentum.normalized()) *
                                             Eigen::AngleAxisd(along * (1 - I3 / I1) * time, Vector3d::UnitZ());
        return predicted.angularDistance(box.body_now(0).orientation);
    };
    const double coarse = error(4e-5), fine = error(1e-5);
    CHECK(fine < 1e-3); // of 34 rad
    CHECK(fine < coarse / 12);
}

TEST_CASE("a sphere that spins freely has turned by spin times time") {
    Sandbox box({"media", 2000, 1e9, 0.3}, {1.0, 0.0}, 1e-5);
    const Vector3d spin = 300 * Vector3d(2, -1, 2) / 3;
    box.start({placed(box.ball(3e-3), {0, 0, 0}, {0, 0, 0}, spin)});
    box.run(1000);
    const Eigen::Quaterniond predicted(Eigen::AngleAxisd(3.0, spin.normalized()));
    CHECK(predicted.angularDistance(box.body_now(0).orientation) < 1e-9);
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
    for (const Row& row : {Row{2, 1, 0.9, 0.861}, Row{2, 1, 0.7, 0.602}, Row{2, 1, 0.5, 0.366}, Row{2, 1, 0.3, 0.158},
                           Row{2, 2, 0.9, 0.810}, Row{2, 2, 0.7, 0.483}, Row{2, 2, 0.5, 0.223}, Row{2, 2, 0.3, 0.040},
                           Row{3, 3, 0.9, 0.728}, Row{3, 3, 0.7, 0.323}, Row{3, 3, 0.5, 0.070}}) {
        const int n = row.x * row.z;
        const double b = std::sqrt(n) * -std::log(row.e) / std::hypot(std::numbers::pi, std::log(row.e));
        const double predicted = std::exp(-std::numbers::pi * b / std::sqrt(1 - b * b));
        CHECK(predicted == about(row.predicted, 0.0006 / row.predicted)); // as printed
        CAPTURE(n);
        CAPTURE(row.e);
        CHECK(flat_landing(row.x, row.z, row.e, false) == about(predicted, 0.01));
        CHECK(flat_landing(row.x, row.z, row.e, true) == about(row.e, 0.01));
    }
    CHECK(3 * -std::log(0.3) / std::hypot(std::numbers::pi, std::log(0.3)) > 1);
    CHECK(std::abs(flat_landing(3, 3, 0.3, false)) < 1e-3); // overdamped: it stays down
}

TEST_CASE("n spheres that land flat by Hertz lose as many dampings as by the linear law") {
    for (const auto& [x, z, e] : {std::tuple{2, 1, 0.9}, {2, 2, 0.7}, {3, 3, 0.9}}) {
        const double b = std::sqrt(x * z) * -std::log(e) / std::hypot(std::numbers::pi, std::log(e));
        CHECK(flat_landing(x, z, e, false, true) ==
              about(std::exp(-std::numbers::pi * b / std::sqrt(1 - b * b)), 0.01));
        CHECK(flat_landing(x, z, e, true, true) == about(e, 0.01));
    }
}

TEST_CASE(
    "damping shared to a degree x leaves n^((1 - x) / 2) of a contact's damping ratio, and all of x is the flag") {
    const double b = -std::log(0.7) / std::hypot(std::numbers::pi, std::log(0.7));
    for (const double x : {0.25, 0.5, 0.75}) {
        const double shared = std::pow(4, 0.5 * (1 - x)) * b;
        const double predicted = std::exp(-std::numbers::pi * shared / std::sqrt(1 - shared * shared));
        CHECK(flat_landing(2, 2, 0.7, false, false, x) == about(predicted, 0.01));
    }
    CHECK(flat_landing(2, 2, 0.7, false, false, 1) == flat_landing(2, 2, 0.7, true));
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

TEST_CASE("every pair of two clumps of many spheres counts, also more than 16 bits can number") {
    // Rings of 182 spheres, each so small that all spheres of one overlap all of the other: 33,124 contacts, and Hertz
    // stores 8/15 E* sqrt(R*) overlap^2.5 in each.
    const double r = 5e-3, ring = 0.15e-3, apart = 9.4e-3;
    const int n = 182;
    std::vector<scene::Sphere> spheres;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        spheres.push_back({ring * Vector3d(std::cos(angle), std::sin(angle), 0), r});
    }
    Sandbox box({"media", 1666, 1e7, 0.3}, {0.9, 0.0}, 1e-8);
    const int body = box.body(spheres);
    box.start({placed(body, {0, 0, 0}), placed(body, {apart, 0, 0})});
    double stored = 0;
    const std::vector<scene::Sphere>& placed_spheres = shapes_of(*box.world)[0].spheres;
    for (const scene::Sphere& a : placed_spheres)
        for (const scene::Sphere& b : placed_spheres) {
            const double overlap = 2 * r - (b.centre + Vector3d(apart, 0, 0) - a.centre).norm();
            REQUIRE(overlap > 0);
            stored += 8.0 / 15 * 1e7 / (2 * 0.91) * std::sqrt(r / 2) * std::pow(overlap, 2.5);
        }
    box.run(1);
    CHECK(books_of(*box.world).contacts == n * n);
    CHECK(books_of(*box.world).stored_normal == about(stored, 1e-9));
}

} // namespace test_clump
