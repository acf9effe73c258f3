#include "base/triangle_tree.h"

#include <algorithm>

namespace tumble {

using Eigen::Vector3d;

TriangleTree::TriangleTree(const std::vector<FlatTriangle>& triangles) {
    std::vector<Entry> entries;
    entries.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const FlatTriangle& t = triangles[i];
        const Vector3d b = t.a + t.ab, c = t.a + t.ac;
        entries.push_back({t.a.cwiseMin(b).cwiseMin(c), t.a.cwiseMax(b).cwiseMax(c), static_cast<int>(i)});
    }
    if (!entries.empty())
        grow(entries, 0, entries.size());
}

void TriangleTree::grow(std::vector<Entry>& entries, std::size_t begin, std::size_t end) {
    constexpr std::size_t leaf = 4;
    const std::size_t self = nodes_.size();
    Node node;
    node.lo = entries[begin].lo;
    node.hi = entries[begin].hi;
    for (std::size_t i = begin; i < end; ++i) {
        node.lo = node.lo.cwiseMin(entries[i].lo);
        node.hi = node.hi.cwiseMax(entries[i].hi);
    }
    nodes_.push_back(node);
    if (end - begin <= leaf) {
        nodes_[self].first = static_cast<int>(order_.size());
        nodes_[self].count = static_cast<int>(end - begin);
        for (std::size_t i = begin; i < end; ++i)
            order_.push_back(entries[i].triangle);
    } else {
        int axis = 0;
        (node.hi - node.lo).maxCoeff(&axis);
        const std::size_t middle = (begin + end) / 2;
        const auto place = [&](std::size_t i) { return entries.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(place(begin), place(middle), place(end), [axis](const Entry& a, const Entry& b) {
            const double at_a = a.lo[axis] + a.hi[axis], at_b = b.lo[axis] + b.hi[axis];
            return at_a != at_b ? at_a < at_b : a.triangle < b.triangle;
        });
        grow(entries, begin, middle);
        grow(entries, middle, end);
    }
    nodes_[self].skip = static_cast<int>(nodes_.size());
}

} // namespace tumble
