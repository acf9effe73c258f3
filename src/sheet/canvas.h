#pragma once

#include "base/problem.h"

#include <filesystem>
#include <string>

namespace tumble::sheet {

/// What gnuplot draws on, by its size in print. As it stands: 800 x 500 pixels of a page on a screen, with letters of
/// 13.
struct Canvas {
    double width_mm = 800 * 25.4 / 96;
    double height_mm = 500 * 25.4 / 96;
    double dpi = 144; // of PNG files; the others know no pixels
    double font_pt = 9.75;
    bool titled = true; // false: its words stand in the text beside it

    /// An em of its letters, mm.
    [[nodiscard]] double em() const { return font_pt * 25.4 / 72; }
};

/// Problems: gnuplot is not asked for such files: .png, .svg and .pdf are known.
Result<Done> check_drawable(const std::filesystem::path& file);

/// Gnuplot's lines that open the file under the name by which it grows (sheet/gnuplot.h), by its ending, with DejaVu
/// Sans, words as they stand and lines of 0.26 mm for a width of 1.
std::string open_canvas(const Canvas& canvas, const std::filesystem::path& file);

/// About how wide the text is, ems: letters of DejaVu Sans are 0.6 wide on average, hardly any text has more.
double width_of(const std::string& text);

} // namespace tumble::sheet
