#pragma once

#include "base/problem.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>

/// Specimens from parameters. Both stand on `base` and reach along `axis`; they carry the node sets "base" and "top"
/// (their ends) and facet sets by the side that faces outwards.
namespace tumble::solid {

/// Where a part stands: its own y axis lies along `axis`.
struct Place {
    Eigen::Vector3d base = Eigen::Vector3d::Zero();  // m, centre of the lower end
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY(); // unit
};

/// A cylinder with a through hole. Its outer shell has rings of its own, so that it can be finer. Facet sets: side,
/// bore, base, top.
struct BoredCylinder {
    double length = 0;      // m
    double radius = 0;      // m, of the circle on which the outer corners lie
    double bore_radius = 0; // m
    double shell = 0;       // m, thickness of the outer shell
    int around = 0;         // hexahedra about the axis
    int along = 0;          // along it
    int shell_rings = 0;    // across the shell
    int inner_rings = 0;    // across the rest
};

/// A square prism whose corners are refined: on each side `corner` m at either end hold `corner_cells` each. Facet
/// sets: -x, +x, -z, +z (in the part's own axes), base, top.
struct Prism {
    double length = 0; // m
    double side = 0;   // m
    double corner = 0; // m, of the side, at either end
    int corner_cells = 0;
    int middle_cells = 0;
    int along = 0;
};

/// Problems carry the key to change: sizes that leave nothing, counts below 1 (three about an axis).
Result<HexMesh> mesh_of(const BoredCylinder& part, const Place& place);
Result<HexMesh> mesh_of(const Prism& part, const Place& place);

} // namespace tumble::solid
