#pragma once

#include "base/problem.h"
#include "fit/shapes.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

using fit::Triangle;

/// The most triangles a mesh may have.
inline constexpr std::size_t most_triangles = 2000000;

/// Triangles of an STL file, in the file's own unit, corners in the order written; normals of the file are ignored.
/// Binary when its length is 84 + 50 n, n being the count it states at byte 80; else ASCII: binary files may well begin
/// with "solid". Problems: not STL at all, cut short (binary: by triangle; ASCII: by line and column), a number that is
/// not finite, a triangle without area (by its number, from 1), none or too many. At most 20 problems are listed.
Result<std::vector<Triangle>> parse_stl(std::string_view bytes, const std::string& source);

/// The same of a file of at most 512 MiB. Problems also: what read_file reports.
Result<std::vector<Triangle>> read_stl(const std::filesystem::path& file);

} // namespace tumble::scene
