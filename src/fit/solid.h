#pragma once

#include "base/problem.h"
#include "base/triangle_tree.h"
#include "fit/shapes.h"

#include <Eigen/Core>
#include <limits>
#include <vector>

/// Solids that spheres are fitted to.
namespace tumble::fit {

/// A closed surface, its triangles turned outwards, and what it encloses.
struct Solid {
    std::vector<Triangle> faces;                      // m
    double volume = 0;                                // m3
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); // m, of the volume
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero(); // m5, integral of (x - centre)(x - centre)^T
    double area = 0;                                  // m2
};

/// Problems: an edge that does not belong to exactly two triangles (an open mesh, or sheets that share an edge), two
/// triangles that are turned against each other, no volume.
Result<Solid> solid_of(std::vector<Triangle> faces);

/// The cone with a base of 720 corners, whose volume is 1.3e-5 below the round one's.
Solid solid_of(const Cone& cone);

/// Distance from the point to the surface, m, positive inside.
double depth_in(const Solid& solid, const Eigen::Vector3d& point);

/// Asks one solid how deep many points lie in it.
class Depths {
public:
    explicit Depths(const Solid& solid);

    /// Squared distance to the surface, m2, where it is below `bound`, else `bound`.
    [[nodiscard]] double distance2(const Eigen::Vector3d& point,
                                   double bound = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] bool inside(const Eigen::Vector3d& point) const;
    /// depth_in of the solid, by the same bits.
    [[nodiscard]] double at(const Eigen::Vector3d& point) const;

private:
    const Solid& solid_; // outlives this
    std::vector<FlatTriangle> flats_;
    TriangleTree tree_;
    double slack_ = 0; // m2
};

/// Points spread evenly over the surface, the same for the same solid.
std::vector<Eigen::Vector3d> surface_points(const Solid& solid, int count);

} // namespace tumble::fit
