#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::scene {

/// Half of a trough's cross-section, from the lowest point outwards: an arc, and where the rim lies above the end of
/// the arc a straight side. A lower rim cuts the arc.
struct TroughProfile {
    double centre;   // m, height of the arc's axis
    double arc_end;  // rad from straight down
    double arc_top;  // m, height of the arc's end
    double arc_half; // m, how far from the middle that end is
    double rim_half; // m, how far from the middle the rim is
    bool side;       // there is one
};

inline TroughProfile profile_of(const TroughShape& shape) {
    TroughProfile profile{};
    profile.centre = shape.floor + shape.radius;
    const double tangent = std::numbers::pi / 2 - shape.flare;
    const double cut = std::acos(std::clamp((profile.centre - shape.rim) / shape.radius, -1.0, 1.0));
    profile.side = tangent < cut;
    profile.arc_end = std::min(tangent, cut);
    profile.arc_top = profile.centre - shape.radius * std::cos(profile.arc_end);
    profile.arc_half = shape.radius * std::sin(profile.arc_end);
    profile.rim_half = profile.arc_half + (profile.side ? (shape.rim - profile.arc_top) * std::tan(shape.flare) : 0.0);
    return profile;
}

} // namespace tumble::scene
