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

/// One face of a box seen from inside. Of a box with an opening, which bodies may leave, it is a thin rectangle; of a
/// closed one it goes on for ever.
struct Face {
    int feature = 0; // as in BoxShape::open: -x +x -y +y -z +z
    int axis = 0;
    double at = 0;   // m, along the axis
    double side = 1; // +1: bodies are on the side of larger coordinates
    Vector3d lo = Vector3d::Constant(-std::numeric_limits<double>::infinity());
    Vector3d hi = Vector3d::Constant(std::numeric_limits<double>::infinity());
    bool has_rim = false;
    std::array<bool, 6> joined{}; // faces that it shares an edge with

    [[nodiscard]] double height(const Vector3d& point) const { return side * (point[axis] - at); }
    /// From the face's rim to the point, within the face's plane; zero over the face.
    [[nodiscard]] Vector3d beyond(const Vector3d& point) const { return point - point.cwiseMax(lo).cwiseMin(hi); }
    /// Whether the closest point, `beyond` away in the face's plane, is on an edge shared with a face that is as near
    /// or nearer and answers for it.
    [[nodiscard]] bool left_to_neighbour(const Vector3d& beyond, double height) const {
        for (int other = 0; other < 6; ++other) {
            const double past = (other % 2 == 0 ? -1 : 1) * beyond[other / 2];
            if (past > 0 && joined[static_cast<std::size_t>(other)] && (height >= 0 || other < feature))
                return true;
        }
        return false;
    }
};

class BoxInside final : public SurfaceParts {
public:
    BoxInside(const scene::BoxShape& shape, const scene::Domain& domain) {
        std::array<bool, 6> goes_on{}; // open to a periodic side
        bool has_opening = false;
        for (std::size_t side = 0; side < 6; ++side) {
            const auto axis = static_cast<Eigen::Index>(side / 2);
            const double slack = 1e-9 * (domain.box.hi[axis] - domain.box.lo[axis]);
            const bool at_end = side % 2 == 0 ? shape.box.lo[axis] <= domain.box.lo[axis] + slack
                                              : shape.box.hi[axis] >= domain.box.hi[axis] - slack;
            goes_on[side] = shape.open[side] && domain.periodic[side / 2] && at_end;
            has_opening = has_opening || (shape.open[side] && !goes_on[side]);
        }
        for (int feature = 0; feature < 6; ++feature)
            if (!shape.open[static_cast<std::size_t>(feature)])
                faces_.push_back(face(feature, shape, goes_on, has_opening));
    }

    [[nodiscard]] int primitives() const override { return static_cast<int>(faces_.size()); }

    [[nodiscard]] double distance(int primitive, const Vector3d& point) const override {
        const Face& face = faces_[static_cast<std::size_t>(primitive)];
        const double past_rim = face.beyond(point).squaredNorm(), height = face.height(point);
        return face.has_rim ? std::sqrt(past_rim + height * height) : height;
    }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        TouchList list(out);
        for (const int primitive : primitives) {
            const Face& face = faces_[static_cast<std::size_t>(primitive)];
            const double height = face.height(centre);
            Vector3d away = face.has_rim ? face.beyond(centre) : Vector3d::Zero();
            if (away.squaredNorm() > 0) {
                if (face.left_to_neighbour(away, height))
                    continue;
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
    static Face face(int feature, const scene::BoxShape& shape, const std::array<bool, 6>& goes_on, bool has_opening) {
        Face face;
        face.feature = feature;
        face.axis = feature / 2;
        face.side = feature % 2 == 0 ? 1 : -1;
        face.at = feature % 2 == 0 ? shape.box.lo[face.axis] : shape.box.hi[face.axis];
        face.has_rim = has_opening;
        for (int side = 0; has_opening && side < 6; ++side) {
            const auto s = static_cast<std::size_t>(side);
            if (side / 2 == face.axis || goes_on[s])
                continue;
            face.joined[s] = !shape.open[s];
            (side % 2 == 0 ? face.lo : face.hi)[side / 2] = (side % 2 == 0 ? shape.box.lo : shape.box.hi)[side / 2];
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
