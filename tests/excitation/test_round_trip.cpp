// The written motion, read back as a scene and run by the solver, must make the record that it was found in.
#include "../folder.h"
#include "excitation/show.h"
#include "run/simulation.h"
#include "scene/load.h"
#include "synthetic.h"

namespace test_round_trip {

using namespace tumble;
using namespace tumble::excitation;
using namespace tumble::excitation::testing;

namespace {

const std::string scene_head = R"(title = "A plate that moves as recorded"
claim = "none"
duration_s = 0.3
time_step_s = 1e-4
[domain]
lo_m = [-0.1, -0.1, -0.1]
hi_m = [0.1, 0.1, 0.1]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 5e6
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.8
friction = 0.3
[body.bead]
radius_mm = 5
material = "glass"
[[fill]]
body = "bead"
count = 1
position_m = [0, 0.07, 0]
[[wall]]
name = "plate"
shape = "plane"
point_m = [0, -0.05, 0]
normal = [0, 1, 0]
material = "glass"
)";

} // namespace

TEST_CASE("a run of the written scene reproduces the record") {
    const double f0 = 24.637, begin = 0.02;
    const std::vector<Tone> tones{{1, f0, 1.949e-3, 0.3},
                                  {2, f0, 4.04e-4, 1.9},
                                  {0, f0 / 2, 1.6e-5, 0.9},
                                  {1, 2 * f0, 2e-5, -0.7},
                                  {1, 76.56, 1e-6, 1.2}};
    const Record record = recorded(tones, {.rate = 933, .duration = 1.28});
    const auto found = find_lines(record, {});
    REQUIRE_MESSAGE(found.ok(), to_string(found.problems()));
    const test::Folder folder;
    test::put(folder.path / "plate.toml",
              scene_head + motion_text(motion_of(*found, record.channels, begin), record, *found));
    const auto scene = scene::load_scene(folder.path / "plate.toml");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    auto world = run::simulate(*scene, 1);
    REQUIRE_MESSAGE(world.ok(), to_string(world.problems()));

    // Acceleration of the wall from its velocity one step to either side: error a (2 pi f dt)^2 / 6, below 4e-4 of each
    // line here.
    std::vector<Eigen::Vector3d> velocity;
    for (int k = 0; k < 3000; ++k) {
        velocity.push_back((*world)->frame().walls[0].velocity);
        REQUIRE_FALSE((*world)->advance(1).has_value());
    }
    double worst = 0;
    for (int k = 250; k + 1 < 3000; ++k) {
        const Eigen::Vector3d seen =
            (velocity[static_cast<std::size_t>(k) + 1] - velocity[static_cast<std::size_t>(k) - 1]) / 2e-4;
        Eigen::Vector3d truth = Eigen::Vector3d::Zero();
        for (const Tone& tone : tones)
            truth[tone.axis] += tone.acceleration(k * 1e-4 - begin);
        worst = std::max(worst, (seen - truth).norm());
    }
    CHECK(worst < 4e-4 * 50); // of the 47 m/s2 that the record reaches
}

} // namespace test_round_trip
