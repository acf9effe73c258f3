#pragma once

#include "fem/slice.h"

#include <optional>

namespace tumble::fem {

/// A slice that lies behind a gap in the part, as beyond a bore: straight beneath the surface means the first wall.
/// The way is looked at in steps of half the shortest edge of the surface, which a gap's own facets cannot hide
/// between.
std::optional<Problem> beyond_first_wall(const Slice& slice, const solid::HexMesh& mesh, const solid::Locator& locator);

} // namespace tumble::fem
