#pragma once

#include "render/camera.h"
#include "run/picture_files.h"
#include "run/replay.h"
#include "scene/scene.h"

namespace tumble::run {

struct RedrawOptions {
    scene::Render settings;           // without a range: one that holds the colours of all frames drawn
    std::string title;                // empty: the run's
    std::vector<double> wall_opacity; // one a wall of the scene; empty: the run's
    std::vector<std::string> traced;  // bodies that the run traces, whose columns the small plot takes too
    PictureTargets targets;
    bool overwrite = false;
    ReplayOptions when;
    std::optional<render::Held> held{}; // the camera, by a hand of a view
};

/// The run's layout with title and walls as the options have them.
std::shared_ptr<const observe::FrameLayout> restyled_layout(observe::FrameLayout layout, const RedrawOptions& options);

/// Draws the frames of a run again, without simulating. Problems: no run, nothing drawable, targets that exist already
/// or cannot be made, lines of a scene in space. What breaks later is Replayed::reason; a target that was begun in vain
/// is removed.
Result<Replayed> redraw(const std::filesystem::path& run, const RedrawOptions& options, const TellFrames& tell);

struct ExportOptions {
    std::filesystem::path paraview;  // folder; empty: none
    std::filesystem::path text_dump; // file; empty: none
    bool overwrite = false;
    ReplayOptions when;
};

/// Writes the frames of a run in forms that other tools read. Problems as for redraw.
Result<Replayed> export_run(const std::filesystem::path& run, const ExportOptions& options, const TellFrames& tell);

} // namespace tumble::run
