#pragma once

#include "base/problem.h"
#include "sheet/canvas.h"

#include <filesystem>
#include <string>

namespace tumble::sheet {

/// In single quotes, in which gnuplot takes every letter as it stands.
std::string in_gnuplots_quotes(const std::string& text);

/// "overlap [mm]", as at all axes that gnuplot draws.
std::string axis_words(const std::string& label, const std::string& unit);

/// Okabe and Ito's colours, in turn: told apart also by those who see few.
std::string color_of(std::size_t index);

/// Has gnuplot draw growing_name(file) as the script says, puts `tail` behind what it drew, and gives it its name: the
/// file is whole, or as it was before, and a PNG knows its size on the canvas. Problems: those of check_writable;
/// gnuplot is not installed, for which `without` says how to do without it; what it said when it failed; a drawing that
/// is not whole, as on a full disk.
Result<Done> run_gnuplot(const std::string& script, const std::filesystem::path& file, const Canvas& canvas,
                         const std::string& without, const std::string& tail = "");

} // namespace tumble::sheet
