#pragma once

#include "base/problem.h"
#include "scene/scene.h"
#include "sim3d/wall_surface.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace tumble::sim3d {

/// One kind of wall behind WallSurface, which says what the functions mean.
class SurfaceParts {
public:
    virtual ~SurfaceParts() = default;
    [[nodiscard]] virtual int primitives() const = 0;
    virtual void primitives_near(const Eigen::Vector3d& centre, double reach, std::vector<int>& out) const;
    [[nodiscard]] virtual double distance(int primitive, const Eigen::Vector3d& point) const = 0;
    virtual int touches(const Eigen::Vector3d& centre, double radius, std::span<const int> primitives,
                        std::span<WallTouch> out) const = 0;
};

using SurfacePartsPtr = std::shared_ptr<const SurfaceParts>;

// Sizes and directions are checked before (wall_surface.cpp); only a mesh has more that can be wrong.
SurfacePartsPtr plane_parts(const scene::PlaneShape& shape);
SurfacePartsPtr box_parts(const scene::BoxShape& shape, const scene::Domain& domain);
SurfacePartsPtr cylinder_parts(const scene::CylinderShape& shape, const scene::Domain& domain);
SurfacePartsPtr disc_parts(const scene::DiscShape& shape, const scene::Domain& domain);
SurfacePartsPtr trough_parts(const scene::TroughShape& shape);
Result<SurfacePartsPtr> mesh_parts(const scene::MeshShape& shape, const scene::Domain& domain);

/// Collects touches into a caller's span: ascending by feature, the deepest per feature, the deepest of all if it
/// fills.
class TouchList {
public:
    explicit TouchList(std::span<WallTouch> out) : out_(out) {}
    void add(const WallTouch& touch);
    [[nodiscard]] int count() const { return static_cast<int>(count_); }

private:
    std::span<WallTouch> out_;
    std::size_t count_ = 0;
};

/// From this share of the radius on, a centre behind a surface that bodies can also reach from behind (over its rim)
/// counts as standing outside; less than that, it was pressed through and is pushed back in. docs/walls.md
constexpr double pressed_through = 0.5;

/// Sphere against a smooth surface with an inside: `height` is the centre's distance along `inward`, negative behind.
WallTouch touch_from_inside(const Eigen::Vector3d& inward, double height, double radius, int feature, bool has_rim);

/// Shifts (m) at which a finite wall stands in a periodic domain, its own place (zero) first: one period to either side
/// along each periodic axis, except along an axis on which the wall is longer than the period.
std::vector<Eigen::Vector3d> periodic_shifts(const scene::Box& bounds, const scene::Domain& domain);

} // namespace tumble::sim3d
