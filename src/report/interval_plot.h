#pragma once

#include <string>
#include <vector>

namespace tumble::report {

/// A value with the bar of its uncertainty.
struct Interval {
    std::string label; // in the legend
    std::string color;
    double value = 0;
    double half = 0; // of the bar, to either side
};

/// Intervals one below the other on one axis, for values of one kind; zero is marked where the axis holds it.
std::string svg_of(const std::string& title, const std::vector<Interval>& intervals, const std::string& axis);

} // namespace tumble::report
