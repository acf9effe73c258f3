#pragma once

#include "base/problem.h"
#include "lesson/walk.h"

#include <filesystem>
#include <string>

/// Figures as files, drawn by gnuplot.
namespace tumble::lesson {

/// What gnuplot is told to draw the figure to a file; .png and .svg are known.
std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file);

/// A line that changes with what is plotted, not with rounding: "<!-- plotted 0123456789abcdef -->".
std::string mark_of(const Figure& figure);

/// Draws the figure to a file; an SVG ends with its mark. Problems: gnuplot is not installed, or what it said when it
/// failed.
Result<Done> draw(const Figure& figure, const std::filesystem::path& file);

} // namespace tumble::lesson
