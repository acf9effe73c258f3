#include "about.h"
#include "base/rng.h"
#include "sim3d/pouring.h"
#include "sim3d/step.h"
#include "sim3d/world.h"

namespace test_determinism {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;
using tumble::test::about;

namespace {

struct Outcome {
    std::vector<BodyState> bodies;
    Books books;
};

Outcome pour(int threads, const Kernels* kernels = nullptr, double skin = 0) {
    scene::Scene scene = pouring();
    scene.skin = skin;
    auto world = build_world(scene, threads);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    if (kernels != nullptr)
        (*world)->kernels = kernels;
    const auto problem = advance(**world, 25000);
    REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    return {bodies_of(**world), books_of(**world)};
}

} // namespace

TEST_CASE("one thread, two and three give the same bits") {
    const Outcome one = pour(1);
    CHECK(one.books.contacts > 200);
    for (const int threads : {2, 3}) {
        const Outcome more = pour(threads);
        CHECK(same_bits(one.bodies, more.bodies));
        CHECK(one.books.closure == more.books.closure);
    }
}

TEST_CASE("every instruction set that this machine has gives the same bits") {
    const Outcome baseline = pour(1, kernels_named("baseline"));
    for (const char* name : {"x86-64-v3", "x86-64-v4"})
        if (const Kernels* kernels = kernels_named(name))
            CHECK(same_bits(baseline.bodies, pour(1, kernels).bodies));
        else
            MESSAGE("this processor lacks " << name);
}

TEST_CASE("another skin reorders sums, and the pour ends with the same energy all the same") {
    // That no contact is missed is held in test_neighbours.cpp; bits drift apart once bodies have met many times.
    const Books thin = pour(1, nullptr, 0.4e-3).books;
    const Books thick = pour(1, nullptr, 4e-3).books;
    CHECK(thin.gravity == about(thick.gravity, 0.02));
    CHECK(std::abs(thin.closure) < 5e-3 * thin.inserted);
    CHECK(std::abs(thick.closure) < 5e-3 * thick.inserted);
}

namespace {

/// A dense cloud of spheres and clumps in sixteen chunks, without walls or gravity.
Sandbox cloud(int threads, bool turn_spheres = true) {
    Sandbox box({"media", 1666, 4.6e6, 0.2887}, {0.6, 0.5}, 1e-5);
    box.scene.turn_spheres = turn_spheres;
    box.scene.domain = {{{0, 0, 0}, {0.2, 0.06, 0.06}}, {true, true, true}};
    const int ball = box.ball(3e-3);
    const int clump = box.body({{{1e-3, 0, 0}, 2.4e-3}, {{-1e-3, 0, 0}, 2e-3}});
    Rng rng(3);
    std::vector<BodyState> bodies;
    for (int i = 0; i < 33; ++i)
        for (int j = 0; j < 10; ++j)
            for (int k = 0; k < 10; ++k)
                bodies.push_back(placed((i + j + k) % 3 == 0 ? clump : ball,
                                        6.05e-3 * Vector3d(i + 0.5, 0, 0) + 6e-3 * Vector3d(0, j + 0.5, k + 0.5),
                                        {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)},
                                        {rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(-50, 50)}));
    box.start(bodies, threads);
    return box;
}

} // namespace

TEST_CASE("pushes between chunks conserve momentum to rounding, and threads change no bit of them") {
    const auto momentum = [](const Sandbox& box, double& scale) {
        Vector3d sum = Vector3d::Zero();
        for (const BodyState& body : bodies_of(*box.world)) {
            const Vector3d p = shapes_of(*box.world)[static_cast<std::size_t>(body.shape)].mass * body.velocity;
            sum += p;
            scale += p.norm();
        }
        return sum;
    };
    Sandbox one = cloud(1);
    double scale = 0;
    const Vector3d before = momentum(one, scale);
    one.run(1500);
    REQUIRE(one.world->chunks.size() == solver::most_chunks);
    CHECK(books_of(*one.world).contacts > 1000);
    CHECK((momentum(one, scale) - before).norm() < 1e-12 * scale);
    for (const int threads : {2, 3}) {
        Sandbox more = cloud(threads);
        more.run(1500);
        CHECK(same_bits(bodies_of(*one.world), bodies_of(*more.world)));
    }
}

TEST_CASE("a rebuild leaves no letters behind that are addressed to slots of before") {
    Sandbox box = cloud(1);
    box.run(200);
    const auto unread = [&] {
        int letters = 0;
        for (const Chunk& chunk : box.world->chunks)
            letters += chunk.foreign_count;
        return letters;
    };
    REQUIRE(unread() > 0); // they are read in the step that wrote them, and cleared by the next
    box.world->stale = true;
    list_neighbours(*box.world);
    CHECK(unread() == 0);
}

TEST_CASE("two spheres that touch through both sides of a short period keep their two springs apart") {
    const auto turned = [](double skin) {
        Sandbox box({"media", 1666, 4.6e5, 0.2887}, {1.0, 0.9}, 1e-5);
        box.scene.domain = {{{0, -1, -1}, {0.0155, 1, 1}}, {true, false, false}};
        box.scene.skin = skin;
        const int ball = box.ball(4e-3);
        box.start(
            {placed(ball, {0.0010, 0, 0}, {0.3, 0.2, 0}, {0, 0, 30}), placed(ball, {0.0089, 0, 0}, {0.3, -0.2, 0.1})});
        box.run(3000);
        REQUIRE(box.world->rebuilds > (skin < 1e-4 ? 20 : 1));
        return std::pair{box.body_now(0), books_of(*box.world).closure / books_of(*box.world).inserted};
    };
    const auto [often, often_closure] = turned(2e-5);
    const auto [seldom, seldom_closure] = turned(1.5e-3);
    CHECK((often.angular_velocity - seldom.angular_velocity).norm() < 1e-6 * seldom.angular_velocity.norm());
    CHECK(std::abs(often_closure - seldom_closure) < 1e-6); // one spring taken for the other costs 4e-3
}

TEST_CASE("a body flies and turns by the same bits alone and among others of both kinds, eight of which move at once") {
    const auto last_state = [](int clumps, int balls) {
        Sandbox box({"media", 1666, 4.6e6, 0.2887}, {0.5, 0.5}, 1e-5);
        box.scene.gravity = {0.3, -9.81, 0.1};
        const int clump = box.body({{{0, 0, 0}, 4e-3}, {{3e-3, 0, 0}, 3e-3}, {{0, 4e-3, 1e-3}, 2e-3}});
        const int ball = box.ball(2e-3);
        std::vector<BodyState> bodies{placed(clump, {-1, 0, 0}, {1, 2, 3}, {40, -70, 110})};
        for (int k = 1; k < clumps; ++k)
            bodies.push_back(placed(clump, {-1 + 0.1 * k, 0, 0}, {0, 0, 0.1 * k}, {1.0 * k, 0, 5}));
        for (int k = 0; k < balls; ++k)
            bodies.push_back(placed(ball, {-1 + 0.1 * k, 1, 0}));
        box.start(bodies);
        box.run(200);
        return box.body_now(0);
    };
    const BodyState alone = last_state(1, 0);
    for (const auto& [clumps, balls] : {std::pair{8, 0}, {11, 0}, {3, 9}}) {
        const BodyState crowded = last_state(clumps, balls);
        CHECK(crowded.position == alone.position);
        CHECK(crowded.orientation.coeffs() == alone.orientation.coeffs());
        CHECK(crowded.angular_velocity == alone.angular_velocity);
    }
}

TEST_CASE("spheres that are not turned keep the orientation they came with, and nothing else changes by a bit") {
    const Sandbox turned = cloud(1), kept = cloud(1, false);
    REQUIRE(!advance(*turned.world, 200));
    REQUIRE(!advance(*kept.world, 200));
    const std::vector<BodyState> expected = bodies_of(*turned.world);
    std::vector<BodyState> bodies = bodies_of(*kept.world);
    int spheres = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (shapes_of(*kept.world)[static_cast<std::size_t>(bodies[k].shape)].spheres.size() == 1) {
            REQUIRE(bodies[k].orientation.coeffs() == Eigen::Quaterniond::Identity().coeffs());
            REQUIRE(expected[k].orientation.coeffs() != Eigen::Quaterniond::Identity().coeffs());
            bodies[k].orientation = expected[k].orientation;
            ++spheres;
        }
    CHECK(spheres == 2200);
    CHECK(same_bits(bodies, expected));
    CHECK(books_of(*kept.world).closure == books_of(*turned.world).closure);
}

} // namespace test_determinism
