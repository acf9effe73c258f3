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

inline scene::Scene loaded(const std::string& text, const std::vector<std::string>& sets = {}) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene_text(text, "ball.toml", overrides);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

} // namespace tumble::test
