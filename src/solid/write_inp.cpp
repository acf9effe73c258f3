#include "base/text.h"
#include "solid/inp.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tumble::solid {

namespace {

/// CalculiX 2.20 reads 20 letters of a number; a longer one was an error.
std::string field(double value) {
    std::string text = shortest(value);
    return text.size() <= 20 ? text : fmt::format("{:.13e}", value);
}

/// A comment ends with its line.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return text;
}

void write_set(std::string& text, const std::string& name, const std::vector<int>& nodes, const HexMesh& mesh) {
    text += fmt::format("*NSET, NSET={}\n", name);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        text += fmt::format("{}{}", mesh.node_numbers[static_cast<std::size_t>(nodes[k])],
                            k % 12 == 11 || k + 1 == nodes.size() ? "\n" : ", ");
}

/// A name for the set of all nodes; a file's own "all" may hold but some. CalculiX reads names without their case.
std::string name_of_all(const HexMesh& mesh) {
    std::string all = "ALL";
    for (bool taken = true; taken;) {
        taken = std::any_of(mesh.node_sets.begin(), mesh.node_sets.end(), [&](const auto& set) {
            return set.second.size() < mesh.nodes.size() &&
                   std::equal(set.first.begin(), set.first.end(), all.begin(), all.end(),
                              [](unsigned char a, char b) { return std::toupper(a) == b; });
        });
        if (taken)
            all += "_";
    }
    return all;
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
        text += fmt::format("*NODE PRINT, NSET={}\nU\n*EL PRINT, ELSET=PART\nS\n", name_of_all(mesh));
    text += "*END STEP\n";
}

} // namespace

std::string to_inp(const HexMesh& mesh, const InpModel& model, const std::vector<InpStep>& steps) {
    const std::string all = name_of_all(mesh);
    std::string text;
    for (const std::string& remark : model.remarks)
        text += "** " + one_line(remark) + "\n";
    text += fmt::format("** units: m, N, Pa; {} {} elements of {} nodes\n", mesh.hexes.size(), model.element,
                        mesh.nodes.size());
    text += fmt::format("*NODE, NSET={}\n", all);
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
        if (name != all)
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
