#pragma once

#include "base/problem.h"
#include "scene/text_tree.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace tumble::scene {

/// The largest scene file that is read, bytes: a resolved scene with 100,000 spheres written out still fits.
inline constexpr std::size_t largest_scene = 16 * 1024 * 1024;

/// The root table of a TOML text; `source` is the name that its places carry. Problems: wrong TOML, nested too deeply.
Result<Node> parse_toml(std::string_view text, const std::string& source);

} // namespace tumble::scene
