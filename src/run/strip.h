#pragma once

#include "render/strip_painter.h"
#include "run/redraw.h"

#include <filesystem>
#include <vector>

namespace tumble::run {

struct StripOptions {
    RedrawOptions redraw; // its targets do not count
    render::StripPlan plan;
    bool sections = false;        // through the last frame; else instants from the first to the last, evenly spaced
    std::vector<double> places{}; // m, of the sections, as many as the plan has cells; empty: evenly
    std::filesystem::path out;    // one picture where it ends in .png, .svg or .pdf; else a folder with a picture each
};

/// Several pictures of a run in one call. Instants: frames as evenly spaced as there are. Sections: cuts across the
/// camera's axis, n of them at 1, 2, ... n of n + 1 parts of the way from the centre nearest to the eye to the
/// farthest, or through settings.clip, or at places that are given; everything before a cut is left out.
/// Replayed::frames counts pictures. Problems: as for redraw; fewer frames than pictures, a section of a flat scene, a
/// place that no body reaches.
Result<Replayed> draw_strip(const std::filesystem::path& run, const StripOptions& options, const TellFrames& tell);

} // namespace tumble::run
