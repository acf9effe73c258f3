#pragma once

#include "base/problem.h"
#include "scene/motion.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// A measured displacement: CSV with the head "t_s,x_m,y_m,z_m", time starting at 0 and rising, two rows or more.
/// '#' begins a comment. The activity of the table is left at its default. Problems at line and column; at most 20.
/// In two dimensions the head is "t_s,x_m,y_m".
Result<MotionTable> parse_motion_table(std::string_view text, const std::string& source, int dimension = 3);
Result<MotionTable> read_motion_table(const std::filesystem::path& file, int dimension = 3);

/// What keeps these times from being those of a motion, and at which row (from 0); empty when nothing does.
struct RowFault {
    std::size_t row = 0;
    std::string what;
};
std::vector<RowFault> time_faults(const std::vector<double>& time);

/// Harmonics, one a line: CSV with the head "axis,amplitude,period" (m, s) or "axis,amplitude,period,phase_deg".
/// Activity as above.
Result<std::vector<Harmonic>> parse_harmonics(std::string_view text, const std::string& source);
Result<std::vector<Harmonic>> read_harmonics(const std::filesystem::path& file);

} // namespace tumble::scene
