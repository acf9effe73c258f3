#pragma once

#include "render/camera.h"
#include "run/frame_sink.h"
#include "run/picture_files.h"
#include "run/replay.h"
#include "scene/scene.h"

#include <Eigen/Geometry>
#include <optional>

namespace tumble::run {

/// Draws every frame and hands it to PNG files, a video or both. Problems: those of the painter (unknown names, no
/// OpenGL), a folder or video that cannot be made. `fit` (m) will be in the picture; when it is empty the first frame.
/// `to_come`: the frames, where all of them are there already; a mean field of arrows is theirs then. `held`: the
/// camera, by a hand of a view.
Result<std::unique_ptr<FrameSink>> keep_pictures(const scene::Render& settings,
                                                 std::shared_ptr<const observe::FrameLayout> layout,
                                                 const PictureTargets& targets, const Eigen::AlignedBox3d& fit,
                                                 const Recording* to_come = nullptr,
                                                 const std::optional<render::Held>& held = {});

} // namespace tumble::run
