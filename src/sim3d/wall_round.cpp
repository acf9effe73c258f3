#include "scene/extent.h"
#include "sim3d/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

/// Unit; on the axis every direction is as near.
Vector3d outwards(const Vector3d& across, const Vector3d& axis) {
    const double far = across.norm();
    return far > 0 ? Vector3d(across / far) : axis.unitOrthogonal();
}

/// The quarter of a circle in the plane across `axis` in which a direction lies, 1 to 4; 5 less it is the one opposite.
int quarter_of(const Vector3d& axis, const Vector3d& direction) {
    const Vector3d first = axis.unitOrthogonal();
    return 1 + (direction.dot(first) < 0 ? 1 : 0) + (direction.dot(axis.cross(first)) < 0 ? 2 : 0);
}

/// A thin surface of revolution that stands at one place or more: the side on which the centre is, is the side that
/// pushes. `Shape` gives the vectors to a point from its closest point and from its axis. A sphere wider than the
/// opening also meets the point across; there features are quarters of the circle, so that a history stays where it is
/// when the centre passes the axis and the nearest point becomes the farthest.
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
            if (far >= radius)
                continue;
            const Vector3d across = shape_.across(point);
            const bool fills = radius > shape_.opening() && across.norm() < shape_.opening();
            const Vector3d radial = outwards(across, shape_.axis);
            const int quarter = fills ? quarter_of(shape_.axis, radial) : 0;
            list.add({far > 0 ? Vector3d(away / far) : shape_.normal_on(point), far - radius, quarter});
            const Vector3d opposite = away + 2 * shape_.opening() * radial;
            if (fills)
                list.add({opposite.normalized(), opposite.norm() - radius, 5 - quarter});
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

    [[nodiscard]] double opening() const { return radius; }
    [[nodiscard]] Vector3d across(const Vector3d& point) const {
        const Vector3d from_base = point - base;
        return from_base - from_base.dot(axis) * axis;
    }
    [[nodiscard]] Vector3d away(const Vector3d& point) const {
        const double along = (point - base).dot(axis);
        const Vector3d from_axis = across(point);
        const double past = std::isinf(length) ? 0.0 : along - std::clamp(along, 0.0, length);
        return past * axis + (from_axis.norm() - radius) * outwards(from_axis, axis);
    }
    [[nodiscard]] Vector3d normal_on(const Vector3d& point) const { return -across(point).normalized(); }
};

struct Plate {
    Vector3d centre, axis;
    double radius = 0;
    double hole = 0;

    [[nodiscard]] double opening() const { return hole; }
    [[nodiscard]] Vector3d across(const Vector3d& point) const {
        const Vector3d from_centre = point - centre;
        return from_centre - from_centre.dot(axis) * axis;
    }
    [[nodiscard]] Vector3d away(const Vector3d& point) const {
        const double height = (point - centre).dot(axis);
        const Vector3d from_axis = across(point);
        const double far = from_axis.norm();
        const double past = far - std::clamp(far, hole, radius);
        return past == 0 ? Vector3d(height * axis) : Vector3d(height * axis + past * outwards(from_axis, axis));
    }
    [[nodiscard]] Vector3d normal_on(const Vector3d&) const { return axis; }
};

} // namespace

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
    return std::make_shared<Thin<Tube>>(tube, periodic_shifts(scene::extent_of(shape), open));
}

SurfacePartsPtr disc_parts(const scene::DiscShape& shape, const scene::Domain& domain) {
    Plate plate{shape.centre, shape.normal.normalized(), shape.radius, shape.hole_radius};
    return std::make_shared<Thin<Plate>>(plate, periodic_shifts(scene::extent_of(shape), domain));
}

} // namespace tumble::sim3d
