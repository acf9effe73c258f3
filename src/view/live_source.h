#pragma once

#include "view/scene_text.h"
#include "view/source.h"

#include <functional>
#include <memory>

namespace tumble::view {

/// A simulation of the scene on a thread of its own, at rest until it is told to play. It takes the steps that
/// `tumble run` takes; looking on changes no bit of them. `news` is called from that thread whenever there is something
/// else to be seen. Problems: those of run::simulate.
Result<std::unique_ptr<Source>> open_live(const SceneText& text, const scene::Scene& scene, int threads,
                                          std::function<void()> news);

} // namespace tumble::view
