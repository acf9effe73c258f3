#pragma once

#include "scene/scene.h"

#include <optional>

namespace tumble::view {

struct CarriedOn {
    scene::Scene scene;         // that goes on from here
    std::optional<double> next; // s, when more of what is wanted can be taken up; nothing: all has been
};

/// The scene that a run takes up at `now` (s) when its scene shall become `wanted`, which has the same walls with the
/// same motions in the same order. No wall jumps: a harmonic or a rocking goes on with a new frequency from the angle
/// of its swing, and changes amplitude and phase where a period ends and the wall is where it began; a rotation turns
/// on from the angle that it has; a table goes over to its new rows by degrees. Everything else changes at once.
CarriedOn carry_on(const scene::Scene& running, const scene::Scene& wanted, double now);

} // namespace tumble::view
