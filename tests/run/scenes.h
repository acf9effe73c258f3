#pragma once

#include "scene/load.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace tumble::test {

/// A ball of radius 10 mm that falls freely from 0.5 m for 0.02 s; a row every 1 ms, a frame every 5 ms.
inline const std::string falling_ball = R"(
title = "A ball that falls"
claim = "free fall: y = h - g t^2 / 2"
duration_s = 0.02
time_step_s = 1e-5
[domain]
lo_m = [-0.1, -0.1, -0.1]
hi_m = [0.1, 0.6, 0.1]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 1e8
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.8
friction = 0.3
[body.ball]
radius_mm = 10
material = "glass"
[[fill]]
body = "ball"
count = 1
position_m = [0.0, 0.5, 0.0]
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[observe]
every_s = 0.001
measures = ["centre_of_mass", "kinetic", "energy_closure"]
[render]
every_s = 0.005
width_px = 160
height_px = 120
)";

/// Spheres and clumps that come in over time above a floor that shakes, in a box that is periodic along x; 2000 steps,
/// a row every 50, a frame every 300, which the end misses.
inline const std::string pouring = R"(
title = "A pour"
claim = "none"
duration_s = 0.04
time_step_s = 2e-5
seed = 5
[domain]
lo_m = [-0.02, -0.01, -0.02]
hi_m = [0.02, 0.12, 0.02]
periodic = ["x"]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 5e6
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.6
friction = 0.4
[body.ball]
radius_mm = 4
material = "glass"
[body.pair]
spheres_m = [[0, 0, 0, 0.003], [0.003, 0, 0, 0.003]]
material = "glass"
[[fill]]
body = "ball"
count = 40
region_lo_m = [-0.02, 0.005, -0.02]
region_hi_m = [0.02, 0.05, 0.02]
velocity_m_s = [0, -1, 0]
until_s = 1
every_s = 0.0101
[[fill]]
body = "pair"
count = 40
region_lo_m = [-0.02, 0.005, -0.02]
region_hi_m = [0.02, 0.05, 0.02]
velocity_m_s = [0.3, -1, 0]
until_s = 1
every_s = 0.0071
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "glass"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.0005
frequency_Hz = 50
[[wall]]
name = "left"
shape = "plane"
point_m = [0, 0, -0.02]
normal = [0, 0, 1]
material = "glass"
[[wall]]
name = "right"
shape = "plane"
point_m = [0, 0, 0.02]
normal = [0, 0, -1]
material = "glass"
[observe]
every_s = 0.001
[render]
every_s = 0.006
width_px = 96
height_px = 72
)";

/// The like in two dimensions.
inline const std::string raining = R"(
title = "Rain"
claim = "none"
dimension = 2
depth_m = 1
duration_s = 0.08
time_step_s = 4e-5
[domain]
lo_m = [0, -1]
hi_m = [1.2, 3]
periodic = ["x"]
[contact]
global_damping_per_s = 0.5
[material.stone]
density_kg_m3 = 1000
[pair.stone-stone]
restitution = 0.6
friction = 0.4
normal_stiffness_N_per_m = 4e6
stiffness_ratio = 0.5
[body.disc]
radius_m = 0.03
material = "stone"
[[fill]]
body = "disc"
count = 120
region_lo_m = [0, 0.03]
region_hi_m = [1.2, 0.7]
velocity_m_s = [0.5, -4]
until_s = 1
every_s = 0.0121
[[wall]]
name = "floor"
shape = "segment"
from_m = [-0.1, 0]
to_m = [1.3, 0]
material = "stone"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.005
frequency_Hz = 20
[observe]
every_s = 0.002
[render]
every_s = 0.012
width_px = 96
height_px = 72
)";

inline scene::Scene loaded(const std::string& text, const std::vector<std::string>& sets = {}) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene_text(text, "ball.toml", overrides);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

} // namespace tumble::test
