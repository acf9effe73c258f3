#pragma once

#include "base/problem.h"
#include "solid/generate.h"
#include "solid/hex_mesh.h"

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Input files of CalculiX and Abaqus.
namespace tumble::solid {

/// The mesh of a file's text: *NODE, *ELEMENT of TYPE C3D8, C3D8I or C3D8R, *NSET (also GENERATE); keywords that make
/// or move nodes are problems, others, lines and surfaces are passed over with their data. Coordinates are multiplied
/// by `scale` (metres per unit of the file). Problems, with line: no such node, a number that is none, a line that is
/// too short, numbers given twice, other solid elements; then those of finished().
Result<HexMesh> parse_inp(std::string_view text, const std::string& file, double scale = 1);
Result<HexMesh> read_inp(const std::filesystem::path& file, double scale = 1);

/// A part from such a file. Facet sets by its axis: base and top, which face along it, and side, all others.
struct MeshFile {
    std::filesystem::path file;
    double scale = 1; // metres per unit of the file
};
/// Problems: those of read_inp. Of the place only the axis counts: the file says where the part stands.
Result<HexMesh> mesh_of(const MeshFile& part, const Place& place);

/// What a model says beside its mesh.
struct InpModel {
    double youngs_modulus = 0; // Pa
    double poisson_ratio = 0;
    std::string element = "C3D8";       // or C3D8I
    std::vector<std::string> held;      // node sets whose nodes do not move
    bool as_text = false;               // displacements and stresses at integration points in .dat, too
    std::vector<std::string> remarks{}; // comments at its head, beside units and element
};

/// A load case as a step of the model: forces on nodes, 3 x nodes, N.
struct InpStep {
    std::string name; // a comment
    Eigen::Matrix3Xd force;
};

/// Model and steps as CalculiX reads them, behind comments that say units and element: metres, newtons, pascals;
/// numbers of up to 20 letters, which hold 14 digits at least. Each step replaces the forces of the one before. Results
/// asked for: displacements and stresses at nodes
/// (.frd).
std::string to_inp(const HexMesh& mesh, const InpModel& model, const std::vector<InpStep>& steps);

} // namespace tumble::solid
