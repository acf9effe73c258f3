#include "sim3d/wall_parts.h"

#include <algorithm>

namespace tumble::sim3d {

using Eigen::Vector3d;

void SurfaceParts::primitives_near(const Vector3d& centre, double reach, std::vector<int>& out) const {
    out.clear();
    for (int primitive = 0; primitive < primitives(); ++primitive)
        if (distance(primitive, centre) < reach)
            out.push_back(primitive);
}

void TouchList::add(const WallTouch& touch) {
    if (!(touch.gap < 0) || out_.empty())
        return;
    std::size_t place = count_;
    while (place > 0 && out_[place - 1].feature >= touch.feature)
        --place;
    if (place < count_ && out_[place].feature == touch.feature) {
        if (touch.gap < out_[place].gap)
            out_[place] = touch;
        return;
    }
    if (count_ == out_.size()) {
        const auto shallowest = std::max_element(out_.begin(), out_.end(),
                                                 [](const WallTouch& a, const WallTouch& b) { return a.gap < b.gap; });
        if (shallowest->gap <= touch.gap)
            return;
        const auto gone = static_cast<std::size_t>(shallowest - out_.begin());
        std::move(shallowest + 1, out_.end(), shallowest);
        --count_;
        place -= gone < place;
    }
    std::move_backward(out_.begin() + static_cast<std::ptrdiff_t>(place),
                       out_.begin() + static_cast<std::ptrdiff_t>(count_),
                       out_.begin() + static_cast<std::ptrdiff_t>(count_ + 1));
    out_[place] = touch;
    ++count_;
}

WallTouch touch_from_inside(const Vector3d& inward, double height, double radius, int feature, bool has_rim) {
    if (has_rim && -height > pressed_through * radius)
        return {-inward, -height - radius, feature};
    return {inward, height - radius, feature};
}

std::vector<Vector3d> periodic_shifts(const scene::Box& bounds, const scene::Domain& domain) {
    std::vector<Vector3d> shifts{Vector3d::Zero()};
    for (int axis = 0; axis < 3; ++axis) {
        const double period = domain.box.hi[axis] - domain.box.lo[axis];
        // STL files hold single precision: a mesh as long as the period may come out a little longer.
        if (!domain.periodic[static_cast<std::size_t>(axis)] || bounds.hi[axis] - bounds.lo[axis] > period * (1 + 1e-5))
            continue;
        const std::size_t so_far = shifts.size();
        for (std::size_t i = 0; i < so_far; ++i)
            for (const double side : {-1.0, 1.0})
                shifts.push_back(shifts[i] + side * period * Vector3d::Unit(axis));
    }
    return shifts;
}

} // namespace tumble::sim3d
