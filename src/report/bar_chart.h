#pragma once

#include <string>
#include <vector>

namespace tumble::report {

/// A horizontal bar with a label before it and words behind the chart.
struct Bar {
    std::string label, word, color;
    double value = 0;
};

/// A limit: a dashed line across all bars, with a word above.
struct Mark {
    double value = 0;
    std::string label;
};

/// Bars from 0 on, in the order given, over a scale with ticks that all of them share. Words of marks that lie near
/// each other stand in two rows.
std::string svg_of(const std::vector<Bar>& bars, const std::vector<Mark>& marks, const std::string& axis);

} // namespace tumble::report
