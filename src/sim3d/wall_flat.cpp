#include "sim3d/wall_parts.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

class Plane final : public SurfaceParts {
public:
    explicit Plane(const scene::PlaneShape& shape) : point_(shape.point), normal_(shape.normal.normalized()) {}

    [[nodiscard]] int primitives() const override { return 1; }

    [[nodiscard]] double distance(int, const Vector3d& point) const override { return normal_.dot(point - point_); }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        TouchList list(out);
        if (!primitives.empty())
            list.add({normal_, distance(0, centre) - radius, 0});
        return list.count();
    }

private:
    Vector3d point_, normal_;
};

/// One face of a box seen from inside. It ends where its neighbour is open, and goes on for ever behind a closed one.
struct Face {
    int feature = 0; // as in BoxShape::open: -x +x -y +y -z +z
    int axis = 0;
    double at = 0;   // m, along the axis
    double side = 1; // +1: bodies are on the side of larger coordinates
    Vector3d lo = Vector3d::Constant(-std::numeric_limits<double>::infinity());
    Vector3d hi = Vector3d::Constant(std::numeric_limits<double>::infinity());
    bool has_rim = false;

    [[nodiscard]] double height(const Vector3d& point) const { return side * (point[axis] - at); }
    /// From the face's rim to the point, within the face's plane; zero over the face.
    [[nodiscard]] Vector3d beyond(const Vector3d& point) const { return point - point.cwiseMax(lo).cwiseMin(hi); }
};

class BoxInside final : public SurfaceParts {
public:
    BoxInside(const scene::BoxShape& shape, const scene::Domain& domain) {
        for (int feature = 0; feature < 6; ++feature)
            if (!shape.open[static_cast<std::size_t>(feature)])
                faces_.push_back(face(feature, shape, domain));
    }

    [[nodiscard]] int primitives() const override { return static_cast<int>(faces_.size()); }

    [[nodiscard]] double distance(int primitive, const Vector3d& point) const override {
        const Face& face = faces_[static_cast<std::size_t>(primitive)];
        const double past_rim = face.beyond(point).squaredNorm(), height = face.height(point);
        return past_rim > 0 ? std::sqrt(past_rim + height * height) : height;
    }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        TouchList list(out);
        for (const int primitive : primitives) {
            const Face& face = faces_[static_cast<std::size_t>(primitive)];
            const double height = face.height(centre);
            Vector3d away = face.has_rim ? face.beyond(centre) : Vector3d::Zero();
            if (away.squaredNorm() > 0) {
                away[face.axis] = face.side * height;
                const double far = away.norm();
                list.add({away / far, far - radius, face.feature});
            } else {
                list.add(touch_from_inside(face.side * Vector3d::Unit(face.axis), height, radius, face.feature,
                                           face.has_rim));
            }
        }
        return list.count();
    }

private:
    static Face face(int feature, const scene::BoxShape& shape, const scene::Domain& domain) {
        Face face;
        face.feature = feature;
        face.axis = feature / 2;
        face.side = feature % 2 == 0 ? 1 : -1;
        face.at = feature % 2 == 0 ? shape.box.lo[face.axis] : shape.box.hi[face.axis];
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == face.axis)
                continue;
            const auto a = static_cast<std::size_t>(axis);
            const double slack = 1e-9 * (domain.box.hi[axis] - domain.box.lo[axis]);
            const bool periodic = domain.periodic[a];
            // Through a periodic side the face goes on.
            const bool rim_lo = shape.open[2 * a] && !(periodic && shape.box.lo[axis] <= domain.box.lo[axis] + slack);
            const bool rim_hi =
                shape.open[2 * a + 1] && !(periodic && shape.box.hi[axis] >= domain.box.hi[axis] - slack);
            if (rim_lo)
                face.lo[axis] = shape.box.lo[axis];
            if (rim_hi)
                face.hi[axis] = shape.box.hi[axis];
            face.has_rim = face.has_rim || rim_lo || rim_hi;
        }
        return face;
    }

    std::vector<Face> faces_;
};

} // namespace

SurfacePartsPtr plane_parts(const scene::PlaneShape& shape) {
    return std::make_shared<Plane>(shape);
}

SurfacePartsPtr box_parts(const scene::BoxShape& shape, const scene::Domain& domain) {
    return std::make_shared<BoxInside>(shape, domain);
}

} // namespace tumble::sim3d
