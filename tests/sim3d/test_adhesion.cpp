#include "about.h"
#include "sim3d/pouring.h"
#include "sim3d/world.h"

#include <cmath>
#include <numbers>

namespace test_adhesion {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double r = 1e-3;     // m
constexpr double work = 0.1;   // J/m2
constexpr double energy = 1e5; // J/m3, of SJKR
constexpr double dt = 2e-6;    // s
const contact::Material soft{"soft", 1200, 5e6, 0.3};
const double E_eff = 5e6 / (2 * (1 - 0.3 * 0.3));
const double mass = 1200 * 4.0 / 3 * pi * r * r * r;

using contact::AdhesionLaw;

contact::PairProperties sticky(double restitution) {
    contact::PairProperties pair;
    pair.restitution = restitution;
    pair.friction = 0.3;
    pair.work_of_adhesion = work;
    pair.cohesion_energy = energy;
    return pair;
}

Sandbox sandbox(AdhesionLaw law, double restitution) {
    Sandbox box(soft, sticky(restitution), dt);
    box.scene.contact.additions.adhesion = law;
    return box;
}

/// The gap that a neck reaches over on a plane, m.
const double reach = 3 * std::pow(pi * work / (8 * E_eff), 2.0 / 3) * std::cbrt(r);

/// Below a ceiling at y = 0, from which a growing weight pulls a ball: the largest force that it still bears, N, and
/// how far it hangs down then, m.
std::pair<double, double> pull_off(AdhesionLaw law, double expected) {
    Sandbox box = sandbox(law, 0.05);
    box.wall(scene::PlaneShape{{0, 0, 0}, {0, -1, 0}});
    box.start({placed(box.ball(r), {0, -r + 1e-7, 0})});
    box.run(4000); // pulled in, and come to rest
    double hangs = 0;
    for (double share = 0.90; share < 1.1; share += 0.01) {
        box.world->scene.gravity = {0, -share * expected / mass, 0};
        box.run(4000);
        if (books_of(*box.world).contacts == 0)
            return {(share - 0.005) * expected, hangs};
        hangs = -r - box.body_now(0).position.y();
    }
    return {0, 0};
}

} // namespace

TEST_CASE("a ball hangs from a ceiling up to the pull-off force: 3/2 pi w R by JKR over a gap, 2 pi w R by DMT") {
    const auto [jkr, gap] = pull_off(AdhesionLaw::jkr, 1.5 * pi * work * r);
    CHECK(jkr == about(1.5 * pi * work * r, 0.015));
    // At the strongest pull x^3 = 3: the neck reaches over (4 x - x^4) of the 3 at which it tears.
    CHECK(gap == about(0.48 * reach, 0.25));
    const auto [dmt, none] = pull_off(AdhesionLaw::dmt, 2 * pi * work * r);
    CHECK(dmt == about(2 * pi * work * r, 0.015));
    CHECK(none <= 0);
}

TEST_CASE(
    "JKR: a ball sticks to a plane below the speed of Thornton and Ning, and rebounds with sqrt(1 - (v_s/v)^2) above") {
    const double v_s =
        std::sqrt(14.18 / mass) * std::pow(std::pow(work, 5) * std::pow(r, 4) / (E_eff * E_eff), 1.0 / 6);
    const auto strike = [&](double speed) {
        Sandbox box = sandbox(AdhesionLaw::jkr, 1);
        box.scene.time_step = 0.2 * dt;
        box.wall(scene::PlaneShape{});
        box.start({placed(box.ball(r), {0, r + 1e-8, 0}, {0, -speed, 0})});
        box.run(60000);
        CHECK(std::abs(books_of(*box.world).closure) < 5e-3 * books_of(*box.world).inserted);
        return std::pair{box.body_now(0), books_of(*box.world)};
    };
    const auto [stuck, held] = strike(0.9 * v_s);
    CHECK(held.contacts == 1);
    CHECK(stuck.position.y() < r + reach);
    CHECK(held.lost_adhesion == 0);
    for (const double v : {1.2, 2.0, 4.0}) {
        CAPTURE(v);
        const auto [free, books] = strike(v * v_s);
        CHECK(books.contacts == 0);
        CHECK(free.velocity.y() / (v * v_s) == about(std::sqrt(1 - 1 / (v * v)), 0.01));
        CHECK(books.lost_adhesion == about(0.5 * mass * v_s * v_s, 0.01));
    }
}

TEST_CASE("two spheres that meet gently stay together, however often lists are made anew; without adhesion they part") {
    for (const auto law : {AdhesionLaw::none, AdhesionLaw::sjkr, AdhesionLaw::dmt, AdhesionLaw::jkr})
        for (const double skin : {2e-5, 1e-3}) {
            CAPTURE(static_cast<int>(law));
            CAPTURE(skin);
            Sandbox box = sandbox(law, 0.5);
            box.scene.skin = skin;
            const int ball = box.ball(r);
            // The pair drifts, so that it ages the lists.
            box.start({placed(ball, {0, 0, 0}, {1.01, 0, 0}), placed(ball, {2.0005 * r, 0, 0}, {0.99, 0, 0}),
                       placed(ball, {0, 0.1, 0}, {-1, 0, 0})});
            box.run(20000);
            CHECK(box.world->rebuilds > (skin < 1e-4 ? 50 : 2));
            const double apart = (box.body_now(0).position - box.body_now(1).position).norm();
            const bool together = law != AdhesionLaw::none;
            CHECK((apart < 2 * r + reach) == together);
            CHECK((books_of(*box.world).contacts == 1) == together);
        }
}

TEST_CASE("SJKR: a ball on a plane rests where Hertz' force balances k 2 pi R d") {
    Sandbox box = sandbox(AdhesionLaw::sjkr, 0.05);
    box.wall(scene::PlaneShape{});
    const double overlap = std::pow(energy * 2 * pi * r / (4.0 / 3 * E_eff * std::sqrt(r)), 2);
    box.start({placed(box.ball(r), {0, r - 0.5 * overlap, 0})});
    box.run(20000);
    CHECK(r - box.body_now(0).position.y() == about(overlap, 1e-3));
}

TEST_CASE("a sticky pour: threads and instruction sets change no bit, and the books close") {
    const auto pour = [](int threads, const Kernels* kernels) {
        scene::Scene scene = pouring();
        scene.contact.additions.adhesion = AdhesionLaw::jkr;
        for (contact::PairProperties& pair : scene.pairs)
            pair.work_of_adhesion = 2;
        auto world = build_world(scene, threads);
        REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
        if (kernels != nullptr)
            (*world)->kernels = kernels;
        const auto problem = advance(**world, 18000);
        REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
        return std::pair{bodies_of(**world), books_of(**world)};
    };
    const auto [one, books] = pour(1, nullptr);
    CHECK(books.contacts > 100);
    CHECK(books.lost_adhesion > 0);
    CHECK(std::abs(books.closure) < 1e-2 * books.inserted);
    CHECK(same_bits(one, pour(2, nullptr).first));
    for (const char* name : {"baseline", "x86-64-v3"})
        if (const Kernels* kernels = kernels_named(name))
            CHECK(same_bits(one, pour(1, kernels).first));
}

TEST_CASE("a material too soft and sticky for JKR is refused with the reason") {
    Sandbox box = sandbox(AdhesionLaw::jkr, 0.5);
    box.scene.pairs[0].work_of_adhesion = 100;
    box.ball(r);
    const auto built = build_world(box.scene, 1);
    REQUIRE(!built.ok());
    CHECK(built.problems()[0].key == "contact.adhesion");
    CHECK(built.problems()[0].what.find("necks of adhesion would reach over") == 0);
}

} // namespace test_adhesion
