#include "about.h"
#include "claims.h"
#include "run/flow_report.h"
#include "sim3d/body_shape.h"
#include "sim3d/solver.h"

#include <cmath>
#include <numbers>

namespace test_bowl {

using namespace tumble;
using namespace tumble::test;

TEST_CASE("bowl: load, sensor, drive and size are the thesis'") {
    const scene::Scene bowl = loaded("bowl.toml");
    const auto mass_of = [&](const scene::BodyTemplate& body) {
        return sim3d::make_body_shape(body, bowl.materials[static_cast<std::size_t>(body.material)]).value().mass;
    };
    CHECK(mass_of(bowl.bodies[0]) == about(0.000490733, 1e-5)); // appendix C.2
    CHECK(bowl.bodies[0].spheres.size() == 36);
    CHECK(*bowl.fills[0].count * mass_of(bowl.bodies[0]) == about(7.0, 0.001));
    CHECK(mass_of(bowl.bodies[1]) == 0.0277206);
    CHECK(bowl.bodies[1].spheres.size() == 43);
    CHECK(bowl.time_step == about(1.0 / 350000, 1e-12));
    const auto& wall = std::get<scene::BowlShape>(bowl.walls[0].shape);
    CHECK(2 * wall.radius == about(0.333));
    CHECK(wall.height == 0.21);
    CHECK(bowl.walls[1].motion.rotations[0].angular_velocity == about(200 * 2 * std::numbers::pi / 60));
    const scene::Scene spheres = loaded("bowl-spheres.toml");
    CHECK(sim3d::make_body_shape(spheres.bodies[0], spheres.materials[0]).value().mass == about(0.000490733, 1e-4));
}

TEST_CASE("bowl-quick, with a ninth of its load: the disc flings the media outwards and lifts them up its rim") {
    const scene::Scene bowl =
        loaded("bowl-quick.toml", {"fill.0.count=200", "fill.1.start_s=0.05", "wall.disc.motion.0.start_s=0.15"});
    auto world = sim3d::build_world(bowl, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));
    struct Means {
        double away = 0, height = 0, round = 0; // m, m, m/s
    };
    const auto means_at = [&](double time) {
        REQUIRE(!sim3d::advance(**world, std::llround(time / bowl.time_step) - sim3d::steps_of(**world)));
        Means means;
        const auto bodies = sim3d::bodies_of(**world);
        for (const sim3d::BodyState& body : bodies) {
            const double away = std::hypot(body.position.x(), body.position.z());
            const auto n = static_cast<double>(bodies.size());
            means.away += away / n;
            means.height += body.position.y() / n;
            means.round += (body.position.z() * body.velocity.x() - body.position.x() * body.velocity.z()) / away / n;
        }
        return means;
    };
    const Means rest = means_at(0.15), flung = means_at(0.35);
    CHECK(sim3d::bodies_of(**world).size() == 201);
    CHECK(std::abs(rest.round) < 0.1);
    CHECK(flung.away > rest.away + 0.02);
    CHECK(flung.height > rest.height);
    // Faster than nothing, slower than the disc at the wall: 200 rpm and 0.1645 m.
    CHECK(flung.round > 0.5);
    CHECK(flung.round < 3.45);
    CHECK(std::abs(sim3d::books_of(**world).closure) < 0.05);
}

TEST_CASE("bowl-quick, until it is steady: down in the middle, up outside, fastest at the bottom, about a vortex") {
    // 0.5 s of turning, of which the last 0.2 s count.
    const Ran ran(loaded("bowl-quick.toml", {"duration_s=0.9"}));
    run::FlowOptions options{.grid = {0, 0, 0.1665, 0, 0.16, 5, 4}, .bodies = {}, .when = {}};
    options.when.from = 0.7;
    const auto flow = run::read_flow(ran.folder.path / "run", options, [](std::int64_t, std::int64_t) {});
    REQUIRE_MESSAGE(flow, to_string(flow.problems()));
    const auto rises = [&](int ring) {
        observe::FlowCell column;
        for (int layer = 0; layer < 4; ++layer)
            column += flow->field.cell(ring, layer);
        return column.mean_velocity().z();
    };
    MESSAGE(rises(0) << " " << rises(1) << " " << rises(2) << " " << rises(3) << " " << rises(4));
    MESSAGE(observe::vortex_depth(flow->field)
            << " m; " << flow->field.layer(0).mean_speed() << " " << flow->field.layer(1).mean_speed() << " "
            << flow->field.layer(2).mean_speed() << " m/s; " << ran.mean("kinetic_translation", 0.7, 0.9) << " J");
    CHECK(rises(0) < -0.05);
    CHECK(rises(4) > 0.02);
    CHECK(observe::vortex_depth(flow->field) > 0.05);
    CHECK(flow->field.layer(0).mean_speed() > 1.5 * flow->field.layer(2).mean_speed());
}

} // namespace test_bowl
