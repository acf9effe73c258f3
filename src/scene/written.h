#pragma once

#include "base/problem.h"
#include "scene/scene.h"

namespace tumble::scene {

/// The problem at the place where its key is written, or the innermost table around it; at the scene's file when
/// neither is. One that has a file already keeps it.
Problem placed(const Scene& scene, Problem problem);

/// A problem of that key, placed.
Problem problem_about(const Scene& scene, std::string key, std::string what, std::string fix);

} // namespace tumble::scene
