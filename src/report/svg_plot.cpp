#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <limits>

namespace tumble::report {

namespace {

constexpr int left = 62, right = 12, above_axes = 30, bottom = 44; // px around the axes
constexpr int legend_row = 14;                                     // px
constexpr double room = 0.04;                                      // of the range, beyond the traces
constexpr std::size_t most_points = 1500;                          // of a trace that are drawn

struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (!std::isfinite(value))
            return;
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
    void widen() {
        if (!(lo <= hi))
            lo = 0, hi = 1;
        const double width = hi > lo ? hi - lo : std::max(1e-12, std::abs(hi));
        lo -= room * width;
        hi += room * width;
    }
};

class Canvas {
public:
    explicit Canvas(const Plot& plot) : plot_(plot) {
        for (const Trace& trace : plot.traces) {
            for (const double x : trace.x)
                x_.take(x);
            for (const double y : trace.y)
                y_.take(y);
        }
        if (plot.band)
            for (const double y : *plot.band)
                y_.take(y);
        for (const Level& level : plot.levels)
            y_.take(level.y);
        x_.widen();
        y_.widen();
        if (plot.y_range)
            y_ = {(*plot.y_range)[0], (*plot.y_range)[1]};
        lay_out_legend();
    }

    std::string draw() {
        out_ = fmt::format("<svg viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
                           "xmlns=\"http://www.w3.org/2000/svg\">"
                           "<title>{2}</title><text class=\"h\" x=\"{3}\" y=\"16\">{2}</text>",
                           plot_.width, height(), escaped(plot_.title), left);
        if (plot_.band)
            out_ += fmt::format("<rect class=\"band\" x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\"/>", left,
                                py((*plot_.band)[1]), inner_width(), py((*plot_.band)[0]) - py((*plot_.band)[1]));
        axes();
        for (const Level& level : plot_.levels)
            out_ += fmt::format("<line class=\"level{}\" x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
                                "<text class=\"t\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
                                level.dashed ? " dash" : "", left, plot_.width - right, py(level.y), py(level.y),
                                plot_.width - right - 2, py(level.y) - 4, escaped(level.label));
        for (const Trace& trace : plot_.traces)
            draw(trace);
        legend();
        return out_ + "</svg>";
    }

private:
    /// A legend of several rows makes the picture higher and leaves the axes as they are.
    [[nodiscard]] int more() const { return legend_row * std::max(static_cast<int>(legend_.size()) - 1, 0); }
    [[nodiscard]] int height() const { return plot_.height + more(); }
    [[nodiscard]] int top() const { return above_axes + more(); }
    [[nodiscard]] int inner_width() const { return plot_.width - left - right; }
    [[nodiscard]] double px(double x) const { return left + (x - x_.lo) / (x_.hi - x_.lo) * inner_width(); }
    [[nodiscard]] double py(double y) const {
        return height() - bottom - (y - y_.lo) / (y_.hi - y_.lo) * (height() - top() - bottom);
    }
    [[nodiscard]] bool inside(double x, double y) const {
        return std::isfinite(x) && std::isfinite(y) && y >= y_.lo && y <= y_.hi;
    }

    void axes() {
        const int floor = height() - bottom;
        for (double step = tick_step(x_.hi - x_.lo), x = std::ceil(x_.lo / step) * step; x <= x_.hi; x += step)
            out_ += fmt::format(
                "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text class=\"t\" "
                "x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>",
                px(x), top(), floor, floor + 15, tick_word(x, step));
        for (double step = tick_step(y_.hi - y_.lo), y = std::ceil(y_.lo / step) * step; y <= y_.hi; y += step)
            out_ += fmt::format(
                "<line class=\"grid\" x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/><text class=\"t\" "
                "x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
                py(y), left, plot_.width - right, left - 5, py(y) + 4, tick_word(y, step));
        out_ +=
            fmt::format("<text class=\"a\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>"
                        "<text class=\"a\" transform=\"translate(13 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                        left + inner_width() / 2, height() - 8, escaped(plot_.x_label), (top() + floor) / 2,
                        escaped(plot_.y_label));
    }

    void draw(const Trace& trace) {
        if (trace.line) {
            std::string path;
            bool pen = false;
            for (std::size_t k = 0; k < trace.x.size(); ++k) {
                const bool seen = inside(trace.x[k], trace.y[k]);
                if (seen)
                    path += fmt::format("{}{:.1f} {:.1f}", pen ? "L" : "M", px(trace.x[k]), py(trace.y[k]));
                pen = seen;
            }
            out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\" "
                                "stroke-linejoin=\"round\"{}/>",
                                path, trace.color, trace.dashed ? " stroke-dasharray=\"5 3\"" : "");
            return;
        }
        out_ += fmt::format("<g fill=\"{}\">", trace.color);
        const std::size_t stride = 1 + trace.x.size() / most_points;
        for (std::size_t k = 0; k < trace.x.size(); k += stride)
            if (inside(trace.x[k], trace.y[k]))
                out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.5\"/>", px(trace.x[k]), py(trace.y[k]));
        out_ += "</g>";
    }

    /// What a trace looks like: a dot, a line, or a dashed one.
    static std::string mark_of(const Trace& trace, int x, int y) {
        if (!trace.line)
            return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{}\"/>", x + 7, y + 1, trace.color);
        return fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"2\"{}/>", x,
                           x + 13, y + 1, y + 1, trace.color, trace.dashed ? " stroke-dasharray=\"4 2\"" : "");
    }

    static int entry_width(const Trace& trace) {
        return 28 + static_cast<int>(6.6 * static_cast<double>(trace.label.size()));
    }

    /// The first row stands beside the title.
    void lay_out_legend() {
        int spare = inner_width() - 12 - static_cast<int>(7.8 * static_cast<double>(plot_.title.size()));
        for (const Trace& trace : plot_.traces) {
            if (trace.label.empty())
                continue;
            if (legend_.empty())
                legend_.emplace_back();
            if (entry_width(trace) > spare) {
                legend_.emplace_back();
                spare = inner_width();
            }
            legend_.back().push_back(&trace);
            spare -= entry_width(trace);
        }
    }

    void legend() {
        for (std::size_t row = 0; row < legend_.size(); ++row) {
            const int y = above_axes - 10 + legend_row * static_cast<int>(row);
            int x = plot_.width - right;
            for (auto trace = legend_[row].rbegin(); trace != legend_[row].rend(); ++trace) {
                x -= entry_width(**trace);
                out_ += mark_of(**trace, x, y) + fmt::format("<text class=\"t\" x=\"{}\" y=\"{}\">{}</text>", x + 16,
                                                             y + 5, escaped((*trace)->label));
            }
        }
    }

    const Plot& plot_;
    Range x_, y_;
    std::vector<std::vector<const Trace*>> legend_; // in rows that fit between the axes
    std::string out_;
};

} // namespace

const std::string plot_style = R"(
svg text{font-family:"DejaVu Sans",Verdana,sans-serif;fill:#222}.t{font-size:11px}.a{font-size:12px}
.h{font-size:13px;font-weight:bold}.grid{stroke:#e4e4e4}.level{stroke:#444}.dash{stroke-dasharray:4 3}
.band{fill:#dfe8ef}
)";

std::string tick_word(double value, double step) {
    constexpr double least = 1e-4, most = 1e6; // beyond them numbers with all their digits are hard to read
    const double size = std::abs(value);
    if (size < step / 1000)
        return "0";
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const std::string word =
        step >= least && size < most ? fmt::format("{:.{}f}", size, digits) : fmt::format("{:g}", size);
    return (value < 0 ? "\u2212" : "") + word;
}

/// As an svg_of() begins.
static std::array<int, 2> size_of(const std::string& plot) {
    std::array<int, 2> size{};
    if (std::sscanf(plot.c_str(), "<svg viewBox=\"0 0 %d %d\"", &size[0], &size[1]) != 2)
        size = {};
    return size;
}

std::string svg_file(const std::vector<std::string>& plots, int columns) {
    constexpr int gap = 20, margin = 8; // px
    std::string inside;
    int wide = 0, high = 0, row = 0; // px; of the row that is filled
    for (std::size_t k = 0; k < plots.size(); ++k) {
        const int column = static_cast<int>(k) % columns;
        const auto [width, height] = size_of(plots[k]);
        if (column == 0 && k > 0)
            high += row + gap, row = 0;
        const int x = column * (width + gap);
        inside += fmt::format("\n<svg x=\"{}\" y=\"{}\"{}", x, high, plots[k].substr(4));
        wide = std::max(wide, x + width);
        row = std::max(row, height);
    }
    high += row;
    return fmt::format("<svg viewBox=\"-{4} -{4} {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" "
                       "xmlns=\"http://www.w3.org/2000/svg\"><style>{2}</style>"
                       "<rect x=\"-{4}\" y=\"-{4}\" width=\"{0}\" height=\"{1}\" fill=\"white\"/>{3}\n</svg>\n",
                       wide + 2 * margin, high + 2 * margin, plot_style, inside, margin);
}

double tick_step(double width) {
    const double raw = width / 5;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    const double digit = raw / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

std::string color_of(std::size_t index) {
    constexpr std::array colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#444444"};
    return colors[index % colors.size()];
}

std::string svg_of(const Plot& plot) {
    return Canvas(plot).draw();
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text)
        safe += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return safe;
}

} // namespace tumble::report
