#include "about.h"
#include "sim3d/pouring.h"
#include "sim3d/refresh.h"
#include "sim3d/world.h"

#include <cmath>
#include <map>
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

namespace {

constexpr double stickier = 5; // J/m2
/// The gap that necks of that work may reach over: between balls of radius r and a plane, m.
const double long_reach = 3 * std::pow(pi * stickier / (8 * E_eff), 2.0 / 3) * std::cbrt(r);

/// As the scene writes it: bodies of several spheres are placed in their principal frame.
BodyState as_written(const Sandbox& box, int shape, const Vector3d& position, const Vector3d& velocity) {
    const auto probe = build_world(box.scene, 1);
    REQUIRE_MESSAGE(probe.ok(), to_string(probe.problems()));
    BodyState body = placed(shape, position, velocity);
    body.orientation = shapes_of(**probe)[static_cast<std::size_t>(shape)].written_from_principal;
    return body;
}

/// A pair of spheres that hops over another one, which lies across it on a plane; both are of a material without any
/// addition. A second material, of which there is no body, sticks to everything and resists rolling.
Sandbox hopping(double work_elsewhere) {
    contact::PairProperties dry;
    dry.restitution = 0.9;
    dry.friction = 0.3;
    Sandbox box(soft, dry, dt);
    contact::PairProperties elsewhere = dry;
    elsewhere.work_of_adhesion = work_elsewhere;
    elsewhere.rolling_friction = work_elsewhere > 0 ? 0.1 : 0;
    box.wall_material(soft, elsewhere);
    box.scene.contact.additions = {contact::RollingLaw::epsd, AdhesionLaw::jkr};
    box.scene.contact.share_among_body_contacts = true;
    box.scene.gravity = {0, -9.81, 0};
    box.wall(scene::PlaneShape{});
    const int below = box.body({{{0, 0, -0.8 * r}, r}, {{0, 0, 0.8 * r}, r}});
    const int above = box.body({{{-0.8 * r, 0, 0}, r}, {{0.8 * r, 0, 0}, r}});
    // Two sphere centres of each at half the horizontal distance sqrt(2) 0.8 r from those of the other.
    const double rise = std::sqrt(4 - 2 * 0.8 * 0.8) * r;
    box.start({as_written(box, below, {0, r - 1e-7, 0}, {0, 0, 0}),
               as_written(box, above, {0, r + rise + 5e-6, 0}, {0.02, 0, 0.01})});
    return box;
}

/// Spheres of two clumps that touched, parted and touched again.
struct Partings {
    std::map<std::pair<int, int>, double> widest; // m, the gap since they parted
    int short_ones = 0; // over which a neck of the other material would have held all the while

    void look(const World& world) {
        const Chunk& chunk = world.chunks[0];
        for (const BodyPair& pair : chunk.body_pairs)
            for (int k = pair.begin; k < pair.begin + pair.count; ++k) {
                const auto [a, b] = chunk.candidates.spheres[static_cast<std::size_t>(k)];
                const bool touches = chunk.candidates.touching[static_cast<std::size_t>(k)] != 0;
                const auto found = widest.find({a, b});
                if (touches && found != widest.end() && found->second > 0 && found->second < 0.9 * long_reach)
                    ++short_ones;
                if (touches)
                    widest[{a, b}] = 0;
                else if (found != widest.end())
                    found->second = std::max(found->second, gap(world, pair, a, b));
            }
    }
    static double gap(const World& world, const BodyPair& pair, int a, int b) {
        const auto centre = [&](int slot, int sphere) -> Vector3d {
            return Vector3d(world.motion[static_cast<std::size_t>(slot)].position) + sphere_arm(world, slot, sphere);
        };
        return (centre(pair.a, a) - centre(pair.b, b)).norm() - 2 * r;
    }
};

} // namespace

TEST_CASE("that a pair elsewhere sticks and resists rolling changes no bit of one that does not") {
    Sandbox dry = hopping(0), beside_sticky = hopping(stickier);
    REQUIRE(dry.world->longest_neck == 0);
    REQUIRE(beside_sticky.world->longest_neck > 20e-6);
    Partings partings;
    for (int k = 0; k < 8000; ++k) {
        dry.run(1);
        beside_sticky.run(1);
        partings.look(*dry.world);
        REQUIRE(books_of(*beside_sticky.world).contacts == books_of(*dry.world).contacts);
        REQUIRE(books_of(*beside_sticky.world).lost_sliding == books_of(*dry.world).lost_sliding);
    }
    CHECK(partings.short_ones >= 4);
    CHECK(books_of(*dry.world).lost_sliding > 0);
    CHECK(same_bits(bodies_of(*dry.world), bodies_of(*beside_sticky.world)));
}

TEST_CASE("JKR: a gap that no neck holds over takes no share of the damping, at a wall and between bodies") {
    // One sphere touches the plane, the other has not yet: damping is that of one contact, whether shared or not.
    const auto landing = [](bool share) {
        Sandbox box = sandbox(AdhesionLaw::jkr, 0.3);
        box.scene.pairs[0].work_of_adhesion = stickier;
        box.scene.contact.share_among_body_contacts = share;
        box.wall(scene::PlaneShape{});
        const int shape = box.body({{{-2 * r, 0, 0}, r}, {{2 * r, 0, 0}, r - 0.5 * long_reach}});
        box.start({as_written(box, shape, {0, r - 1e-7, 0}, {0, -0.01, 0})});
        box.run(10);
        CHECK(books_of(*box.world).contacts == 1);
        return bodies_of(*box.world);
    };
    CHECK(same_bits(landing(true), landing(false)));

    // A pair of spheres on another: one stays, the other is torn off. The list, made for balls against planes, holds
    // the torn one until its gap is 2^(1/3) times as wide as the neck's reach.
    Sandbox box = sandbox(AdhesionLaw::jkr, 0.3);
    box.scene.pairs[0].work_of_adhesion = stickier;
    box.scene.time_step = 0.05 * dt;
    box.scene.contact.share_among_body_contacts = true;
    const int shape = box.body({{{-2 * r, 0, 0}, r}, {{2 * r, 0, 0}, r}});
    BodyState lifted = as_written(box, shape, {0, 2 * r - 1e-7, 0}, {0, 1, 0});
    lifted.angular_velocity = {0, 0, 1 / (2 * r)}; // about the sphere on the left
    box.start({as_written(box, shape, {0, 0, 0}, {0, 0, 0}), lifted});
    int both = 0, torn = 0;
    for (int k = 0; k < 600; ++k) {
        box.run(1);
        const auto& contacts = box.world->chunks[0].body_contacts[0];
        const auto holding = books_of(*box.world).contacts;
        if (contacts.size() != 2)
            continue;
        (holding == 2 ? both : torn) += 1;
        for (const BodyContact& contact : contacts)
            CHECK(contact.damping_share == (holding == 2 ? 1 / std::sqrt(2.0) : 1));
    }
    CHECK(both > 0);
    CHECK(torn > 0);
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
