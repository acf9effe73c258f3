#pragma once

#include <string>
#include <vector>

namespace tumble::render {

/// A measure over time for the small plot. Points after the frame's time only widen the axes, so that a finished run is
/// redrawn with axes that stand still; of one that still goes on the time axis does.
struct PlotLine {
    std::string label;
    std::string unit;           // SI
    std::vector<double> times;  // s, rising
    std::vector<double> values; // in unit, as many as times; what is not finite leaves a gap
    double until = 0;           // s, where the time axis ends, or later where there are later points
};

} // namespace tumble::render
