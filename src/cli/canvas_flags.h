#pragma once

#include "base/problem.h"
#include "sheet/canvas.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

/// How large the pictures are that gnuplot draws, on the command line.
namespace tumble::cli {

struct CanvasFlags {
    std::string size; // "85x60", mm; empty: not for print
    std::optional<double> dpi, font;
};

/// --size-mm, --dpi and --font-pt; `flags` must outlive the command line.
void add_canvas_flags(CLI::App& command, CanvasFlags& flags);

/// `usual`, or what the flags say of it. A picture of a given size is meant for print: as dense, with letters as large,
/// and without a title that says no more than the text beside it. Problems: no size, too many pixels.
Result<sheet::Canvas> canvas_of(const CanvasFlags& flags, const sheet::Canvas& usual = {});

/// Problem: more pixels along a side than a picture may have.
std::optional<Problem> refuse_pixels(const sheet::Canvas& canvas);

} // namespace tumble::cli
