#pragma once

#include "base/problem.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tumble::render {

/// Colours along a scale from 0 to 1, evenly spaced, linear in between. Each step is seen as equally large; viridis,
/// cividis and inferno grow steadily lighter (they survive a grey printer), coolwarm is lightest in its middle.
struct ColorMap {
    std::string name;
    std::vector<std::array<std::uint8_t, 3>> points; // sRGB

    /// The colour (sRGB, 0 to 1) at `where`; below 0 and above 1 the end's colour; not a number: magenta, to be seen.
    [[nodiscard]] Eigen::Vector3d at(double where) const;

    /// The same as bytes red, green, blue, 255 in memory order.
    [[nodiscard]] std::uint32_t bytes_at(double where) const;
};

/// viridis, cividis, inferno, coolwarm, and auto: coolwarm for quantities with a sign, viridis for the others.
std::vector<std::string> color_map_names();

/// One colour (sRGB, 0 to 1) whatever the value.
ColorMap plain_color_map(const Eigen::Vector3d& color);

/// Problem names the nearest right word.
Result<ColorMap> find_color_map(const std::string& name, bool has_sign);

} // namespace tumble::render
