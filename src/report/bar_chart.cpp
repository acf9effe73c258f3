#include "report/bar_chart.h"

#include "report/svg_plot.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::report {

namespace {

constexpr int bar_row = 20, bar_before = 130, bar_behind = 300, chart_width = 940; // px
constexpr int mark_row = 14;                                                       // px, of words above the bars
constexpr double letter = 6.6;                                                     // px wide

double end_of_scale(const std::vector<Bar>& bars, const std::vector<Mark>& marks) {
    double most = 1e-12;
    for (const Bar& bar : bars)
        most = std::max(most, bar.value);
    for (const Mark& mark : marks)
        most = std::max(most, mark.value);
    return 1.05 * most;
}

double place_of(double value, double end) {
    return bar_before + (chart_width - bar_before - bar_behind) * value / end;
}

std::string ticks_of(double end, int above, int floor) {
    std::string out;
    const double step = tick_step(end);
    for (int k = 0; k * step <= end; ++k)
        out +=
            fmt::format("<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text class=\"t\" "
                        "x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
                        place_of(k * step, end), above, floor, floor + 14, tick_word(k * step, step));
    return out;
}

std::string bar_of(const Bar& bar, int y, double end) {
    return fmt::format(
        "<text class=\"t\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text><rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" "
        "height=\"12\" fill=\"{}\"/><text class=\"t\" x=\"{}\" y=\"{}\">{}</text>",
        bar_before - 8, y + 10, escaped(bar.label), bar_before, y, std::max(0.5, place_of(bar.value, end) - bar_before),
        bar.color, chart_width - bar_behind + 12, y + 10, escaped(bar.word));
}

/// From left to right; a word that would touch the one before it goes up by a row.
std::string marks_of(std::vector<Mark> marks, double end, int above, int floor) {
    std::sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.value < b.value; });
    std::string out;
    double taken = 0; // px, by words of the lower row
    for (const Mark& mark : marks) {
        const double x = place_of(mark.value, end), half = letter * static_cast<double>(mark.label.size()) / 2;
        const bool up = x - half < taken + letter;
        if (!up)
            taken = x + half;
        const int y = above - 5 - (up ? mark_row : 0);
        out += fmt::format("<line class=\"level dash\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text "
                           "class=\"t\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
                           x, y + 3, floor, y, escaped(mark.label));
    }
    return out;
}

} // namespace

std::string svg_of(const std::vector<Bar>& bars, const std::vector<Mark>& marks, const std::string& axis) {
    constexpr int above = 2 * mark_row + 6, below = 40; // px
    const double end = end_of_scale(bars, marks);
    const int floor = above + bar_row * static_cast<int>(bars.size());
    std::string out = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
                                  "xmlns=\"http://www.w3.org/2000/svg\"><title>{2}</title>",
                                  chart_width, floor + below, escaped(axis));
    out += ticks_of(end, above, floor);
    for (std::size_t k = 0; k < bars.size(); ++k)
        out += bar_of(bars[k], above + 4 + bar_row * static_cast<int>(k), end);
    out += fmt::format("<line class=\"level\" x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\"/>", bar_before, above, floor);
    return out + marks_of(marks, end, above, floor) +
           fmt::format("<text class=\"a\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text></svg>",
                       (bar_before + chart_width - bar_behind) / 2, floor + 32, escaped(axis));
}

} // namespace tumble::report
