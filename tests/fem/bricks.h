#pragma once

#include "base/rng.h"
#include "fem/structure.h"
#include "solid/generate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <doctest/doctest.h>
#include <memory>

/// Small parts for the tests of src/fem.
namespace tumble::test {

using Elastic = fem::Elastic;
using MeshPtr = std::shared_ptr<const solid::HexMesh>;

/// A box from the origin with so many bricks each way; node (i, j, k) has the index i + (n + 1) (j + (m + 1) k).
struct Box {
    Eigen::Vector3d size = Eigen::Vector3d::Ones(); // m
    std::array<int, 3> bricks{1, 1, 1};

    [[nodiscard]] int node(int i, int j, int k) const { return i + (bricks[0] + 1) * (j + (bricks[1] + 1) * k); }

    /// Nodes inside are moved by up to `distort` of a brick, at random.
    [[nodiscard]] MeshPtr mesh(double distort = 0) const {
        solid::HexMesh mesh;
        Rng rng(17);
        const Eigen::Vector3d brick(size.x() / bricks[0], size.y() / bricks[1], size.z() / bricks[2]);
        for (int k = 0; k <= bricks[2]; ++k)
            for (int j = 0; j <= bricks[1]; ++j)
                for (int i = 0; i <= bricks[0]; ++i) {
                    const bool inside = i > 0 && j > 0 && k > 0 && i < bricks[0] && j < bricks[1] && k < bricks[2];
                    Eigen::Vector3d at(i, j, k);
                    for (int axis = 0; axis < 3; ++axis)
                        at[axis] += (inside ? distort : 0) * rng.uniform(-1, 1);
                    mesh.nodes.push_back(brick.cwiseProduct(at));
                }
        for (int k = 0; k < bricks[2]; ++k)
            for (int j = 0; j < bricks[1]; ++j)
                for (int i = 0; i < bricks[0]; ++i)
                    mesh.hexes.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                                          node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                          node(i, j + 1, k + 1)});
        return std::make_shared<const solid::HexMesh>(solid::finished(std::move(mesh)).value());
    }

    [[nodiscard]] std::vector<int> surface() const {
        std::vector<int> nodes;
        for (int k = 0; k <= bricks[2]; ++k)
            for (int j = 0; j <= bricks[1]; ++j)
                for (int i = 0; i <= bricks[0]; ++i)
                    if (i == 0 || j == 0 || k == 0 || i == bricks[0] || j == bricks[1] || k == bricks[2])
                        nodes.push_back(node(i, j, k));
        return nodes;
    }
};

inline void hold(std::vector<fem::Support>& supports, int node, const Eigen::Vector3d& displacement) {
    for (int axis = 0; axis < 3; ++axis)
        supports.push_back({node, axis, displacement[axis]});
}

inline Eigen::MatrixXd no_loads(const solid::HexMesh& mesh, int cases = 1) {
    return Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * mesh.nodes.size()), cases);
}

inline const Elastic steel{2e11, 0.3};

inline fem::Solution solved(const MeshPtr& mesh, const Elastic& material, fem::Formulation formulation,
                            const std::vector<fem::Support>& supports, const Eigen::MatrixXd& loads, int threads = 1) {
    Crew crew(threads);
    const auto part = fem::Structure::make(mesh, material, formulation, supports, crew);
    REQUIRE_MESSAGE(part, to_string(part.problems()));
    return part->solve(loads, crew);
}

inline fem::Stress stress_at(const fem::Solution& solution, int node, int column = 0) {
    return solution.stress.col(column).segment<6>(6 * node);
}

} // namespace tumble::test
