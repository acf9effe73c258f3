#pragma once

#include "observe/frame.h"
#include "scene/scene.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace tumble::render {

/// What settings show of a scene, m; nothing where they show all of it, and in two dimensions.
std::optional<Eigen::AlignedBox3d> clip_of(const scene::Render& settings, const observe::FrameLayout& layout);

/// Where a plane across an axis (0 to 2) cuts, m, and which side of it is shown: "z ≤ 27 mm", or "z ≥ 27 mm" of
/// what lies above it.
std::string plane_words(int axis, double place, bool above);

/// The same with what the plane does: "cut: z ≤ 27 mm" where it cuts bodies open, "shown: z ≤ 27 mm" where those whose
/// centres lie beyond are left out.
std::string section_words(int axis, double place, bool above, bool cuts);

/// What a clip shows, section_words for each face that cuts through the scene's domain.
std::vector<std::string> clip_words(const Eigen::AlignedBox3d& clip, bool cuts, const observe::FrameLayout& layout);

} // namespace tumble::render
