#pragma once

#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

namespace tumble::solid {

/// A point of a part: values at the corners of `hex` times `shares` are the value there.
struct Inside {
    int hex = 0;
    Eigen::Matrix<double, 8, 1> shares = Eigen::Matrix<double, 8, 1>::Zero();
};

/// Finds the hexahedron that a point lies in, by cells of equal size.
class Locator {
public:
    explicit Locator(const HexMesh& mesh);
    /// Nothing outside of the part; the first by number where several meet.
    [[nodiscard]] std::optional<Inside> find(const Eigen::Vector3d& point) const;

private:
    [[nodiscard]] Eigen::Vector3i cell_at(const Eigen::Vector3d& point) const;
    [[nodiscard]] std::size_t index_of(const Eigen::Vector3i& cell) const;

    const HexMesh& mesh_;
    std::vector<Eigen::AlignedBox3d> boxes_; // per hexahedron, m
    Eigen::AlignedBox3d bounds_;
    Eigen::Vector3i counts_ = Eigen::Vector3i::Ones();
    std::vector<std::vector<int>> cells_;
};

} // namespace tumble::solid
