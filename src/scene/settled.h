#pragma once

#include "scene/scene.h"

namespace tumble::scene {

/// From one instant to another, s.
struct Stretch {
    double from = 0, until = 0;
};

/// The time in which all moves that moves; from the last body put in where nothing does.
Stretch driven(const Scene& scene);

/// Of the slowest vibration of a wall, to and fro or rocking: its period, and when it passes through its middle on the
/// way to the positive side, s. A period of 0: none vibrates.
struct Vibration {
    double period = 0, from = 0;
};
Vibration slowest_vibration(const Scene& scene);

/// When a bed is worth averaging: the second half of the time in which it is driven, by when the bulk has
/// forgotten how it lay. In whole pairs of the slowest period where walls
/// vibrate, for a shaken bed may answer every second shake alike.
Stretch settled(const Scene& scene);

} // namespace tumble::scene
