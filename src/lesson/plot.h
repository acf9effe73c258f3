#pragma once

#include "base/problem.h"
#include "lesson/walk.h"

#include <filesystem>
#include <string>

/// Figures as files, drawn by gnuplot.
namespace tumble::lesson {

/// What gnuplot is told to draw the figure to a file; .png and .svg are known.
std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file);

/// Draws the figure to a file. Problems: gnuplot is not installed, or what it said when it failed.
Result<Done> draw(const Figure& figure, const std::filesystem::path& file);

} // namespace tumble::lesson
