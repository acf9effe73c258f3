#include "about.h"
#include "sandbox.h"
#include "sim2d/world.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace test_contacts {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;
using tumble::test::about;

namespace {

constexpr double dt = 1e-5; // s

Sandbox room(bool further) {
    contact::PairProperties pair = springs(1e6, 0.8, 0.6, 0.3);
    pair.rolling_friction = 0.05;
    Sandbox box(pair, dt);
    if (further)
        box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
    return box;
}

/// The largest difference (N) between what the last step summed up for a body and what its contacts and its weight
/// make, over the largest force of a contact; and how many contacts there are.
std::pair<double, std::size_t> misfit(const World& world) {
    std::map<std::int64_t, Vector2d> missing;
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        missing[world.id[slot]] = Vector2d(world.loads[slot].fx, world.loads[slot].fy) -
                                  world.rows[slot].mass * Vector2d(world.scene.gravity.head<2>());
    const std::vector<ContactPush> pushes = contacts_of(world);
    double largest = 0;
    for (const ContactPush& push : pushes) {
        largest = std::max(largest, push.force.norm());
        missing.at(push.a) -= push.force.head<2>();
        if (push.b >= 0)
            missing.at(push.b) += push.force.head<2>();
    }
    double most = 0;
    for (const auto& [id, rest] : missing)
        most = std::max(most, rest.norm());
    return {largest > 0 ? most / largest : most, pushes.size()};
}

/// A heap of spinning clumps and discs that falls onto a floor, touching from the first.
Sandbox heap(const std::function<void(Sandbox&)>& change) {
    Sandbox box(springs(1e6, 0.8, 0.5, 0.4), 1.4e-5);
    box.scene.gravity = Vector3d(0, -9.81, 0);
    change(box);
    const int disc = box.disc(0.06);
    const int clump = box.body({{{0.06, 0, 0}, 0.06}, {{-0.06, 0.01, 0}, 0.05}});
    box.wall(scene::SegmentShape{{-5, 0}, {5, 0}});
    std::vector<BodyState> bodies;
    for (int k = 0; k < 12; ++k)
        bodies.push_back(at(k % 4 == 3 ? disc : clump, {0.2 * (k % 3), 0.0595 + 0.113 * (k / 3)}, {0.1 * (k % 3), -0.5},
                            40.0 - 20 * (k % 5)));
    box.put(bodies);
    return box;
}

} // namespace

TEST_CASE("the forces of the contacts of a body add up to its load in every step, with every law and from the first") {
    // Of clumps whose parts slide on each other while they tumble; a law that took a sliding contact for one that holds
    // would add a whole dashpot, which is of the size of the force.
    const std::vector<std::pair<const char*, std::function<void(Sandbox&)>>> laws{
        {"linear", [](Sandbox&) {}},
        {"mass-proportional damping", [](Sandbox& box) { box.scene.contact.global_damping = 200; }},
        {"no friction", [](Sandbox& box) { box.scene.pairs[0].friction = 0; }},
        {"no shear", [](Sandbox& box) { box.scene.contact.tangential = scene::TangentialLaw::none; }},
        {"never pulls", [](Sandbox& box) { box.scene.contact.limit_force = true; }},
        {"cohesion", [](Sandbox& box) { box.scene.pairs[0].cohesion = 20; }},
        {"rolling cdt",
         [](Sandbox& box) {
             box.scene.contact.additions.rolling = contact::RollingLaw::cdt;
             box.scene.pairs[0].rolling_friction = 0.1;
         }},
        {"rolling epsd",
         [](Sandbox& box) {
             box.scene.contact.additions.rolling = contact::RollingLaw::epsd;
             box.scene.pairs[0].rolling_friction = 0.1;
         }},
        {"weakening friction",
         [](Sandbox& box) {
             box.scene.pairs[0].sliding_friction = 0.2;
             box.scene.pairs[0].sliding_speed = 0.05;
         }},
    };
    for (const auto& [name, change] : laws) {
        CAPTURE(name);
        Sandbox box = heap(change);
        double most = 0;
        std::size_t seen = 0;
        for (int step = 0; step < 6000; ++step) {
            box.step();
            const auto [misses, contacts] = misfit(*box.world);
            most = std::max(most, misses);
            seen += contacts;
        }
        CHECK(seen > 6000);
        CHECK(most < 1e-7);
    }
}

TEST_CASE("the force of each contact is what its body's momentum changes by, in slip and in stick, with every law") {
    // Two discs meet obliquely and spinning, and so do two clumps; a third disc strikes a wall. Without gravity.
    for (const bool further : {false, true}) {
        CAPTURE(further);
        Sandbox box = room(further);
        const int disc = box.disc(0.1);
        const int clump = box.body({{{0.08, 0, 0}, 0.1}, {{-0.08, 0.01, 0}, 0.09}});
        box.wall(scene::SegmentShape{{8, 0}, {12, 0}});
        box.put({at(disc, {0, 0}, {1, 0.2}, 9), at(disc, {0.202, 0.05}, {-1, 0}), at(clump, {5, 0}, {0, 1}, 3),
                 at(clump, {5.02, 0.202}, {0, -1}), at(disc, {10, 0.102}, {0.5, -1}, -2)});
        std::vector<Vector2d> before;
        for (const BodyState& body : bodies_of(*box.world))
            before.push_back(body.velocity);
        std::map<std::int64_t, Vector2d> sums;
        for (int step = 0; step < 4000; ++step) {
            box.step();
            for (const ContactPush& push : contacts_of(*box.world)) {
                sums.try_emplace(push.a, Vector2d::Zero()).first->second += dt * push.force.head<2>();
                if (push.b >= 0)
                    sums.try_emplace(push.b, Vector2d::Zero()).first->second -= dt * push.force.head<2>();
                REQUIRE((push.a == 4) == (push.wall == 0));
            }
        }
        CHECK(contacts_of(*box.world).empty()); // they have left each other
        REQUIRE(sums.size() == 5);
        for (const auto& [id, impulse] : sums) {
            CAPTURE(id);
            const auto k = static_cast<std::size_t>(id);
            const BodyState now = box.body_at(k);
            const Vector2d gained = box.shape(now.shape).mass * (now.velocity - before[k]);
            CHECK(gained.norm() > 1);
            CHECK((impulse - gained).norm() < 1e-7 * gained.norm());
        }
    }
}

TEST_CASE("across a periodic side a contact stands where its first body is, its normal towards it") {
    Sandbox box = room(false);
    box.scene.domain.box = {{-1, -1, -0.5}, {1, 1, 0.5}};
    box.scene.domain.periodic = {true, false, false};
    const int disc = box.disc(0.1);
    box.put({at(disc, {-0.95, 0}), at(disc, {0.86, 0})}); // 0.19 m apart through the side
    box.step();
    const auto contacts = contacts_of(*box.world);
    REQUIRE(contacts.size() == 1);
    const bool left = contacts[0].a == 0;
    CHECK(contacts[0].point.x() == about(left ? -1.045 : 0.955, 1e-3));
    CHECK(contacts[0].normal.x() == about(left ? 1 : -1));
    CHECK(contacts[0].force.x() * contacts[0].normal.x() > 0);
}

} // namespace test_contacts
