#include "scene/trough_profile.h"
#include "sim3d/wall_parts.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::sim3d {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Where the profile is nearest to a point; (y, z), right half (z >= 0) only.
struct Nearest {
    Vector2d away;   // m, from the profile to the point
    Vector2d inward; // unit normal there
    bool past_rim = false;
};

/// The U of scene::TroughShape, endless along x.
class Trough final : public SurfaceParts {
public:
    explicit Trough(const scene::TroughShape& shape) : radius_(shape.radius) {
        const scene::TroughProfile profile = scene::profile_of(shape);
        centre_ = {profile.centre, 0};
        arc_end_ = profile.arc_end;
        side_start_ = {profile.arc_top, profile.arc_half};
        along_ = Vector2d(std::sin(arc_end_), std::cos(arc_end_));
        side_length_ = profile.side ? (shape.rim - side_start_.x()) / along_.x() : 0;
    }

    [[nodiscard]] int primitives() const override { return 1; }

    [[nodiscard]] double distance(int, const Vector3d& point) const override {
        const Nearest near = nearest(Vector2d(point.y(), std::abs(point.z())));
        return near.past_rim ? near.away.norm() : near.away.dot(near.inward);
    }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        TouchList list(out);
        if (primitives.empty())
            return 0;
        const double side = centre.z() < 0 ? -1 : 1;
        if (radius <= radius_) {
            list.add(touch(nearest(Vector2d(centre.y(), std::abs(centre.z()))), side, radius, 0));
        } else {
            // Too large for the bottom: it can lie on both sides at once, and a history belongs to its side.
            list.add(touch(nearest_on_side(Vector2d(centre.y(), -centre.z())), -1, radius, 1));
            list.add(touch(nearest_on_side(Vector2d(centre.y(), centre.z())), 1, radius, 2));
        }
        return list.count();
    }

private:
    [[nodiscard]] Nearest nearest(const Vector2d& point) const {
        const Vector2d from_centre = point - centre_;
        const double angle = std::atan2(from_centre.y(), -from_centre.x());
        if (angle > arc_end_)
            return nearest_on_side(point);
        const Vector2d inward(std::cos(angle), -std::sin(angle));
        return {(radius_ - from_centre.norm()) * inward, inward, false};
    }

    [[nodiscard]] Nearest nearest_on_side(const Vector2d& point) const {
        const double run = (point - side_start_).dot(along_);
        const Vector2d foot = side_start_ + std::clamp(run, 0.0, side_length_) * along_;
        const Vector2d inward(along_.y(), -along_.x());
        return {point - foot, inward, run > side_length_};
    }

    static WallTouch touch(const Nearest& near, double side, double radius, int feature) {
        const auto in_space = [&](const Vector2d& v) { return Vector3d(0, v.x(), side * v.y()); };
        if (near.past_rim) {
            const double far = near.away.norm();
            return {in_space(near.away / far), far - radius, feature};
        }
        return touch_from_inside(in_space(near.inward), near.away.dot(near.inward), radius, feature, true);
    }

    double radius_ = 0;      // m, of the bottom
    Vector2d centre_;        // m, of the bottom's arc, (y, z)
    double arc_end_ = 0;     // rad from straight down
    Vector2d side_start_;    // m
    Vector2d along_;         // unit, up the side
    double side_length_ = 0; // m
};

} // namespace

SurfacePartsPtr trough_parts(const scene::TroughShape& shape) {
    return std::make_shared<Trough>(shape);
}

} // namespace tumble::sim3d
