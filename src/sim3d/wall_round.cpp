#include "sim3d/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

Vector3d spread_across(const Vector3d& axis, double radius) {
    return radius * (Vector3d::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
}

/// A thin surface of revolution that stands at one place or more: the side on which the centre is, is the side that
/// pushes. `Shape` gives the vector from its closest point to a point.
template <class Shape> class Thin final : public SurfaceParts {
public:
    Thin(Shape shape, std::vector<Vector3d> shifts) : shape_(std::move(shape)), shifts_(std::move(shifts)) {}

    [[nodiscard]] int primitives() const override { return static_cast<int>(shifts_.size()); }

    [[nodiscard]] double distance(int primitive, const Vector3d& point) const override {
        return shape_.away(point - shifts_[static_cast<std::size_t>(primitive)]).norm();
    }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        TouchList list(out);
        for (const int primitive : primitives) {
            const Vector3d point = centre - shifts_[static_cast<std::size_t>(primitive)];
            const Vector3d away = shape_.away(point);
            const double far = away.norm();
            if (far < radius)
                list.add({far > 0 ? Vector3d(away / far) : shape_.normal_on(point), far - radius, 0});
        }
        return list.count();
    }

private:
    Shape shape_;
    std::vector<Vector3d> shifts_;
};

struct Tube {
    Vector3d base, axis;
    double length = 0; // m, may be infinite, then to both sides
    double radius = 0;

    [[nodiscard]] Vector3d away(const Vector3d& point) const {
        const Vector3d from_base = point - base;
        const double along = from_base.dot(axis);
        const Vector3d across = from_base - along * axis;
        const double far = across.norm();
        // On the axis every direction is as near.
        const Vector3d radial = far > 0 ? Vector3d(across / far) : axis.unitOrthogonal();
        const double past = std::isinf(length) ? 0.0 : along - std::clamp(along, 0.0, length);
        return past * axis + (far - radius) * radial;
    }

    [[nodiscard]] Vector3d normal_on(const Vector3d& point) const {
        const Vector3d from_base = point - base;
        return -(from_base - from_base.dot(axis) * axis).normalized();
    }
};

struct Plate {
    Vector3d centre, normal;
    double radius = 0;
    double hole = 0;

    [[nodiscard]] Vector3d away(const Vector3d& point) const {
        const Vector3d from_centre = point - centre;
        const double height = from_centre.dot(normal);
        const Vector3d across = from_centre - height * normal;
        const double far = across.norm();
        const double past = far - std::clamp(far, hole, radius);
        if (past == 0)
            return height * normal;
        return height * normal + past * (far > 0 ? Vector3d(across / far) : normal.unitOrthogonal());
    }

    [[nodiscard]] Vector3d normal_on(const Vector3d&) const { return normal; }
};

} // namespace

scene::Box bounds_of(const scene::CylinderShape& shape) {
    const Vector3d axis = shape.axis.normalized(), spread = spread_across(axis, shape.radius);
    const Vector3d end = shape.base + shape.length * axis;
    return {shape.base.cwiseMin(end) - spread, shape.base.cwiseMax(end) + spread};
}

scene::Box bounds_of(const scene::DiscShape& shape) {
    const Vector3d spread = spread_across(shape.normal.normalized(), shape.radius);
    return {shape.centre - spread, shape.centre + spread};
}

SurfacePartsPtr cylinder_parts(const scene::CylinderShape& shape, const scene::Domain& domain) {
    Tube tube{shape.base, shape.axis.normalized(), shape.length, shape.radius};
    scene::Domain open = domain;
    for (int axis = 0; axis < 3; ++axis) {
        const double period = domain.box.hi[axis] - domain.box.lo[axis];
        const bool spans = std::abs(tube.axis[axis]) > 1 - 1e-12 && shape.length >= period * (1 - 1e-9);
        if (domain.periodic[static_cast<std::size_t>(axis)] && spans) {
            tube.length = std::numeric_limits<double>::infinity();
            open.periodic[static_cast<std::size_t>(axis)] = false;
        }
    }
    return std::make_shared<Thin<Tube>>(tube, periodic_shifts(bounds_of(shape), open));
}

SurfacePartsPtr disc_parts(const scene::DiscShape& shape, const scene::Domain& domain) {
    Plate plate{shape.centre, shape.normal.normalized(), shape.radius, shape.hole_radius};
    return std::make_shared<Thin<Plate>>(plate, periodic_shifts(bounds_of(shape), domain));
}

} // namespace tumble::sim3d
