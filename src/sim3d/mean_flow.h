#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// Fits the field to the bodies' velocities (least squares, in slot order) and looks where the bodies are. The fit's
/// quality decides how seldom lists are made, never what is in them: the odometers hold for any field.
MeanFlow fit_mean_flow(const World& world);

/// The farthest that any point of the wall near the bodies went beside the mean flow while the wall moved from one pose
/// to the next, m.
double way_beside(const MeanFlow& flow, const scene::WallPose& from, const scene::WallPose& to, double dt);
/// The same of a wall that stays where it is.
double way_past_rest(const MeanFlow& flow, double dt);

} // namespace tumble::sim3d
