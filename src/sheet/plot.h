#pragma once

#include "base/problem.h"
#include "sheet/canvas.h"
#include "sheet/sheet.h"

#include <filesystem>
#include <string>
#include <vector>

/// Figures as files, drawn by gnuplot.
namespace tumble::sheet {

/// What gnuplot is told to draw the figure to a file, of the kinds that open_canvas knows.
std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file, Canvas canvas = {});

/// A line that changes with what is plotted, not with rounding: "<!-- plotted 0123456789abcdef -->".
std::string mark_of(const Figure& figure);

/// Draws the figure to a file; an SVG ends with its mark. Problems: gnuplot is not installed, or what it said when it
/// failed.
Result<Done> draw(const Figure& figure, const std::filesystem::path& file, const Canvas& canvas = {});

/// Draws every figure into a folder, which is made, once per ending (".png"). The files written, or what went wrong.
Result<std::vector<std::filesystem::path>> draw_all(const Sheet& sheet, const std::filesystem::path& folder,
                                                    const std::vector<std::string>& endings, const Canvas& canvas = {});

} // namespace tumble::sheet
