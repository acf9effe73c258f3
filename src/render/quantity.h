#pragma once

#include "base/problem.h"
#include "observe/frame.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tumble::render {

/// One number a body that a picture can show as colour.
struct Quantity {
    std::string name;
    std::string label;     // empty: none is shown, and bodies are all alike
    std::string unit;      // SI
    bool has_sign = false; // zero is the middle of an automatic range
    double (*of)(const observe::Frame& frame, std::size_t body) = nullptr;
};

/// All that can be shown. A new one is a line here.
const std::vector<Quantity>& quantities();

/// Of those that a scene of that dimension (2 or 3) has. Problem names the nearest right word.
Result<Quantity> find_quantity(const std::string& name, int dimension = 3);

/// The quantity for every body of a frame, in its unit.
std::vector<double> values_of(const Quantity& quantity, const observe::Frame& frame);

} // namespace tumble::render
