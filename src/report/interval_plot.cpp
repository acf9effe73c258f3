#include "report/interval_plot.h"

#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::report {

std::string svg_of(const std::string& title, const std::vector<Interval>& intervals, const std::string& axis) {
    constexpr int row = 22, before = 80, behind = 16, above = 28, below = 40, width = 460;
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Interval& one : intervals) {
        lo = std::min(lo, one.value - one.half);
        hi = std::max(hi, one.value + one.half);
    }
    // Zero is shown where it is near: what is small against nothing is then seen as such.
    if (lo > 0 && lo < 2 * (hi - lo))
        lo = 0;
    if (hi < 0 && -hi < 2 * (hi - lo))
        hi = 0;
    const double room = hi > lo ? 0.05 * (hi - lo) : 1;
    lo -= room;
    hi += room;
    const auto px = [&](double value) { return before + (width - before - behind) * (value - lo) / (hi - lo); };
    const int floor = above + row * static_cast<int>(intervals.size());
    std::string out = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
                                  "xmlns=\"http://www.w3.org/2000/svg\"><title>{2}</title><text class=\"h\" x=\"8\" "
                                  "y=\"16\">{2}</text>",
                                  width, floor + below, escaped(title));
    for (double step = tick_step(hi - lo), x = std::ceil(lo / step) * step; x <= hi; x += step)
        out += fmt::format("<line class=\"{0}\" x1=\"{1:.1f}\" x2=\"{1:.1f}\" y1=\"{2}\" y2=\"{3}\"/><text class=\"t\" "
                           "x=\"{1:.1f}\" y=\"{4}\" text-anchor=\"middle\">{5}</text>",
                           std::abs(x) < step / 1000 ? "level" : "grid", px(x), above, floor, floor + 14,
                           tick_word(x, step));
    for (std::size_t k = 0; k < intervals.size(); ++k) {
        const Interval& one = intervals[k];
        const int y = above + row * static_cast<int>(k) + row / 2;
        out += fmt::format(
            "<text class=\"t\" x=\"{0}\" y=\"{1}\" text-anchor=\"end\">{2}</text><line x1=\"{3:.1f}\" x2=\"{4:.1f}\" "
            "y1=\"{5}\" y2=\"{5}\" stroke=\"{6}\" stroke-width=\"2\"/><circle cx=\"{7:.1f}\" cy=\"{5}\" r=\"4\" "
            "fill=\"{6}\"/>",
            before - 8, y + 4, escaped(one.label), px(one.value - one.half), px(one.value + one.half), y, one.color,
            px(one.value));
    }
    return out + fmt::format("<text class=\"a\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text></svg>",
                             (before + width - behind) / 2, floor + 33, escaped(axis));
}

} // namespace tumble::report
