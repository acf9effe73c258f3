#pragma once

#include "base/problem.h"
#include "fem/brick.h"

#include <string>
#include <vector>

namespace tumble::fem {

/// One number of a stress that a picture can show, Pa. compression and tension are the least and the largest principal
/// stress.
struct Component {
    std::string name;
    std::string label; // short: a legend has room for little more than its unit
    bool has_sign = false;
    double (*of)(const Stress&) = nullptr;
};

/// A new one is a line there.
const std::vector<Component>& components();

std::vector<std::string> component_names();

/// Problem names the nearest right word.
Result<Component> find_component(const std::string& name);

} // namespace tumble::fem
