#pragma once

#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <string>

namespace tumble::fem {

/// A VTU file (ParaView) of one load case: the part's hexahedra with displacement_m, load_N, stress_Pa (xx yy zz xy yz
/// zx) and von_mises_Pa at the nodes. `load`, `displacement`: rows 3 * node + axis; `stress`: rows 6 * node +
/// component.
std::string part_vtu(const solid::HexMesh& mesh, const Eigen::VectorXd& load, const Eigen::VectorXd& displacement,
                     const Eigen::VectorXd& stress, double time);

} // namespace tumble::fem
