#pragma once

#include "fem/slice.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::stress {

/// A side of a part, rolled out flat.
struct RolledOut {
    struct Point {
        int node = 0;
        double along = 0; // m, along the contour
    };
    std::vector<Point> points;              // a node twice where the side was cut open
    std::vector<std::array<int, 4>> facets; // corners into points, parallel to the side's facet set
};

/// A side that goes all round the axis through `base` as a circle does is rolled out with the arcs of the slice's own
/// radius. Any other keeps the widths of its facets, one beside the other along its contour, whatever corners it has;
/// where its contour closes, it is cut open half way round from what lies `ahead` of the axis, a direction across it.
/// A side in pieces, as the outside and the bore of a tube, lies there piece beside piece. All lie as they are seen
/// from outside of the part, `up` upwards: to the right goes anticlockwise about the axis, and clockwise in a bore.
RolledOut rolled_out(const solid::HexMesh& mesh, const fem::Slice& slice, const Eigen::Vector3d& base,
                     const Eigen::Vector3d& ahead);

} // namespace tumble::stress
