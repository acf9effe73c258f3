#pragma once

#include "base/problem.h"
#include "fem/cauchy.h"
#include "solid/hex_mesh.h"
#include "solid/locate.h"

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Stresses beneath a part's surface, thesis 7.5.3 and 7.6.1.
namespace tumble::fem {

/// A place straight beneath a node of the surface.
struct SlicePoint {
    int node = 0;
    double area = 0;                                 // m2, the node's share of the facets that meet there
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); // m
    solid::Inside inside;
    Directions directions;                                 // normal: the mean of those facets'
    double edge = std::numeric_limits<double>::infinity(); // m, from the node to where the side ends
    double height = 0;                                     // along the part's axis, 0 at its lower end, 1 at its upper
};

struct Slice {
    std::string side; // facet set
    double depth = 0; // m
    std::vector<SlicePoint> points;
    /// Unit; what SlicePoint::directions take for the axis: the part's, or beneath an end -z of the scene without what
    /// it has along the axis (y, where that is z).
    Eigen::Vector3d up = Eigen::Vector3d::UnitY();

    [[nodiscard]] bool beneath_end(const Eigen::Vector3d& axis) const { return std::abs(up.dot(axis)) < 0.5; }
};

/// Beneath every node of a facet set, of a side along the axis or an end across it. Problems: no such set; one that
/// lies along the axis here and across it there, a point that lies outside of the part (too deep), with the element or
/// node.
Result<Slice> slice_of(const solid::HexMesh& mesh, const solid::Locator& locator, const std::string& side,
                       const Eigen::Vector3d& axis, double depth);

/// Components along normal, contour and axis at the slice's points, Pa, from one case's nodal stresses.
Eigen::Matrix3Xd components_on(const Slice& slice, const solid::HexMesh& mesh, const Eigen::VectorXd& stress);

/// What tables 7.3 to 7.5 are made of, of one case on one slice, Pa.
struct SliceFigures {
    double normal = 0;             // the normal stress that is largest in size, with its sign
    double contour = 0, along = 0; // largest in size, as sizes
    double compression = 0;        // least normal stress, 0 or below
    double tension = 0;            // largest, 0 or above
    double mean_compression = 0;   // over points below -trivial
    double mean_tension = 0;       // over points above trivial
    int compressed = 0;            // points
    int stretched = 0;
    double compressed_area = 0; // share of the area, beyond trivial
    double stretched_area = 0;
    int worst_point = 0; // of `normal`
    // Means over the area of the normal stress' size; NaN where no point is.
    double near_edges = 0; // Pa
    double elsewhere = 0;  // Pa

    /// Compression's share of the two means, as table 7.4 has it; NaN where there is neither.
    [[nodiscard]] double compressive_share() const { return mean_compression / (mean_compression - mean_tension); }
};

/// Which points count as what.
struct Counting {
    double trivial = 0; // Pa, normal stresses below are neither compression nor tension; the thesis has 500
    double lower = 1;   // share of the part's length, from its lower end, that counts at all; the thesis has a half
    double edge = 0;    // m, points so near to an end of their side are near its edges

    [[nodiscard]] bool takes(const SlicePoint& point) const { return point.height <= lower + 1e-9; } // but for rounding
};
/// Stresses are NaN where no point counts.
SliceFigures figures_of(const Slice& slice, const Eigen::Matrix3Xd& components, const Counting& counting);

} // namespace tumble::fem
