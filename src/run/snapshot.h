#pragma once

#include "observe/frame.h"
#include "scene/scene.h"
#include "sim3d/solver.h"

#include <memory>

/// A world turned into what observers may see.
namespace tumble::run {

std::shared_ptr<const observe::FrameLayout> layout_of(const scene::Scene& scene,
                                                      const std::vector<sim3d::BodyShape>& shapes);

/// The world now; `layout` is that of its scene.
observe::Frame snapshot(const sim3d::World& world, const std::shared_ptr<const observe::FrameLayout>& layout);

} // namespace tumble::run
