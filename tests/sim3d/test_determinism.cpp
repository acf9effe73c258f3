#include "sim3d/sandbox.h"
#include "sim3d/world.h"

#include <cstring>

using namespace tumble;
using namespace tumble::sim3d;
using namespace tumble::sim3d::testing;

namespace {

/// Clumps and spheres that pour into a periodic slice between walls, one of which shakes: every path of the step.
scene::Scene pouring() {
    Sandbox box({"media", 1666, 4.6e7, 0.2887}, {0.67, 0.58}, 1e-5);
    const int lining = box.wall_material({"lining", 1200, 2.5e7, 0.25}, {0.159, 0.86});
    box.scene.gravity = {0, -9.81, 0};
    box.scene.seed = 11;
    box.scene.domain = {{{-0.03, -0.01, -0.05}, {0.03, 0.25, 0.05}}, {true, false, false}};
    const int ball = box.ball(4e-3);
    const int clump = box.body({{{0, 0, 0}, 4e-3}, {{3e-3, 0, 0}, 3e-3}, {{-3e-3, 1e-3, 0}, 3e-3}});
    for (const int body : {ball, clump}) {
        scene::Fill fill;
        fill.body = body;
        fill.count = 120;
        fill.region = {{-0.03, 0.01, -0.05}, {0.03, 0.2, 0.05}};
        fill.velocity = {0, -0.5, 0};
        box.scene.fills.push_back(fill);
    }
    scene::Wall& floor = box.wall(scene::PlaneShape{}, lining);
    floor.motion.harmonics.push_back({{}, 1, 0.2e-3, 25, 0.3});
    box.wall(scene::PlaneShape{{0, 0, -0.05}, {0, 0, 1}}, lining);
    box.wall(scene::PlaneShape{{0, 0, 0.05}, {0, 0, -1}}, lining);
    return box.scene;
}

bool same_bits(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (std::memcmp(a[k].position.data(), b[k].position.data(), sizeof(double) * 3) != 0 ||
            std::memcmp(a[k].velocity.data(), b[k].velocity.data(), sizeof(double) * 3) != 0 ||
            std::memcmp(a[k].orientation.coeffs().data(), b[k].orientation.coeffs().data(), sizeof(double) * 4) != 0)
            return false;
    return true;
}

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

TEST_CASE("no contact is missed, however long the neighbour lists are kept: another skin, the same first impacts") {
    // Other list lengths reorder sums, so bits drift apart once bodies have met many times; energies stay together.
    const Books thin = pour(1, nullptr, 0.4e-3).books;
    const Books thick = pour(1, nullptr, 4e-3).books;
    CHECK(thin.gravity == doctest::Approx(thick.gravity).epsilon(0.02));
    CHECK(std::abs(thin.closure) < 5e-3 * thin.inserted);
    CHECK(std::abs(thick.closure) < 5e-3 * thick.inserted);
}
