#pragma once

#include "base/closest_point.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace tumble {

/// Boxes around boxes around triangles, in one flat array: a node's first child stands right behind it.
class TriangleTree {
public:
    TriangleTree() = default;
    explicit TriangleTree(const std::vector<FlatTriangle>& triangles);

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

    /// The least of all distance2(triangle), m2, where that is below `bound`, else `bound`. Asks only of triangles
    /// whose boxes are nearer than the least so far, or farther by no more than `slack`, m2, which rounding may take.
    template <class Distance2>
    [[nodiscard]] double least(const Eigen::Vector3d& point, double bound, double slack, Distance2 distance2) const {
        double least = bound;
        for (std::size_t n = 0; n < nodes_.size();) {
            const Node& node = nodes_[n];
            const double nearest = (point - point.cwiseMax(node.lo).cwiseMin(node.hi)).squaredNorm();
            const bool in_reach = nearest <= least + slack;
            for (int i = 0; in_reach && i < node.count; ++i)
                least = std::min(least, distance2(order_[static_cast<std::size_t>(node.first + i)]));
            n = in_reach ? n + 1 : static_cast<std::size_t>(node.skip);
        }
        return least;
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

} // namespace tumble
