#pragma once

#include <string>

namespace tumble::scene {

/// Markdown of every table and key a scene may have, from the one list in keys.h: docs/scene_reference.md.
std::string scene_reference();

} // namespace tumble::scene
