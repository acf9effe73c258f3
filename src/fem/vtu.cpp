#include "fem/vtu.h"

#include "fem/cauchy.h"
#include "observe/xml_arrays.h"

#include <fmt/format.h>
#include <vector>

namespace tumble::fem {

namespace {

constexpr std::uint8_t vtk_hexahedron = 12; // its corners are in our order

std::vector<float> floats(const Eigen::VectorXd& values) {
    const Eigen::VectorXf narrow = values.cast<float>();
    return {narrow.data(), narrow.data() + narrow.size()};
}

} // namespace

std::string part_vtu(const solid::HexMesh& mesh, const Eigen::VectorXd& load, const Eigen::VectorXd& displacement,
                     const Eigen::VectorXd& stress, double time) {
    std::vector<float> positions, von_mises_Pa;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis)
            positions.push_back(static_cast<float>(mesh.nodes[n][axis]));
        von_mises_Pa.push_back(static_cast<float>(von_mises(stress.segment<6>(static_cast<Eigen::Index>(6 * n)))));
    }
    std::vector<std::int64_t> corners, ends, nodes(mesh.node_numbers.begin(), mesh.node_numbers.end()),
        elements(mesh.hex_numbers.begin(), mesh.hex_numbers.end());
    for (const auto& hex : mesh.hexes) {
        corners.insert(corners.end(), hex.begin(), hex.end());
        ends.push_back(static_cast<std::int64_t>(corners.size()));
    }
    const std::vector<std::uint8_t> types(mesh.hexes.size(), vtk_hexahedron);
    using observe::data_array;
    return observe::unstructured_grid_file(
        fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n{}{}{}{}{}</PointData>\n"
                    "<CellData>\n{}</CellData>\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n</Piece>\n",
                    mesh.nodes.size(), mesh.hexes.size(), data_array("node", nodes, 1),
                    data_array("displacement_m", floats(displacement), 3), data_array("load_N", floats(load), 3),
                    data_array("stress_Pa", floats(stress), 6), data_array("von_mises_Pa", von_mises_Pa, 1),
                    data_array("element", elements, 1), data_array("Points", positions, 3),
                    data_array("connectivity", corners, 1), data_array("offsets", ends, 1),
                    data_array("types", types, 1)),
        time);
}

} // namespace tumble::fem
