#include "sandbox.h"
#include "sim2d/world.h"

#include <fmt/format.h>

namespace test_state {

using namespace tumble;
using namespace tumble::sim2d;
using namespace tumble::sim2d::testing;

namespace {

constexpr std::int64_t last_step = 1500;

/// Discs and clumps come in over time above a shaking bumpy floor, in a strip that is periodic along x.
scene::Scene busy() {
    Sandbox box(springs(4e6, 0.5, 0.6, 0.4), 5e-5);
    box.scene.materials[0] = {"stone", 1000, 5e7, 0.25};
    box.scene.gravity = {0.5, -9.81, 0};
    box.scene.domain = {{{0, -1, -0.5}, {1.2, 6, 0.5}}, {true, false, false}};
    const scene::PolylineShape bumps{{{-0.1, 0}, {0.3, 0.1}, {0.7, 0.05}, {1.3, 0}}, false};
    box.wall(bumps).motion.harmonics = {{{}, 1, 0.005, 20, 0}};
    scene::ArcShape wheel;
    wheel.centre = {0.6, 0.25};
    wheel.radius = 0.1;
    wheel.sweep = 2 * M_PI;
    box.wall(wheel).motion.rotations.push_back({{}, {0.6, 0.25, 0}, Vector3d::UnitZ(), 10});
    box.disc(0.03);
    box.body({{{0, 0, 0}, 0.03}, {{0.04, 0, 0}, 0.02}});
    for (int body = 0; body < 2; ++body) {
        scene::Fill fill;
        fill.body = body;
        fill.count = body == 0 ? 80 : 200;
        fill.region = {{0, 0.12, -0.5}, {1.2, 0.6, 0.5}};
        fill.velocity = {1, -4, 0};
        fill.until = 1;
        fill.every = 0.012;
        box.scene.fills.push_back(fill);
    }
    return box.scene;
}

WorldPtr built(const scene::Scene& scene, int threads = 1) {
    auto world = build_world(scene, threads);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    return std::move(*world);
}

WorldPtr restored(const scene::Scene& scene, int threads, const std::string& state) {
    auto world = restore_world(scene, threads, state);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    return std::move(*world);
}

void step_to(World& world, std::int64_t step) {
    const auto problem = advance(world, step - steps_of(world));
    REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
}

/// Keeps the state at each of the steps and goes on from it, on each number of threads: the end must be that of the run
/// that nobody looked at.
void check_resumed(const scene::Scene& scene, const std::vector<std::int64_t>& stops, const std::vector<int>& threads) {
    const WorldPtr alone = built(scene);
    step_to(*alone, last_step);
    const std::string end = state_of(*alone);
    const WorldPtr watched = built(scene, 2);
    for (const std::int64_t stop : stops) {
        step_to(*watched, stop);
        const std::string state = state_of(*watched);
        for (const int count : threads) {
            const WorldPtr resumed = restored(scene, count, state);
            CHECK_MESSAGE(state_of(*resumed) == state, stop); // nothing is lost on the way
            step_to(*resumed, last_step);
            CHECK_MESSAGE(state_of(*resumed) == end, fmt::format("from step {} on {} threads", stop, count));
        }
    }
    step_to(*watched, last_step);
    CHECK(state_of(*watched) == end); // that its state was kept changed nothing
}

} // namespace

TEST_CASE("a world goes on from any step by the same bits, on any number of threads") {
    const scene::Scene scene = busy();
    const WorldPtr world = built(scene);
    REQUIRE(world->fills[1].placed > 0);
    REQUIRE(world->fills[1].placed < 200); // step 0 stands in the midst of a fill
    std::vector<std::int64_t> stops{0, 1};
    // Around a step that makes the lists anew: the first after the second insertion, and one that worn lists ask for.
    const std::int64_t inserting = world->next_fill_step;
    stops.insert(stops.end(), {inserting - 1, inserting, inserting + 1});
    step_to(*world, inserting + 10);
    const std::int64_t rebuilds = world->rebuilds;
    while (world->rebuilds == rebuilds && steps_of(*world) < last_step)
        step_to(*world, steps_of(*world) + 1);
    REQUIRE(world->rebuilds == rebuilds + 1);
    stops.insert(stops.end(), {steps_of(*world) - 1, steps_of(*world), last_step - 1, last_step});
    step_to(*world, last_step);
    CHECK(books_of(*world).contacts > 40);
    CHECK(books_of(*world).lost_sliding > 0);
    CHECK(world->chunks.size() > 1);
    std::sort(stops.begin(), stops.end());
    check_resumed(scene, stops, {1, 2});
}

TEST_CASE("the same holds for every law") {
    using N = scene::NormalLaw;
    using T = scene::TangentialLaw;
    const std::vector<std::pair<N, T>> laws{
        {N::linear, T::none}, {N::linear, T::linear}, {N::hertz, T::none}, {N::hertz, T::mindlin}};
    for (const auto& [normal, tangential] : laws)
        for (const bool variant : {false, true}) {
            scene::Scene scene = busy();
            scene.contact.normal = normal;
            scene.contact.tangential = tangential;
            scene.contact.limit_force = variant;
            scene.contact.global_damping = variant ? 3 : 0;
            check_resumed(scene, {1111}, {1, 2});
        }
}

TEST_CASE("the same holds for rolling resistance, which remembers more") {
    for (const auto rolling : {contact::RollingLaw::cdt, contact::RollingLaw::epsd}) {
        scene::Scene scene = busy();
        scene.contact.additions.rolling = rolling;
        for (contact::PairProperties& pair : scene.pairs)
            pair.rolling_friction = 0.1;
        check_resumed(scene, {0, 1111}, {1, 2});
    }
}

TEST_CASE("the same holds for restitution that falls with speed, friction that weakens with it, and air") {
    scene::Scene scene = busy();
    scene.air = {1.2, 0, 0.44};
    for (contact::PairProperties& pair : scene.pairs) {
        pair.restitution_exponent = 0.2;
        pair.restitution_speed = 1;
        pair.restitution_most = 0.9;
        pair.sliding_friction = 0.5 * pair.friction;
        pair.sliding_speed = 0.1;
    }
    check_resumed(scene, {0, 1111}, {1, 2});
}

TEST_CASE(
    "laws may change where a world goes on: what contacts remember more begins at nothing, or is booked as lost") {
    const scene::Scene plain = busy();
    scene::Scene rolling = plain, falling = plain;
    rolling.contact.additions.rolling = contact::RollingLaw::epsd;
    for (contact::PairProperties& pair : rolling.pairs)
        pair.rolling_friction = 0.1;
    for (contact::PairProperties& pair : falling.pairs) {
        pair.restitution_exponent = 0.2;
        pair.restitution_speed = 1;
    }
    for (const scene::Scene* other : {&rolling, &falling})
        for (const bool more : {true, false}) {
            CAPTURE(more);
            const WorldPtr before = built(more ? plain : *other, 2);
            step_to(*before, 1111);
            REQUIRE(before->remembers_more != more);
            const WorldPtr after = restored(more ? *other : plain, 2, state_of(*before));
            REQUIRE(after->remembers_more == more);
            double wound_up = 0; // J, rolling springs at step 1111
            for (const Chunk& chunk : before->chunks) {
                for (const NearDiscs& near : chunk.near_discs)
                    for (const FurtherMemory& further : near.further)
                        wound_up += further.rolling_energy;
                for (const FurtherMemory& further : chunk.wall_further)
                    wound_up += further.rolling_energy;
            }
            CHECK((wound_up > 0) == (!more && other == &rolling));
            CHECK(std::abs(after->ledger.lost_history - before->ledger.lost_history - wound_up) <= 1e-9 * wound_up);
            step_to(*after, last_step);
            CHECK(books_of(*after).contacts > 40);
        }
}

TEST_CASE("bodies put in by hand between two steps go into the state with what the others remember") {
    const scene::Scene scene = busy();
    const auto with_guest = [&](bool kept) {
        WorldPtr world = built(scene);
        step_to(*world, 700);
        REQUIRE(books_of(*world).contacts > 0);
        REQUIRE(!insert(*world, {at(1, {0.5, 3})}));
        if (kept)
            world = restored(scene, 1, state_of(*world));
        step_to(*world, last_step);
        return state_of(*world);
    };
    CHECK(with_guest(true) == with_guest(false));
}

TEST_CASE("a state that is damaged or of another scene is refused") {
    const scene::Scene scene = busy();
    const WorldPtr world = built(scene);
    step_to(*world, 300);
    const std::string state = state_of(*world);
    const auto refusal = [](const scene::Scene& of, const std::string& bytes) {
        const auto problems = restore_world(of, 1, bytes).problems();
        return problems.empty() ? "" : problems[0].what;
    };
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{100}, state.size() / 2, state.size() - 1})
        CHECK(refusal(scene, state.substr(0, size)) != "");
    CHECK(refusal(scene, "12345678" + state.substr(8)) ==
          "the state was saved by another version of the program or by the other solver");
    scene::Scene fewer = scene;
    fewer.walls.pop_back();
    CHECK(refusal(fewer, state) ==
          "the saved state does not fit the scene: it has other walls or fills, or is damaged");
    scene::Scene single = scene;
    single.bodies[1].spheres.resize(1); // rows of discs that this clump lacks
    CHECK(refusal(single, state) == "the saved state does not fit the scene: a list of neighbours leads nowhere");
}

} // namespace test_state
