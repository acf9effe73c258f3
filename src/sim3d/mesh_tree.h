#pragma once

#include "base/closest_point.h"

#include <Eigen/Core>
#include <vector>

namespace tumble::sim3d {

/// Boxes around boxes around triangles, in one flat array: a node's first child stands right behind it.
class MeshTree {
public:
    MeshTree() = default;
    explicit MeshTree(const std::vector<FlatTriangle>& triangles);

    /// Calls visit(triangle) for each triangle whose box is nearer to `point` than `reach`, in no useful order.
    template <class Visit> void near(const Eigen::Vector3d& point, double reach, Visit visit) const {
        for (std::size_t n = 0; n < nodes_.size();) {
            const Node& node = nodes_[n];
            const double distance2 = (point - point.cwiseMax(node.lo).cwiseMin(node.hi)).squaredNorm();
            const bool in_reach = distance2 < reach * reach;
            for (int i = 0; in_reach && i < node.count; ++i)
                visit(order_[static_cast<std::size_t>(node.first + i)]);
            n = in_reach ? n + 1 : static_cast<std::size_t>(node.skip);
        }
    }

private:
    struct Node {
        Eigen::Vector3d lo, hi; // m
        int skip = 0;           // the node to go on with when this one is out of reach
        int first = 0;          // into order_, leaves only
        int count = 0;          // 0 for inner nodes
    };
    struct Entry {
        Eigen::Vector3d lo, hi;
        int triangle = 0;
    };
    void grow(std::vector<Entry>& entries, std::size_t begin, std::size_t end);

    std::vector<Node> nodes_;
    std::vector<int> order_;
};

} // namespace tumble::sim3d
