#pragma once

#include "base/problem.h"
#include "sheet/canvas.h"
#include "sheet/sheet.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Plots over each other that share one axis across.
namespace tumble::sheet {

/// How a line is drawn; a legend's entry where it has a label.
struct Ink {
    std::string label{};
    std::optional<std::size_t> color = 0; // counted through; none: black
    std::size_t dashes = 0;               // counted through; 0 is solid
};

/// A line through points; a y that is not finite interrupts it.
struct Trace {
    Ink ink{};
    std::vector<double> x{}, y{};
};

/// Its label stands over it on the left, the legend of its traces on the right.
struct Panel {
    Axis y{};
    std::vector<Trace> traces{};
};

struct Stack {
    std::string title{}; // empty: none
    Axis x{};
    std::vector<Ink> legend{}; // of all panels, above them
    std::vector<Panel> panels{};
};

/// As high as the panels are to be where nobody says how high all of it is, mm.
double usual_height(const Stack& stack, const Canvas& canvas);

/// What gnuplot is told. Problems: letters leave the panels no room on this canvas; how high it has to be.
Result<std::string> gnuplot_script(const Stack& stack, const std::filesystem::path& file, const Canvas& canvas);

/// Problems: those of the script and of gnuplot.
Result<Done> draw(const Stack& stack, const std::filesystem::path& file, const Canvas& canvas);

} // namespace tumble::sheet
