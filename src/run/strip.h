#pragma once

#include "render/strip_painter.h"
#include "run/redraw.h"

namespace tumble::run {

struct StripOptions {
    RedrawOptions redraw; // its targets do not count
    render::StripPlan plan;
    bool sections = false;     // through the last frame; else instants from the first to the last, evenly spaced
    std::filesystem::path out; // one picture where it ends in .png, .svg or .pdf; else a folder with a picture each
};

/// Several pictures of a run in one call. Instants: frames as evenly spaced as there are. Sections: cuts across the
/// camera's axis, evenly through the bodies from the one nearest to the eye on, or through settings.clip; everything
/// before a cut is left out. Replayed::frames counts pictures. Problems: as for redraw; fewer frames than pictures, a
/// section of a flat scene.
Result<Replayed> draw_strip(const std::filesystem::path& run, const StripOptions& options, const TellFrames& tell);

} // namespace tumble::run
