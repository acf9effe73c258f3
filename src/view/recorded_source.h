#pragma once

#include "scene/scene.h"
#include "view/source.h"

namespace tumble::view {

/// The frames of a run that is over, with the title and the opacities of walls that the scene has now. It plays as fast
/// as its video would, until it is told another speed; `news` is called when a video is done. Problems: those of
/// run::open_recording.
Result<std::unique_ptr<Source>> open_recorded(const std::filesystem::path& run, const scene::Scene& scene,
                                              std::function<void()> news);

} // namespace tumble::view
