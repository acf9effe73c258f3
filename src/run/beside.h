#pragma once

#include "run/picture_files.h"
#include "run/replay.h"

#include <array>
#include <string>

namespace tumble::run {

struct BesideOptions {
    scene::Render settings;            // without a range: one that holds the colours of both runs
    std::array<std::string, 2> labels; // empty: the runs' titles, or their folders' names where the titles are the same
    PictureTargets targets;
    bool overwrite = false;
    ReplayOptions when;
};

/// Draws two runs side by side under one legend: for each frame of the first the second's of the same time. What one of
/// them lacks at its end or at its beginning is left out, with a warning. Problems: those of redraw for either run, no
/// frame at a common time.
Result<Replayed> draw_beside(const std::array<std::filesystem::path, 2>& runs, const BesideOptions& options,
                             const TellFrames& tell);

} // namespace tumble::run
