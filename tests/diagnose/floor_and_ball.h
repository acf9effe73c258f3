#pragma once

#include "base/problem.h"
#include "observe/series.h"
#include "scene/scene.h"

#include <cmath>

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

/// A point that falls and bounces at once: heights in closed form.
inline double bouncing(double height, double g, double e, double t) {
    double flight = std::sqrt(2 * height / g), speed = g * flight;
    if (t < flight)
        return height - 0.5 * g * t * t;
    t -= flight;
    for (int k = 0; k < 100; ++k) {
        speed *= e;
        flight = 2 * speed / g;
        if (t < flight)
            return speed * t - 0.5 * g * t * t;
        t -= flight;
    }
    return 0;
}

/// That, as a simulation's records are.
inline Result<observe::Series> closed_form(const scene::Scene& scene) {
    observe::Series series;
    series.columns = {"time_s", "centre_of_mass_y_m"};
    series.values.resize(2);
    const double g = -scene.gravity.y(), e = scene.pair(0, 0).restitution, height = scene.fills[0].position->y();
    for (double t = 0; t < scene.duration; t += scene.observe.every)
        series.append({t, bouncing(height, g, e, t)});
    return series;
}

} // namespace tumble::test
