#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <fmt/format.h>

namespace test_state {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;

namespace {

constexpr std::int64_t last_step = 1200;

/// Spheres and clumps come in over time above a shaking floor and a turning mesh, in a box that is periodic along x.
scene::Scene busy() {
    Sandbox box({"media", 1666, 4.6e6, 0.2887}, {0.67, 0.58, 2e3, 1e3}, 2.5e-5);
    const int lining = box.wall_material({"lining", 1200, 2.5e6, 0.25}, {0.159, 0.86, 2e3, 1e3});
    box.scene.gravity = {0.5, -9.81, 0};
    box.scene.seed = 11;
    box.scene.domain = {{{-0.03, -0.02, -0.03}, {0.03, 0.25, 0.03}}, {true, false, false}};
    const int ball = box.ball(4e-3);
    const int clump = box.body({{{0, 0, 0}, 4e-3}, {{3e-3, 0, 0}, 3e-3}, {{-3e-3, 1e-3, 0}, 3e-3}});
    for (const int body : {ball, clump}) {
        scene::Fill fill;
        fill.body = body;
        fill.count = body == ball ? 70 : 200;
        fill.region = {{-0.03, 0.004, -0.03}, {0.03, 0.05, 0.03}};
        fill.velocity = {0.3, -1, 0};
        fill.until = 1;
        fill.every = 0.005; // several times before the last step
        box.scene.fills.push_back(fill);
    }
    scene::Wall& floor = box.wall(scene::PlaneShape{}, lining);
    floor.motion.harmonics.push_back({{}, 1, 0.2e-3, 50, 0.3});
    box.wall(scene::PlaneShape{{0, 0, -0.03}, {0, 0, 1}}, lining);
    box.wall(scene::PlaneShape{{0, 0, 0.03}, {0, 0, -1}}, lining);
    scene::MeshShape paddle;
    paddle.triangles = {{Vector3d(-0.01, 0, 0.0), Vector3d(0.01, 0, 0.0), Vector3d(0.01, 0.02, 0.002)},
                        {Vector3d(-0.01, 0, 0.0), Vector3d(0.01, 0.02, 0.002), Vector3d(-0.01, 0.02, 0.002)}};
    box.wall(paddle, lining).motion.rotations.push_back({{}, Vector3d::Zero(), Vector3d::UnitY(), 8});
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
    step_to(*world, inserting + 100);
    const std::int64_t rebuilds = world->rebuilds;
    while (world->rebuilds == rebuilds && steps_of(*world) < last_step)
        step_to(*world, steps_of(*world) + 1);
    REQUIRE(world->rebuilds == rebuilds + 1);
    stops.insert(stops.end(), {steps_of(*world) - 1, steps_of(*world), last_step - 1, last_step});
    step_to(*world, last_step);
    CHECK(books_of(*world).contacts > 200);
    CHECK(books_of(*world).lost_sliding > 0);
    CHECK(world->chunks.size() > 1);
    std::sort(stops.begin(), stops.end());
    check_resumed(scene, stops, {1, 2});
}

TEST_CASE("the same holds for every law") {
    using N = scene::NormalLaw;
    using T = scene::TangentialLaw;
    const std::vector<std::pair<N, T>> laws{{N::hertz, T::none},
                                            {N::hertz, T::mindlin},
                                            {N::hertz, T::linear},
                                            {N::linear, T::none},
                                            {N::linear, T::linear}};
    for (const auto& [normal, tangential] : laws)
        for (const bool variant : {false, true}) {
            scene::Scene scene = busy();
            scene.contact.normal = normal;
            scene.contact.tangential = tangential;
            scene.contact.limit_force = variant;
            scene.contact.share_among_body_contacts = variant;
            check_resumed(scene, {777}, {1, 2});
        }
}

TEST_CASE("the same holds for what pairs may add: rolling resistance and adhesion, which remember more") {
    using contact::AdhesionLaw;
    using contact::RollingLaw;
    for (const auto& [rolling, adhesion] : {std::pair{RollingLaw::cdt, AdhesionLaw::sjkr},
                                            {RollingLaw::epsd, AdhesionLaw::jkr},
                                            {RollingLaw::epsd, AdhesionLaw::dmt}}) {
        scene::Scene scene = busy();
        scene.contact.additions.rolling = rolling;
        scene.contact.additions.adhesion = adhesion;
        for (contact::PairProperties& pair : scene.pairs) {
            pair.rolling_friction = 0.1;
            pair.cohesion_energy = 1e4;
            pair.work_of_adhesion = 0.02;
        }
        check_resumed(scene, {0, 777}, {1, 2});
    }
}

TEST_CASE("the same holds for restitution that falls with speed, friction that weakens with it, and air") {
    scene::Scene scene = busy();
    scene.air = {1.2, 1.8e-5, 0.44};
    for (contact::PairProperties& pair : scene.pairs) {
        pair.restitution_exponent = 0.2;
        pair.restitution_speed = 1;
        pair.restitution_most = 0.9;
        pair.sliding_friction = 0.5 * pair.friction;
        pair.sliding_speed = 0.1;
    }
    check_resumed(scene, {0, 777}, {1, 2});
}

TEST_CASE("the same holds in a bowl whose disc turns its ribs, with rolling resistance and adhesion") {
    scene::Scene scene = busy();
    scene.gravity = {0, -9.81, 0};
    scene.domain = {{{-0.06, -0.01, -0.06}, {0.06, 0.3, 0.06}}, {false, false, false}};
    for (scene::Fill& fill : scene.fills)
        fill.region.lo.y() = 0.012; // above the ribs
    scene.walls.resize(2);
    scene.walls[0].name = "disc";
    scene.walls[0].shape = scene::BowlDiscShape{{0, 0, 0}, 0.049, 0.01, 0.01, 0.25, {8, 4e-3, 6e-3, 3e-3}};
    scene.walls[0].motion = {};
    scene.walls[0].motion.rotations.push_back({{}, Vector3d::Zero(), Vector3d::UnitY(), 21});
    scene.walls[1].name = "bowl";
    scene.walls[1].shape = scene::BowlShape{{0, -0.005, 0}, 0.05, 0.2, 0.5, {12, 2e-3, 6e-3, 3e-3}};
    scene.contact.additions = {contact::RollingLaw::epsd, contact::AdhesionLaw::jkr};
    for (contact::PairProperties& pair : scene.pairs) {
        pair.rolling_friction = 0.1;
        pair.work_of_adhesion = 0.02;
    }
    const WorldPtr world = built(scene);
    step_to(*world, last_step);
    CHECK(books_of(*world).contacts > 100);
    CHECK(books_of(*world).wall_work > 0);
    check_resumed(scene, {0, 777}, {1, 2});
}

TEST_CASE(
    "laws may change where a world goes on: what contacts remember more begins at nothing, or is booked as lost") {
    const scene::Scene plain = busy();
    std::vector<scene::Scene> others(4, plain);
    others[0].contact.additions.rolling = contact::RollingLaw::epsd;
    others[1].contact.additions.adhesion = contact::AdhesionLaw::jkr;
    others[2].contact.additions.adhesion = contact::AdhesionLaw::dmt;
    for (scene::Scene& other : others)
        for (contact::PairProperties& pair : other.pairs) {
            pair.rolling_friction = 0.1;
            pair.work_of_adhesion = 0.02;
        }
    for (contact::PairProperties& pair : others[3].pairs) {
        pair.restitution_exponent = 0.2;
        pair.restitution_speed = 1;
    }
    for (std::size_t k = 0; k < others.size(); ++k) {
        CAPTURE(k);
        for (const bool more : {true, false}) {
            CAPTURE(more);
            const WorldPtr before = built(more ? plain : others[k], 2);
            step_to(*before, 777);
            REQUIRE(before->remembers_more != more);
            const WorldPtr after = restored(more ? others[k] : plain, 2, state_of(*before));
            REQUIRE(after->remembers_more == more);
            double wound_up = 0; // J, rolling springs at step 777
            for (const Chunk& chunk : before->chunks) {
                for (const NearSpheres& near : chunk.near_spheres)
                    for (const FurtherLanes& further : near.further)
                        wound_up += further.rolling_energy;
                for (const FurtherLanes& further : chunk.candidates.further)
                    wound_up += further.rolling_energy;
                for (const FurtherLanes& further : chunk.wall_further)
                    wound_up += further.rolling_energy;
            }
            CHECK((wound_up > 0) == (!more && k == 0));
            CHECK(std::abs(after->ledger.lost_history - before->ledger.lost_history - wound_up) <= 1e-9 * wound_up);
            step_to(*after, last_step);
            CHECK(books_of(*after).contacts > 200);
        }
    }
}

TEST_CASE("a world without bodies goes on too") {
    scene::Scene scene = busy();
    scene.fills.clear();
    check_resumed(scene, {0, 500}, {1});
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
    single.bodies[1].spheres.resize(1); // candidates name spheres that this clump lacks
    CHECK(refusal(single, state) == "the saved state does not fit the scene: a list of neighbours leads nowhere");
}

} // namespace test_state
