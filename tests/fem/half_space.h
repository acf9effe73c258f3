#pragma once

#include "bricks.h"

#include <algorithm>
#include <numbers>
#include <vector>

/// Pieces of the half space z >= 0 under a force on its surface, for the tests of src/fem.
namespace tumble::test {

/// Displacement under a force along +z at the origin (Boussinesq 1885; Johnson, Contact Mechanics, 3.2): with R the
/// distance ur = P (1 + nu) / (2 pi E R) (r z / R^2 - (1 - 2 nu) r / (R + z)), uz = P (1 + nu) / (2 pi E R) (2 (1 - nu)
/// + z^2 / R^2).
inline Eigen::Vector3d boussinesq(const Eigen::Vector3d& at, double force, const Elastic& material) {
    const double nu = material.poisson_ratio, R = at.norm(), z = at.z();
    const double scale = force * (1 + nu) / (2 * std::numbers::pi * material.youngs_modulus * R);
    const Eigen::Vector3d across(at.x(), at.y(), 0);
    return scale *
           (across * (z / (R * R) - (1 - 2 * nu) / (R + z)) + Eigen::Vector3d(0, 0, 2 * (1 - nu) + z * z / (R * R)));
}

/// A block about the circle of radius a at the origin: bricks of a / `finer` as far as the circle reaches and as deep,
/// from there on each 1.6 times as wide as the one before, out to 5 a, where all but the surface follows Boussinesq.
struct GradedBlock {
    double a, force; // m, N
    std::vector<double> sides, depths;
    MeshPtr mesh;
    std::vector<fem::Support> supports{};

    GradedBlock(double radius, int finer, double newtons, const Elastic& material) : a(radius), force(newtons) {
        depths = {0};
        double width = a / finer;
        while (depths.back() < (1 + 1e-9) * a)
            depths.push_back(depths.back() + width);
        while (depths.back() + 1.6 * width < 5 * a)
            depths.push_back(depths.back() + (width *= 1.6));
        depths.push_back(5 * a);
        for (auto depth = depths.rbegin(); depth != depths.rend() - 1; ++depth)
            sides.push_back(-*depth);
        sides.insert(sides.end(), depths.begin(), depths.end());
        mesh = made();
        for (int node = 0; node < static_cast<int>(mesh->nodes.size()); ++node) {
            const Eigen::Vector3d at = mesh->nodes[static_cast<std::size_t>(node)];
            if (std::max({std::abs(at.x()), std::abs(at.y()), at.z()}) > 4.999 * a)
                hold(supports, node, boussinesq(at, force, material));
        }
    }

    /// On the axis, so many bricks beneath the surface.
    [[nodiscard]] int beneath(int bricks) const {
        const auto n = static_cast<int>(sides.size());
        return n / 2 + n * (n / 2 + n * bricks);
    }

private:
    [[nodiscard]] MeshPtr made() const {
        solid::HexMesh block;
        for (const double z : depths)
            for (const double y : sides)
                for (const double x : sides)
                    block.nodes.emplace_back(x, y, z);
        const auto n = static_cast<int>(sides.size()), layers = static_cast<int>(depths.size());
        for (int k = 0; k + 1 < layers; ++k)
            for (int j = 0; j + 1 < n; ++j)
                for (int i = 0; i + 1 < n; ++i) {
                    const int low = i + n * (j + n * k), high = low + n * n;
                    block.hexes.push_back({low, low + 1, low + n + 1, low + n, high, high + 1, high + n + 1, high + n});
                }
        return std::make_shared<const solid::HexMesh>(solid::finished(std::move(block)).value());
    }
};

} // namespace tumble::test
