#pragma once

#include "base/stop.h"
#include "view/studio.h"

#include <functional>
#include <limits>
#include <string>

namespace tumble::view {

struct StillWishes {
    double from = 0; // s: frames from then on are seen, as trails and the plots of a simulation show
    double to = std::numeric_limits<double>::infinity(); // s: the last frame up to then is shown
    double step = 0;                                     // s, of a simulation
    double every = 0;                                    // s, between the frames of a simulation that are seen
    std::string tab{};                                   // of the panel, that is opened; empty: the first
    std::function<void(double)> reached{};               // s, told as frames are seen
};

/// What a browser would show at a time, without one. Problems: a time that the source has nothing of, a tab that is not
/// there, a source that cannot go on, a window that cannot be drawn, the stop.
Result<render::Picture> take_still(Studio& studio, const StillWishes& wishes, StopFlag stop);

} // namespace tumble::view
