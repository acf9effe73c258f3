#pragma once

#include "sim3d/sandbox.h"

#include <cstring>
#include <vector>

namespace tumble::sim3d::testing {

/// Clumps and spheres that pour into a periodic slice between walls, one of which shakes: every path of the step.
inline scene::Scene pouring() {
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

inline bool same_bits(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (std::memcmp(a[k].position.data(), b[k].position.data(), sizeof(double) * 3) != 0 ||
            std::memcmp(a[k].velocity.data(), b[k].velocity.data(), sizeof(double) * 3) != 0 ||
            std::memcmp(a[k].angular_velocity.data(), b[k].angular_velocity.data(), sizeof(double) * 3) != 0 ||
            std::memcmp(a[k].orientation.coeffs().data(), b[k].orientation.coeffs().data(), sizeof(double) * 4) != 0)
            return false;
    return true;
}

} // namespace tumble::sim3d::testing
