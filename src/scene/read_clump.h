#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// The most spheres one body may have.
inline constexpr std::size_t most_spheres = 4000; // sphere indices of the solver have 16 bits

/// Spheres of a body template, metres, template frame, in the order written. Two forms, told apart by the first line
/// that is not a comment: CSV below the head "x,y,z,radius", and LIGGGHTS' lines "x y z r" between blanks. '#' begins a
/// comment. Problems, each at its line and column: wrong number of columns, not a number, a radius not above 0, a value
/// beyond 100 m, no sphere at all, more than `most_spheres`. At most 20 problems are listed.
/// In two dimensions there are discs: no z, and the head is "x,y,radius".
Result<std::vector<Sphere>> parse_clump(std::string_view text, const std::string& source, int dimension = 3);

/// The same of a file of at most 16 MiB. Problems also: what read_file reports.
Result<std::vector<Sphere>> read_clump(const std::filesystem::path& file, int dimension = 3);

} // namespace tumble::scene
