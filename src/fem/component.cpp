#include "fem/component.h"

#include "base/text.h"
#include "fem/cauchy.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::fem {

namespace {

/// Ascending.
Eigen::Vector3d principal(const Stress& s) {
    Eigen::Matrix3d tensor;
    tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(tensor, Eigen::EigenvaluesOnly);
    return solver.eigenvalues();
}

} // namespace

const std::vector<Component>& components() {
    static const std::vector<Component> all{
        {"von_mises", "von Mises", false, von_mises},
        {"mean", "mean", true, [](const Stress& s) { return (s[0] + s[1] + s[2]) / 3; }},
        {"compression", "compression", true, [](const Stress& s) { return principal(s)[0]; }},
        {"tension", "tension", true, [](const Stress& s) { return principal(s)[2]; }},
        {"xx", "xx", true, [](const Stress& s) { return s[0]; }},
        {"yy", "yy", true, [](const Stress& s) { return s[1]; }},
        {"zz", "zz", true, [](const Stress& s) { return s[2]; }},
        {"xy", "xy", true, [](const Stress& s) { return s[3]; }},
        {"yz", "yz", true, [](const Stress& s) { return s[4]; }},
        {"zx", "zx", true, [](const Stress& s) { return s[5]; }},
    };
    return all;
}

std::vector<std::string> component_names() {
    std::vector<std::string> names;
    for (const Component& component : components())
        names.push_back(component.name);
    return names;
}

Result<Component> find_component(const std::string& name) {
    for (const Component& component : components())
        if (component.name == name)
            return component;
    const std::vector<std::string> names = component_names();
    const std::string guess = did_you_mean(name, names);
    return Problem{.what = fmt::format("there is no stress component '{}'", name),
                   .fix = (guess.empty() ? "" : guess + "  ") + fmt::format("known: {}", fmt::join(names, ", "))};
}

} // namespace tumble::fem
