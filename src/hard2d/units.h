#pragma once

#include "discs/body_shape.h"

#include <Eigen/Core>
#include <box2d/b2_math.h>
#include <vector>

namespace tumble::hard2d {

/// Box2D counts in single precision and is tuned for bodies of 0.1 to 10 of its units of length: its slop of 0.005,
/// which resting bodies overlap by, is compiled in. Here the smallest disc's radius is its unit, so that the slop is
/// 0.5 % of it; the middle of the domain is the origin, where numbers have the most digits; the lightest body has the
/// mass 1. Time stays as it is.
struct Units {
    double length = 1;                                // of Box2D per m
    double mass = 1;                                  // of Box2D per kg
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); // m

    static Units of(const scene::Scene& scene, const std::vector<discs::ShapeData>& shapes);

    /// A length, a velocity or an acceleration.
    [[nodiscard]] b2Vec2 rate(const Eigen::Vector2d& si) const {
        return {static_cast<float>(length * si.x()), static_cast<float>(length * si.y())};
    }
    [[nodiscard]] b2Vec2 place(const Eigen::Vector2d& si) const { return rate(si - origin); }
    [[nodiscard]] Eigen::Vector2d rate(const b2Vec2& box) const { return Eigen::Vector2d(box.x, box.y) / length; }
    [[nodiscard]] Eigen::Vector2d place(const b2Vec2& box) const { return rate(box) + origin; }
};

} // namespace tumble::hard2d
