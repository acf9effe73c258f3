#pragma once

#include "run/frame_sink.h"

#include <filesystem>

/// Sinks that keep a frame as data.
namespace tumble::run {

/// frames/frame_000000.tumble and so on.
std::unique_ptr<FrameSink> keep_states(std::filesystem::path folder);

/// VTP files with their PVD series; makes the folder. Problems: it cannot be made.
Result<std::unique_ptr<FrameSink>> keep_for_paraview(std::filesystem::path folder);

/// All frames in one LIGGGHTS-style text file. Problems: it cannot be made.
Result<std::unique_ptr<FrameSink>> keep_as_text(const std::filesystem::path& file);

} // namespace tumble::run
