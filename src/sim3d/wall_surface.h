#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

namespace tumble::sim3d {

/// Where a sphere touches a wall, in the wall's own frame.
struct WallTouch {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // unit, from the wall's closest point to the sphere's centre
    double gap = 0;                                   // m, distance - radius; negative: overlap
    int feature = 0;  // the same while the sphere stays on one smooth patch; a history belongs to it
    int triangle = 0; // of a mesh: the one touched
};

/// Whether all the wall's motion is that of a round shape about its own axis: a disc, a tube, a bowl or bowl-disc
/// without ribs (whose facets stand for a round surface). Its surface moves, its place does not.
bool turns_in_place(const scene::Wall& wall);

class SurfaceParts;

/// The geometry of a wall in its own, unmoved frame; docs/walls.md. Immutable, cheap to copy, safe to ask from any
/// thread.
///
/// Periodic sides are the surface's business: it goes on through them (meshes, discs and cylinders are repeated half
/// a period beyond, edges that the repetition closes are no edges), so a body is asked about once, with the
/// unshifted place of its centre in the domain, also for spheres that reach out of it. A copy has its original's
/// features.
class WallSurface {
public:
    WallSurface() = default; // nothing: no primitives

    /// Problems: a size that is not positive, a mesh without triangles, a triangle without area, a triangle that is
    /// there twice; with the triangle's number, counted from 1.
    static Result<WallSurface> make(const scene::WallShape& shape, const scene::Domain& domain);

    [[nodiscard]] int primitives() const;

    /// All primitives nearer to `centre` than `reach` (m), ascending; `out` is emptied first.
    void primitives_near(const Eigen::Vector3d& centre, double reach, std::vector<int>& out) const;

    /// Distance from the primitive to the point, m; negative behind a plane, a closed box and the trough.
    [[nodiscard]] double distance(int primitive, const Eigen::Vector3d& point) const;

    /// Touching features only (gap < 0), each once, ascending by feature; returns how many. `primitives` must hold, in
    /// ascending order, all that are nearer than `radius`; more do no harm. If there is more than `out` can hold, the
    /// deepest stay.
    int touches(const Eigen::Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const;

private:
    std::shared_ptr<const SurfaceParts> parts_;
};

} // namespace tumble::sim3d
