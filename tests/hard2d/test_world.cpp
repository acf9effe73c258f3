#include "sandbox.h"
#include "sim2d/solver.h"

#include <cstring>

namespace test_world {

using namespace tumble;
using namespace tumble::hard2d;
using namespace tumble::hard2d::testing;

namespace {

/// A trough that shakes, with fills that come over time.
scene::Scene shaken() {
    Sandbox box(0.5, 0.4, 5e-4);
    box.gravity();
    box.scene.time_step = 2e-5;
    box.scene.allow_large_step = true;
    box.scene.contact.normal = scene::NormalLaw::linear;
    box.scene.contact.tangential = scene::TangentialLaw::linear;
    box.scene.pairs[0].normal_stiffness = 1e6;
    box.scene.pairs[0].stiffness_ratio = 0.7;
    box.wall(scene::TroughShape{.radius = 0.3, .floor = 0, .rim = 0.9}).motion.harmonics = {{{}, 0, 0.005, 20, 0}};
    const int disc = box.disc(0.02), clump = box.body({{{-0.01, 0, 0}, 0.015}, {{0.01, 0, 0}, 0.015}});
    for (const int body : {disc, clump}) {
        scene::Fill fill;
        fill.body = body;
        fill.count = 40;
        fill.region = {{-0.25, 0.35, -0.5}, {0.25, 0.8, 0.5}};
        fill.until = 0.2;
        box.scene.fills.push_back(fill);
    }
    return box.scene;
}

WorldPtr after(const scene::Scene& scene, std::int64_t steps) {
    auto world = build_world(scene);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    const auto problem = advance(**world, steps);
    REQUIRE_MESSAGE(!problem, to_string(*problem));
    return std::move(*world);
}

} // namespace

TEST_CASE("the same scene gives the same bits again") {
    const WorldPtr a = after(shaken(), 1000), b = after(shaken(), 1000);
    const std::vector<BodyState> first = bodies_of(*a), second = bodies_of(*b);
    REQUIRE(first.size() == 80);
    REQUIRE(second.size() == 80);
    for (std::size_t k = 0; k < first.size(); ++k) {
        CHECK(std::memcmp(first[k].position.data(), second[k].position.data(), 2 * sizeof(double)) == 0);
        CHECK(first[k].angle == second[k].angle);
        CHECK(first[k].angular_velocity == second[k].angular_velocity);
    }
    CHECK(books_of(*a).wall_work == books_of(*b).wall_work);
}

TEST_CASE("a scene begins with the same bodies at the same places under either solver") {
    const scene::Scene scene = shaken();
    const WorldPtr hard = after(scene, 0);
    const auto soft = sim2d::build_world(scene, 1);
    REQUIRE_MESSAGE(soft.ok(), to_string(soft.problems()));
    const auto a = bodies_of(*hard);
    const auto b = sim2d::bodies_of(**soft);
    REQUIRE(a.size() == b.size());
    REQUIRE(!a.empty());
    for (std::size_t k = 0; k < a.size(); ++k) {
        CHECK(a[k].shape == b[k].shape);
        CHECK((a[k].position - b[k].position).norm() < 1e-7); // single precision
        CHECK(a[k].angle == about(b[k].angle, 1e-6));
    }
}

TEST_CASE("all that fills put in is there in the end, in the trough, hardly overlapping") {
    const WorldPtr world = after(shaken(), 2000);
    CHECK(unfilled(*world).empty());
    const Books books = books_of(*world);
    CHECK(books.bodies == 80);
    for (const BodyState& body : bodies_of(*world)) {
        CHECK(body.position.y() > 0);
        CHECK(body.position.y() < 0.9);
        if (body.position.y() < 0.3) // the half-round bottom, which swings by 5 mm
            CHECK((body.position - Vector2d(0, 0.3)).norm() < 0.3 + 0.005);
    }
    CHECK(books.overlap_ratio_max < 0.5); // an impact of 2 m/s goes 1 mm in a step
    CHECK(!books.splits_losses);
    CHECK(books.lost_in_sum > 0);
}

TEST_CASE("global damping lets a free disc's velocity and spin die away as exp(-alpha t)") {
    Sandbox box(0, 0, 1e-3);
    box.scene.contact.global_damping = 2;
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0}, {3, -1}, 7)});
    box.run_for(1);
    // Box2D divides by 1 + alpha dt in every step: to first order in dt.
    CHECK(box.body_at(0).velocity.x() == about(3 * std::exp(-2.0), 3e-3));
    CHECK(box.body_at(0).angular_velocity == about(7 * std::exp(-2.0), 3e-3));
}

TEST_CASE("before the first step the books hold the bodies with the energy that they brought") {
    Sandbox box(0, 0, 1e-3);
    box.gravity();
    const int disc = box.disc(0.1);
    box.put({at(disc, {0, 0.5}, {3, 4}, 20), at(disc, {1, -2})});
    const double mass = box.shape(disc).mass;
    const Books books = books_of(*box.world);
    CHECK(books.bodies == 2);
    CHECK(books.kinetic_translation == about(0.5 * mass * 25));
    CHECK(books.kinetic_rotation == about(0.5 * 0.5 * mass * 0.01 * 400));
    CHECK(books.gravity == about(mass * g * (0.5 - 2)));
    CHECK(std::abs(books.lost_in_sum) < 1e-5 * std::abs(books.inserted));
}

TEST_CASE("what Box2D cannot do is refused, with what to do") {
    const auto refusal = [](const scene::Scene& scene) {
        const auto world = build_world(scene);
        REQUIRE(!world.ok());
        return to_string(world.problems());
    };
    Sandbox periodic(0, 0, 1e-3);
    periodic.scene.domain.periodic = {true, false, false};
    CHECK(refusal(periodic.scene).find("knows no periodic sides") != std::string::npos);

    Sandbox fast(0, 0, 1e-3);
    fast.disc(0.05);
    fast.floor().motion.linears = {{{}, {0, 101, 0}}}; // two radii a step are 100 m/s
    CHECK(refusal(fast.scene).find("wall 'wall0' moves at up to 101 m/s") != std::string::npos);
    fast.scene.walls[0].motion.linears = {{{}, {0, 99, 0}}};
    CHECK(build_world(fast.scene).ok());
}

TEST_CASE("a body that leaves the domain or is too fast for its steps stops the run by name") {
    Sandbox leaving(0, 0, 1e-3);
    const int disc = leaving.disc(0.05);
    leaving.put({at(disc, {9.9, 0}, {5, 0})});
    const auto left = advance(*leaving.world, 100);
    REQUIRE(left);
    CHECK(left->what.find("body 0 (body0) left the domain at x") != std::string::npos);

    Sandbox fast(0, 0, 1e-3);
    const int bullet = fast.disc(0.05);
    fast.put({at(bullet, {-5, 0}, {200, 0})});
    const auto cut = advance(*fast.world, 10);
    REQUIRE(cut);
    CHECK(cut->what.find("none further than twice the smallest radius in a step") != std::string::npos);
}

} // namespace test_world
