#include "about.h"
#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace test_contacts {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

constexpr double dt = 1e-6; // s

Sandbox room(bool further) {
    const contact::Material glass{.name = "glass", .density = 2500, .youngs_modulus = 1e7, .poisson_ratio = 0.25};
    contact::PairProperties pair;
    pair.restitution = 0.7;
    pair.friction = 0.3;
    pair.rolling_friction = 0.05;
    Sandbox box{glass, pair, dt};
    if (further)
        box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
    return box;
}

/// N s, what contacts gave to each body; at every step the two of a pair get opposite forces at one place.
std::map<std::int64_t, Vector3d> impulses(Sandbox& box, int steps) {
    std::map<std::int64_t, Vector3d> sums;
    for (int step = 0; step < steps; ++step) {
        box.run(1);
        for (const ContactPush& push : contacts_of(*box.world)) {
            sums.try_emplace(push.a, Vector3d::Zero()).first->second += dt * push.force;
            if (push.b >= 0)
                sums.try_emplace(push.b, Vector3d::Zero()).first->second -= dt * push.force;
            REQUIRE(push.normal.norm() == about(1));
            REQUIRE((push.b >= 0) == (push.wall < 0));
        }
    }
    return sums;
}

/// The largest difference (N) between what the last step summed up for a body and what its contacts and its weight
/// make, over the largest force of a contact; and how many contacts there are.
std::pair<double, std::size_t> misfit(const World& world) {
    std::vector<Vector3d> missing;
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        missing.emplace_back(Vector3d(world.load[slot].force) - world.motion[slot].mass * world.scene.gravity);
    const std::vector<ContactPush> pushes = contacts_of(world);
    double largest = 0;
    for (const ContactPush& push : pushes) {
        largest = std::max(largest, push.force.norm());
        missing[static_cast<std::size_t>(world.slot_of[static_cast<std::size_t>(push.a)])] -= push.force;
        if (push.b >= 0)
            missing[static_cast<std::size_t>(world.slot_of[static_cast<std::size_t>(push.b)])] += push.force;
    }
    double most = 0;
    for (const Vector3d& rest : missing)
        most = std::max(most, rest.norm());
    return {largest > 0 ? most / largest : most, pushes.size()};
}

/// A heap of spinning clumps and balls that falls onto a floor, touching from the first; the longest step of the
/// scenes.
Sandbox heap(const std::function<void(Sandbox&)>& change) {
    const contact::Material glass{.name = "glass", .density = 2500, .youngs_modulus = 1e7, .poisson_ratio = 0.25};
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.friction = 0.4;
    Sandbox box(glass, pair, 1.4e-5);
    box.scene.gravity = Vector3d(0, -9.81, 0);
    change(box);
    const int ball = box.ball(0.006);
    const int clump = box.body({{Vector3d(0.006, 0, 0), 0.006}, {Vector3d(-0.006, 0.001, 0), 0.005}});
    box.wall(scene::PlaneShape{Vector3d::Zero(), Vector3d::UnitY()});
    std::vector<BodyState> bodies;
    for (int k = 0; k < 12; ++k)
        bodies.push_back(placed(k % 4 == 3 ? ball : clump,
                                {0.0235 * (k % 2), 0.0059 + 0.0119 * (k / 4), 0.0119 * (k / 2 % 2)},
                                {0.1 * (k % 3), -0.5, 0.05}, {40.0 - 9 * k, 150.0 * (k % 3 - 1), 60}));
    box.start(bodies);
    return box;
}

} // namespace

TEST_CASE("the forces of the contacts of a body add up to its load in every step, with every law and from the first") {
    // Of clumps whose parts slide on each other while they tumble; a law that took a sliding contact for one that holds
    // would add a whole dashpot, which is of the size of the force.
    const auto pair_of = [](Sandbox& box) -> contact::PairProperties& { return box.scene.pairs[0]; };
    const auto linear = [&](Sandbox& box) {
        box.scene.contact.normal = scene::NormalLaw::linear;
        box.scene.contact.tangential = scene::TangentialLaw::linear;
        pair_of(box).normal_stiffness = 2e3;
        pair_of(box).tangential_stiffness = 1e3;
    };
    const std::vector<std::pair<const char*, std::function<void(Sandbox&)>>> laws{
        {"hertz, mindlin", [](Sandbox&) {}},
        {"no friction", [&](Sandbox& box) { pair_of(box).friction = 0; }},
        {"no tangential law", [](Sandbox& box) { box.scene.contact.tangential = scene::TangentialLaw::none; }},
        {"linear", linear},
        {"never pulls, shared dashpot",
         [](Sandbox& box) { box.scene.contact.limit_force = box.scene.contact.share_among_body_contacts = true; }},
        {"rolling cdt",
         [&](Sandbox& box) {
             box.scene.contact.additions.rolling = contact::RollingLaw::cdt;
             pair_of(box).rolling_friction = 0.1;
         }},
        {"rolling epsd",
         [&](Sandbox& box) {
             box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
             pair_of(box).rolling_friction = 0.1;
         }},
        {"sjkr",
         [&](Sandbox& box) {
             box.scene.contact.additions.adhesion = contact::AdhesionLaw::sjkr;
             pair_of(box).cohesion_energy = 2e4;
         }},
        {"jkr",
         [&](Sandbox& box) {
             box.scene.contact.additions.adhesion = contact::AdhesionLaw::jkr;
             pair_of(box).work_of_adhesion = 0.2;
         }},
        {"dmt",
         [&](Sandbox& box) {
             box.scene.contact.additions.adhesion = contact::AdhesionLaw::dmt;
             pair_of(box).work_of_adhesion = 0.2;
         }},
        {"falling restitution, weakening friction",
         [&](Sandbox& box) {
             pair_of(box).restitution_exponent = 0.2;
             pair_of(box).restitution_speed = 0.1;
             pair_of(box).sliding_friction = 0.2;
             pair_of(box).sliding_speed = 0.05;
         }},
    };
    for (const auto& [name, change] : laws) {
        CAPTURE(name);
        Sandbox box = heap(change);
        double most = 0;
        std::size_t seen = 0;
        for (int step = 0; step < 3000; ++step) {
            box.run(1);
            const auto [misses, contacts] = misfit(*box.world);
            most = std::max(most, misses);
            seen += contacts;
        }
        CHECK(seen > 3000);
        CHECK(most < 1e-7);
    }
}

TEST_CASE("the force of each contact is what its body's momentum changes by, in slip and in stick, with every law") {
    // Two spheres meet obliquely and spinning, and so do two clumps; far apart from each other, without gravity.
    for (const bool further : {false, true}) {
        CAPTURE(further);
        Sandbox box = room(further);
        const int ball = box.ball(0.01);
        const int pair = box.body({{Vector3d(0.008, 0, 0), 0.01}, {Vector3d(-0.008, 0.001, 0), 0.009}});
        box.start({placed(ball, {0, 0, 0}, {1, 0.2, 0}, {10, 0, 90}), placed(ball, {0.0201, 0.006, 0}, {-1, 0, 0.3}),
                   placed(pair, {1, 0, 0}, {0, 1, 0.1}, {30, 5, 0}), placed(pair, {1.002, 0.0202, 0.001}, {0, -1, 0})});
        std::vector<Vector3d> before;
        for (const BodyState& body : bodies_of(*box.world))
            before.push_back(body.velocity);
        CHECK(contacts_of(*box.world).empty());
        const auto sums = impulses(box, 4000);
        CHECK(contacts_of(*box.world).empty()); // they have left each other
        REQUIRE(sums.size() == 4);
        for (const auto& [id, impulse] : sums) {
            CAPTURE(id);
            const auto k = static_cast<std::size_t>(id);
            const BodyState now = box.body_now(k);
            const double mass = shapes_of(*box.world)[static_cast<std::size_t>(now.shape)].mass;
            const Vector3d gained = mass * (now.velocity - before[k]);
            CHECK(gained.norm() > 0.2 * mass);
            CHECK((impulse - gained).norm() < 1e-7 * gained.norm());
        }
    }
}

TEST_CASE("bodies that touch as they are inserted get half a kick in their first step, and their contacts know") {
    // Only the dashpots tell: two clumps that meet at 1 m/s and spin.
    Sandbox box = heap([](Sandbox&) {});
    box.run(100);
    const int clump = 1;
    const auto problem = insert(*box.world, {placed(clump, {1, 1, 1}, {0, 1, 0}, {200, 90, -50}),
                                             placed(clump, {1, 1.0115, 1}, {0.3, -1, 0}, {-100, 0, 300})});
    REQUIRE(!problem);
    for (int step = 0; step < 5; ++step) {
        box.run(1);
        CHECK(misfit(*box.world).first < 1e-7);
    }
}

TEST_CASE("a contact stands in the middle of the overlap, its normal towards the first body") {
    Sandbox box = room(false);
    const int ball = box.ball(0.01);
    box.wall(scene::PlaneShape{Vector3d(0, -0.0099, 0), Vector3d::UnitY()});
    box.start({placed(ball, {0, 0, 0}), placed(ball, {0.0198, 0, 0})});
    box.run(1);
    int walls = 0;
    for (const ContactPush& push : contacts_of(*box.world)) {
        if (push.wall == 0) {
            ++walls;
            CHECK(push.point.y() == about(-0.00995, 1e-3));
            CHECK((push.normal - Vector3d::UnitY()).norm() < 1e-12);
            CHECK(push.force.y() > 0);
            continue;
        }
        CHECK(push.a + push.b == 1);
        CHECK(push.point.x() == about(0.0099, 1e-6));
        CHECK(push.normal.x() == about(push.a == 0 ? -1 : 1));
        CHECK(push.force.dot(push.normal) > 0);
    }
    CHECK(walls == 2);
}

TEST_CASE("two threads see the same contacts, in the same order, and looking at them changes nothing") {
    const auto run = [](int threads, bool look) {
        Sandbox box = room(false);
        box.scene.gravity = Vector3d(0, -9.81, 0);
        const int ball = box.ball(0.003);
        box.wall(scene::PlaneShape{Vector3d::Zero(), Vector3d::UnitY()});
        std::vector<BodyState> bodies;
        for (int k = 0; k < 120; ++k)
            bodies.push_back(placed(ball, {0.0059 * (k % 10), 0.003 + 0.0059 * (k / 60), 0.0059 * (k / 10 % 6)}));
        box.start(bodies, threads);
        std::vector<double> seen;
        for (int round = 0; round < 3; ++round) {
            box.run(20);
            if (look)
                for (const ContactPush& push : contacts_of(*box.world))
                    seen.insert(seen.end(), {static_cast<double>(push.a), push.point.x(), push.force.y()});
        }
        seen.push_back(box.body_now(7).position.x());
        return seen;
    };
    const auto one = run(1, true);
    CHECK(one.size() > 300);
    CHECK(run(2, true) == one);
    CHECK(run(1, false).back() == one.back());
}

} // namespace test_contacts
