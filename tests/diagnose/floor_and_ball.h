#pragma once

/// A ball let go above a floor, whose flights tests have in closed form.
namespace tumble::test {

constexpr const char* floor_and_ball = R"(title = "ball"
duration_s = 1
time_step_s = 1e-4
[domain]
lo_m = [-1, -1, -1]
hi_m = [1, 3, 1]
[material.rubber]
density_kg_m3 = 1000
youngs_modulus_Pa = 1e7
poisson_ratio = 0.3
[pair.rubber-rubber]
restitution = 0.8
friction = 0.5
[body.ball]
radius_mm = 10
material = "rubber"
[[fill]]
body = "ball"
count = 1
position_m = [0, 1, 0]
velocity_m_s = [0, 0, 0]
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
normal = [0, 1, 0]
material = "rubber"
)";

} // namespace tumble::test
