#pragma once

#include "render/drawing_file.h"
#include "render/paper.h"
#include "run/frame_sink.h"
#include "run/replay.h"
#include "scene/scene.h"

namespace tumble::run {

/// Draws the recording's last frame as lines into an SVG or PDF file; the frames before it count for trails and mean
/// fields. Problems: those of the drafter, with the run as their file; a folder that cannot be made.
Result<std::unique_ptr<FrameSink>> keep_drawing(const scene::Render& settings, const Recording& recording,
                                                const std::filesystem::path& file);

/// As an SVG or PDF file; makes the folder where it is missing. Problems: what the system says.
Result<Done> save(const render::Drawing& drawing, const std::filesystem::path& file);

/// A picture or drawing into a file, unless numbers or units have no room on it in print.
template <class Work>
Result<Done> save_readable(Work work, const scene::Render& settings, const std::filesystem::path& file) {
    if (auto room = render::check_room(work.crowded, settings); !room)
        return room;
    return save(std::move(work), file);
}

/// Problems that name neither a file nor a key are of this run.
Problems of_run(Problems problems, const std::filesystem::path& run);

} // namespace tumble::run
