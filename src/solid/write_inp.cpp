#include "base/text.h"
#include "solid/inp.h"

#include <fmt/format.h>

namespace tumble::solid {

namespace {

/// CalculiX 2.20 reads 20 letters of a number; a longer one was an error.
std::string field(double value) {
    std::string text = shortest(value);
    return text.size() <= 20 ? text : fmt::format("{:.13e}", value);
}

void write_set(std::string& text, const std::string& name, const std::vector<int>& nodes, const HexMesh& mesh) {
    text += fmt::format("*NSET, NSET={}\n", name);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        text += fmt::format("{}{}", mesh.node_numbers[static_cast<std::size_t>(nodes[k])],
                            k % 12 == 11 || k + 1 == nodes.size() ? "\n" : ", ");
}

void write_step(std::string& text, const InpStep& step, const HexMesh& mesh, bool as_text) {
    text += fmt::format("** {}\n*STEP\n*STATIC\n*CLOAD, OP=NEW\n", step.name);
    for (Eigen::Index n = 0; n < step.force.cols(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            if (step.force(axis, n) != 0)
                text += fmt::format("{}, {}, {}\n", mesh.node_numbers[static_cast<std::size_t>(n)], axis + 1,
                                    field(step.force(axis, n)));
    text += "*NODE FILE\nU\n*EL FILE\nS\n";
    if (as_text)
        text += "*NODE PRINT, NSET=ALL\nU\n*EL PRINT, ELSET=PART\nS\n";
    text += "*END STEP\n";
}

} // namespace

std::string to_inp(const HexMesh& mesh, const InpModel& model, const std::vector<InpStep>& steps) {
    std::string text = "*NODE, NSET=ALL\n";
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        text += fmt::format("{}, {}, {}, {}\n", mesh.node_numbers[n], field(mesh.nodes[n].x()),
                            field(mesh.nodes[n].y()), field(mesh.nodes[n].z()));
    text += fmt::format("*ELEMENT, TYPE={}, ELSET=PART\n", model.element);
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e) {
        text += fmt::format("{}", mesh.hex_numbers[e]);
        for (const int node : mesh.hexes[e])
            text += fmt::format(", {}", mesh.node_numbers[static_cast<std::size_t>(node)]);
        text += "\n";
    }
    for (const auto& [name, nodes] : mesh.node_sets)
        if (name != "ALL")
            write_set(text, name, nodes, mesh);
    text += fmt::format("*MATERIAL, NAME=SOLID\n*ELASTIC\n{}, {}\n*SOLID SECTION, ELSET=PART, MATERIAL=SOLID\n",
                        field(model.youngs_modulus), field(model.poisson_ratio));
    if (!model.held.empty())
        text += "*BOUNDARY\n";
    for (const std::string& set : model.held)
        text += fmt::format("{}, 1, 3\n", set);
    for (const InpStep& step : steps)
        write_step(text, step, mesh, model.as_text);
    return text;
}

} // namespace tumble::solid
