#pragma once

#include <string>

namespace tumble::test {

/// A ball of radius 5 mm, 4 g, let go just above the upper end of an upright prism, on which it comes to rest.
inline const std::string ball_on_prism = R"(
title = "A ball on a prism"
claim = "it weighs what it weighs"
duration_s = 0.3
time_step_s = 1e-5
[domain]
lo_m = [-0.1, -0.1, -0.1]
hi_m = [0.1, 0.2, 0.1]
[material.glass]
density_kg_m3 = 7639.4373
youngs_modulus_Pa = 1e8
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.1
friction = 0.3
[body.ball]
radius_mm = 5
material = "glass"
[[fill]]
body = "ball"
count = 1
position_m = [0.003, 0.0552, 0.002]
[[wall]]
name = "part"
shape = "prism"
base_m = [0, 0, 0]
length_m = 0.05
side_m = 0.015
corner_cells = 2
middle_cells = 4
along = 10
held = "base"
material = "glass"
[observe]
measures = ["kinetic_energy"]
)";
constexpr double weight_of_ball = 4e-3 * 9.81; // N

} // namespace tumble::test
