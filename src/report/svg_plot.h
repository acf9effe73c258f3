#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tumble::report {

/// Points, or a line through them; a number that is not finite interrupts the line.
struct Trace {
    std::string label; // in the legend; empty: not there
    std::vector<double> x, y;
    std::string color;
    bool line = false;
    bool dashed = false;
};

/// A horizontal band or line across the whole plot.
struct Level {
    double y = 0;
    std::string label;
    bool dashed = true;
};

struct Plot {
    std::string title, x_label, y_label;
    std::vector<Trace> traces;
    std::vector<Level> levels;
    std::optional<std::array<double, 2>> band;    // shaded, of y
    std::optional<std::array<double, 2>> y_range; // else from the traces
    int width = 460, height = 280;                // px
};

/// Okabe and Ito's colours, told apart also by those who see few.
std::string color_of(std::size_t index);

/// The plot as an SVG element for a page.
std::string svg_of(const Plot& plot);

/// 1, 2 or 5 times a power of ten, so that a range of this width gets about five.
double tick_step(double width);

/// A tick's number with the digits that its step needs, and a true minus sign.
std::string tick_word(double value, double step);

/// How plots look: the style sheet of a page that holds them.
extern const std::string plot_style;

/// Plots as a file of its own on white, so many in a row.
std::string svg_file(const std::vector<std::string>& plots, int columns);

/// Text as HTML and SVG take it.
std::string escaped(const std::string& text);

} // namespace tumble::report
