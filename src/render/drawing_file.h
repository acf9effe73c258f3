#pragma once

#include "base/problem.h"
#include "render/drawing.h"

#include <filesystem>
#include <string>

namespace tumble::render {

/// Whether the name is that of a drawing, SVG or PDF, by its ending.
bool is_drawing_file(const std::filesystem::path& file);

/// Drawings as files: the same bytes for the same drawing. Text stays text; places in the SVG are mm on the page.
std::string encode_svg(const Drawing& drawing);
/// Throws std::bad_alloc.
std::string encode_pdf(const Drawing& drawing);

/// As the name ends, as a whole or not at all. Problems: what the system says of the file.
Result<Done> write_drawing(const Drawing& drawing, const std::filesystem::path& file);

} // namespace tumble::render
