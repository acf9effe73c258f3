#pragma once

#include "base/problem.h"
#include "solid/hex_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

/// Mesh files of gmsh.
namespace tumble::solid {

/// The mesh of a file's text, format 2.2 or 4.1, ASCII, as gmsh's manual describes them ("MSH file format"): $Nodes,
/// $Elements of type 5 (eight-node hexahedra), and physical groups of points, lines, surfaces and volumes as node sets
/// under their $PhysicalNames, or their number where they have no name. Points, lines and surfaces serve no other
/// purpose; other sections are passed over. Coordinates are multiplied by `scale` (metres per unit of the file).
/// Problems, with line: another format or a binary file, other solid elements, a section that ends too early, numbers
/// that are none or are there twice, nodes that are not there; then those of finished().
bool is_gmsh(const std::filesystem::path& file); // by its ending; all others are read as .inp
Result<HexMesh> parse_msh(std::string_view text, const std::string& file, double scale = 1);
Result<HexMesh> read_msh(const std::filesystem::path& file, double scale = 1);

} // namespace tumble::solid
