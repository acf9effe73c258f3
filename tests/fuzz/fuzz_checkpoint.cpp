#include "base/checksum.h"
#include "expect.h"
#include "run/checkpoint.h"
#include "run/simulation.h"
#include "scene/load.h"

#include <algorithm>
#include <vector>

using namespace tumble;

namespace {

/// A checkpoint as a run of this very program writes it, and its scene.
struct Real {
    scene::Scene scene;
    std::string bytes;
};

// What follows a bar stands only in three dimensions.
const std::string text = R"(
duration_s = 1
time_step_s = 1e-5
[domain]
lo_m = [0, -1| -1]
hi_m = [0.1, 1| 1]
periodic = ["x"]
[material.m]
density_kg_m3 = 1000
youngs_modulus_Pa = 1e7
poisson_ratio = 0.3
[pair.m-m]
restitution = 0.5
friction = 0.5
normal_stiffness_N_per_m = 1e5
tangential_stiffness_N_per_m = 5e4
[body.one]
radius_m = 0.01
material = "m"
[[fill]]
body = "one"
count = 4
region_lo_m = [0, 0| -0.02]
region_hi_m = [0.1, 0.1| 0.02]
velocity_m_s = [0, -5| 0]
[[fill]]
body = "two"
count = 4
region_lo_m = [0, 0| -0.02]
region_hi_m = [0.1, 0.1| 0.02]
velocity_m_s = [0, -5| 0]
)";

std::string in_space() {
    std::string scene = text;
    std::replace(scene.begin(), scene.end(), '|', ',');
    return scene + R"(
[body.two]
spheres_m = [[0, 0, 0, 0.01], [0.01, 0, 0, 0.008]]
material = "m"
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "m"
)";
}

std::string in_the_plane() {
    std::string scene = "dimension = 2\ndepth_m = 1\n" + text;
    for (std::size_t bar = scene.find('|'); bar != std::string::npos; bar = scene.find('|'))
        scene.replace(bar, scene.find(']', bar) - bar, "");
    return scene + R"(
[body.two]
discs_m = [[0, 0, 0.01], [0.01, 0.001, 0.008]]
material = "m"
[[wall]]
name = "floor"
shape = "segment"
from_m = [-1, 0]
to_m = [1, 0]
material = "m"
)";
}

Real real(const std::string& toml) {
    auto scene = scene::load_scene_text(toml, "scene.toml");
    fuzz::expect(scene.ok(), "the scene loads");
    auto simulation = run::simulate(*scene, 1);
    fuzz::expect(simulation.ok(), "the scene can be simulated");
    while ((*simulation)->books().contacts == 0)
        fuzz::expect((*simulation)->steps() < 4000 && !(*simulation)->advance(10), "bodies come to touch");
    run::Checkpoint checkpoint;
    checkpoint.scene = toml;
    checkpoint.step = (*simulation)->steps();
    checkpoint.summary.warnings = {"one"};
    checkpoint.plot_times = {0, 1};
    checkpoint.plot_values = {2, 3};
    checkpoint.world = (*simulation)->state();
    return {std::move(*scene), run::to_bytes(checkpoint)};
}

const std::vector<Real>& reals() {
    static const std::vector<Real> both{real(in_space()), real(in_the_plane())};
    return both;
}

} // namespace

/// The input says which bytes of a real checkpoint are others: three for the place, one for the byte. The checksum is
/// put right, so that what lies beyond it is reached.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const Real& chosen = reals()[data[0] % 2];
    std::string bytes = chosen.bytes.substr(0, chosen.bytes.size() - 4);
    for (std::size_t k = 1; k + 4 <= size; k += 4)
        bytes[(data[k] | data[k + 1] << 8 | data[k + 2] << 16) % bytes.size()] = static_cast<char>(data[k + 3]);
    const std::uint32_t sum = crc32(bytes);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(sum >> shift & 0xff);

    const auto checkpoint = run::checkpoint_from(bytes, "step_1.ckpt");
    if (!checkpoint) {
        fuzz::expect_helpful(checkpoint.problems());
        return 0;
    }
    const auto simulation = run::restore(chosen.scene, 1, checkpoint->world);
    if (!simulation) {
        fuzz::expect_helpful(simulation.problems());
        return 0;
    }
    const std::string state = (*simulation)->state();
    const auto again = run::restore(chosen.scene, 1, state);
    fuzz::expect(again.ok() && (*again)->state() == state, "what was taken once is taken again, to the same bytes");
    return 0;
}
