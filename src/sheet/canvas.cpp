#include "sheet/canvas.h"

#include "base/ending.h"
#include "base/growing_file.h"
#include "sheet/gnuplot.h"
#include "sheet/show.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::sheet {

namespace {

constexpr double screen_dpi = 96; // what a pixel of an SVG file is: CSS, "absolute lengths"
constexpr double mm_per_inch = 25.4, pt_per_inch = 72;

// What gnuplot's cairo terminals draw for a letter of 1 pt, pt: they place letters by 96 pixels to an inch of 72
// points. Measured on capitals of PNG and PDF files of gnuplot 5.4.
constexpr double cairo_letter = screen_dpi / pt_per_inch;

/// Pixels of so many an inch, with lines that grow with them; `font` is what the terminal is told.
std::string in_pixels(const std::string& terminal, const Canvas& canvas, double dpi, double font) {
    const auto pixels = [&](double mm) { return static_cast<int>(std::lround(mm / mm_per_inch * dpi)); };
    const double scale = dpi / screen_dpi;
    return fmt::format("set terminal {} size {},{} font 'DejaVu Sans,{:.4g}'{} background 'white' noenhanced rounded\n",
                       terminal, pixels(canvas.width_mm), pixels(canvas.height_mm), font,
                       scale == 1 ? "" : fmt::format(" linewidth {0:.4g} pointscale {0:.4g}", scale));
}

} // namespace

Result<Done> check_drawable(const std::filesystem::path& file) {
    const std::string ending = ending_of(file);
    if (ending == ".png" || ending == ".svg" || ending == ".pdf")
        return Done{};
    return Problem{.file = file.string(),
                   .what = "plots are drawn as .png, .svg or .pdf",
                   .fix = "give the file one of these endings"};
}

// Rounded: a mitred corner sticks out of a sharp turn, and lines that only end there leave a notch.
std::string open_canvas(const Canvas& canvas, const std::filesystem::path& file) {
    std::string terminal;
    if (ending_of(file) == ".pdf")
        // Its lines of width 1 are half a point, and without a scale its letters half of what is asked for.
        terminal = fmt::format("set terminal pdfcairo size {:.6g}cm,{:.6g}cm font 'DejaVu Sans,{:.4g}' fontscale 1 "
                               "linewidth 1.5 background 'white' noenhanced rounded\n",
                               canvas.width_mm / 10, canvas.height_mm / 10, canvas.font_pt / cairo_letter);
    else if (ending_of(file) == ".svg")
        terminal = in_pixels("svg", canvas, screen_dpi, canvas.font_pt / pt_per_inch * screen_dpi);
    else
        terminal = in_pixels("pngcairo", canvas, canvas.dpi, canvas.font_pt / pt_per_inch * canvas.dpi / cairo_letter);
    return terminal + fmt::format("set output {}\n", in_gnuplots_quotes(growing_name(file).string()));
}

double width_of(const std::string& text) {
    return 0.6 * static_cast<double>(letters(text));
}

} // namespace tumble::sheet
