// All that pairs can add to their law, at once, in a pour of spheres and clumps over a wall that shakes.
#include "sim3d/pouring.h"
#include "sim3d/world.h"

#include <cmath>

namespace test_additions {

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;

namespace {

struct Outcome {
    std::vector<BodyState> bodies;
    Books books;
};

Outcome pour(int threads, const Kernels* kernels = nullptr, double time_step = 1e-5) {
    scene::Scene scene = pouring();
    scene.time_step = time_step;
    scene.contact.additions.rolling = contact::RollingLaw::epsd;
    scene.air = {1.2, 1.8e-5, 0.44};
    for (contact::PairProperties& pair : scene.pairs) {
        pair.rolling_friction = 0.1;
        pair.restitution_exponent = 0.2;
        pair.restitution_speed = 1;
        pair.restitution_most = 0.9;
        pair.sliding_friction = 0.5 * pair.friction;
        pair.sliding_speed = 0.1;
    }
    auto world = build_world(scene, threads);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    if (kernels != nullptr)
        (*world)->kernels = kernels;
    const auto problem = advance(**world, std::llround(0.18 / time_step));
    REQUIRE_MESSAGE(!problem, (problem ? problem->what : ""));
    return {bodies_of(**world), books_of(**world)};
}

} // namespace

TEST_CASE("with every addition, one thread and two give the same bits, and so does every instruction set") {
    const Outcome one = pour(1);
    CHECK(one.books.contacts > 100);
    CHECK(one.books.lost_rolling > 0);
    CHECK(one.books.stored_rolling > 0);
    CHECK(one.books.lost_air_drag > 0);
    const Outcome two = pour(2);
    CHECK(same_bits(one.bodies, two.bodies));
    CHECK(one.books.closure == two.books.closure);
    for (const char* name : {"baseline", "x86-64-v3", "x86-64-v4"})
        if (const Kernels* kernels = kernels_named(name))
            CHECK(same_bits(one.bodies, pour(1, kernels).bodies));
}

TEST_CASE("with every addition, the books of a pour close, the better the shorter the step") {
    const auto missed = [](double time_step) {
        const Books books = pour(1, nullptr, time_step).books;
        return std::abs(books.closure) / books.inserted;
    };
    CHECK(missed(1e-5) < 5e-3);
    CHECK(missed(5e-6) < 3e-3);
}

} // namespace test_additions
