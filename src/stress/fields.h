#pragma once

#include "fem/component.h"
#include "fem/slice.h"
#include "observe/frame.h"
#include "render/field.h"
#include "solid/section.h"

/// A part's stress as surfaces to be drawn.
namespace tumble::stress {

/// The component at every node, Pa; `stress`: rows 6 * node + component.
std::vector<double> at_nodes(const fem::Component& component, const Eigen::VectorXd& stress);

/// The part's surface at its place in the world, with the edges of its facets.
render::Field surface_field(const solid::HexMesh& mesh, const observe::WallPlace& place,
                            const std::vector<double>& values);

/// A cut through the part at its place in the world, with the edges of its hexahedra.
render::Field section_field(const solid::HexMesh& mesh, const solid::Section& section, const observe::WallPlace& place,
                            const std::vector<double>& values);

/// A slice rolled out flat (rolled_out): along x its contour, along y how far along its `up` it lies from `base`.
/// `values`: a point of the slice each.
render::Field unrolled_field(const solid::HexMesh& mesh, const fem::Slice& slice, const Eigen::Vector3d& base,
                             const Eigen::Vector3d& ahead, const std::vector<double>& values);

} // namespace tumble::stress
