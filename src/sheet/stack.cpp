#include "sheet/stack.h"

#include "sheet/gnuplot.h"
#include "sheet/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace tumble::sheet {

namespace {

// Ems.
constexpr double line_height = 1.45;
constexpr double numbers_across = 1.9; // below the axis
constexpr double between = 0.7;        // a panel and the words over the next
constexpr double edge = 0.5;
constexpr double sample = 2.2, gap = 0.5; // a legend's piece of line, and what keeps it from its words
constexpr double apart = 1.6;             // entries of a legend
constexpr double tick_room = 2.0;         // height that a number at an upright axis wants
constexpr int most_ticks = 6;
constexpr double least_panel = 4, usual_panel = 8;
constexpr double rim = 0.05;              // of the range, between a curve and its panel's ends
constexpr std::size_t most_columns = 800; // of a line: more points than twice that cannot be told apart in print

/// Parts of the whole canvas, as gnuplot's screen coordinates: from the left and from below.
class Page {
public:
    explicit Page(const Canvas& canvas)
        : em_across_(canvas.em() / canvas.width_mm), em_up_(canvas.em() / canvas.height_mm) {}

    [[nodiscard]] double across(double ems) const { return ems * em_across_; }
    [[nodiscard]] double up(double ems) const { return ems * em_up_; }
    [[nodiscard]] double wide() const { return 1 / em_across_; } // ems
    [[nodiscard]] double high() const { return 1 / em_up_; }

private:
    double em_across_, em_up_;
};

struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (std::isfinite(value)) {
            lo = std::min(lo, value);
            hi = std::max(hi, value);
        }
    }
    [[nodiscard]] Range widened() const {
        if (!(lo <= hi))
            return {0, 1};
        const double width = hi - lo, least = 1e-9 * std::max(std::abs(lo), std::abs(hi));
        const double more = width > least ? rim * width : std::max(0.5 * std::abs(hi), 0.5);
        return {lo - more, hi + more};
    }
};

Range range_of(const Panel& panel) {
    Range range;
    for (const Trace& trace : panel.traces)
        for (const double y : trace.y)
            range.take(y);
    return range.widened();
}

/// The finest round step of which a range holds no more than `most` multiples, and two at least.
double step_of(const Range& range, int most) {
    const auto count = [&](double step) { return std::floor(range.hi / step) - std::ceil(range.lo / step) + 1; };
    double step = std::pow(10, std::floor(std::log10(range.hi - range.lo)) + 1);
    for (double power = step / 10; true; power /= 10)
        for (const double finer : {5 * power, 2 * power, power}) {
            if (count(step) >= 2 && count(finer) > most)
                return step;
            step = finer;
        }
}

int digits_behind(double step) {
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
}

/// Ems that the longest number at an axis of that step takes.
double numbers_width(const Range& range, double step) {
    const double digits_before = std::floor(std::log10(std::max({std::abs(range.lo), std::abs(range.hi), 1.0}))) + 1;
    const int behind = digits_behind(step), signs = (range.lo < 0 ? 1 : 0) + (behind > 0 ? 1 : 0);
    return 0.64 * (digits_before + behind + signs);
}

/// A legend in columns.
struct Key {
    int columns = 1, rows = 0;
    double widest = 0; // ems, of a column
    bool fits = true;

    Key(const std::vector<const Ink*>& inks, double room) {
        for (const Ink* ink : inks)
            widest = std::max(widest, sample + gap + width_of(ink->label) + apart);
        const int count = static_cast<int>(inks.size());
        columns = count > 0 ? std::clamp(static_cast<int>(room / widest), 1, count) : 1;
        rows = (count + columns - 1) / columns;
        fits = columns * widest <= room;
    }
    [[nodiscard]] double width() const { return columns * widest - apart; }
};

std::vector<const Ink*> labelled(const std::vector<Ink>& inks) {
    std::vector<const Ink*> found;
    for (const Ink& ink : inks)
        if (!ink.label.empty())
            found.push_back(&ink);
    return found;
}

std::vector<const Ink*> labelled(const Panel& panel) {
    std::vector<const Ink*> found;
    for (const Trace& trace : panel.traces)
        if (!trace.ink.label.empty())
            found.push_back(&trace.ink);
    return found;
}

/// Where a panel's words go: the legend beside the label where one row of it fits there, else below it.
struct Head {
    Key key;
    bool beside = false;

    Head(const Panel& panel, double room)
        : key(labelled(panel), room - width_of(axis_words(panel.y.label, panel.y.unit)) - 2) {
        beside = key.rows == 0 || (key.rows == 1 && key.fits);
        if (!beside)
            key = Key(labelled(panel), room);
    }
    [[nodiscard]] double height() const { return line_height * (beside ? 1 : 1 + key.rows); }
};

/// All of it in ems, from the left and from above.
struct Plan {
    double left = 0, right = 0; // of the panels
    std::vector<std::string> title;
    std::vector<Head> heads;
    Key legend{{}, 1};
    double words = 0; // of the height that is no panel's

    Plan(const Stack& stack, double wide) {
        for (const Panel& panel : stack.panels) {
            const Range range = range_of(panel);
            left = std::max(left, numbers_width(range, step_of(range, most_ticks)));
        }
        left += 1.4;
        right = wide - 1.8;
        const double room = right - left;
        const auto columns = static_cast<std::size_t>(std::max(1.0, (wide - 2 * edge) / width_of("x")));
        for (std::string lines = stack.title.empty() ? "" : wrapped(stack.title, columns); !lines.empty();) {
            title.push_back(lines.substr(0, lines.find('\n')));
            lines.erase(0, title.back().size() + 1);
        }
        legend = Key(labelled(stack.legend), room);
        words = edge + line_height * static_cast<double>(title.size()) + line_height * legend.rows + numbers_across +
                line_height + edge;
        for (const Panel& panel : stack.panels) {
            heads.emplace_back(panel, room);
            words += heads.back().height() + between;
        }
    }
};

/// Of the points in one column of the picture the first, lowest, highest and last.
std::string thinned(const Trace& trace, const Range& across) {
    std::string block;
    const auto column_of = [&](std::size_t k) {
        return std::floor((trace.x[k] - across.lo) / (across.hi - across.lo) * most_columns);
    };
    const std::size_t count = std::min(trace.x.size(), trace.y.size());
    for (std::size_t begin = 0; begin < count;) {
        if (!std::isfinite(trace.x[begin]) || !std::isfinite(trace.y[begin])) {
            block += "\n"; // interrupts the line
            ++begin;
            continue;
        }
        std::size_t end = begin + 1;
        while (end < count && std::isfinite(trace.x[end]) && std::isfinite(trace.y[end]) &&
               column_of(end) == column_of(begin))
            ++end;
        const auto from = trace.y.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto [low, high] = std::minmax_element(from, trace.y.begin() + static_cast<std::ptrdiff_t>(end));
        std::array<std::size_t, 4> kept{begin, static_cast<std::size_t>(low - trace.y.begin()),
                                        static_cast<std::size_t>(high - trace.y.begin()), end - 1};
        std::sort(kept.begin(), kept.end());
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (k == 0 || kept[k] != kept[k - 1])
                block += fmt::format("{:.9g} {:.9g}\n", trace.x[kept[k]], trace.y[kept[k]]);
        begin = end;
    }
    return block;
}

std::string name_of(std::size_t panel, std::size_t trace) {
    return fmt::format("$line{}_{}", panel, trace);
}

/// Words and pieces of line that gnuplot draws with the next plot, and with no other.
class Words {
public:
    explicit Words(const Page& page) : page_(page) {}

    /// Left end (or where `align` says) and middle of the line, ems from the left and from above.
    void text(const std::string& words, double left, double middle, const char* align = "left") {
        script_ += fmt::format("set label {} {} at screen {:.5g},{:.5g} {} front\n", ++labels_,
                               in_gnuplots_quotes(words), page_.across(left), 1 - page_.up(middle), align);
    }
    void legend(const std::vector<const Ink*>& inks, const Key& key, double left, double top) {
        const auto columns = static_cast<std::size_t>(key.columns);
        for (std::size_t k = 0; k < inks.size(); ++k) {
            const double x = left + key.widest * static_cast<double>(k % columns);
            const double y = top + line_height * (static_cast<double>(k / columns) + 0.5);
            script_ += fmt::format("set arrow {} from screen {:.5g},{:.5g} to screen {:.5g},{:.5g} nohead front {}\n",
                                   ++arrows_, page_.across(x), 1 - page_.up(y), page_.across(x + sample),
                                   1 - page_.up(y), pen(*inks[k]));
            text(inks[k]->label, x + sample + gap, y);
        }
    }
    /// To stand before the plot.
    std::string take() {
        labels_ = arrows_ = 0;
        return "unset label\nunset arrow\n" + std::exchange(script_, {});
    }

    static std::string pen(const Ink& ink) {
        return fmt::format("lw 1.5 dt {} lc rgb '{}'", ink.dashes % dash_patterns + 1,
                           ink.color ? color_of(*ink.color) : "#000000");
    }

private:
    const Page& page_;
    std::string script_;
    int labels_ = 0, arrows_ = 0;
};

Problem no_room(const Stack& stack, const Plan& plan, const std::filesystem::path& file, const Canvas& canvas) {
    const auto count = static_cast<double>(stack.panels.size());
    const double high = std::ceil(canvas.em() * (plan.words + least_panel * count));
    return {.file = file.string(),
            .what = fmt::format(
                "{:g} x {:g} mm leave no room for {} with letters of {:g} pt", canvas.width_mm, canvas.height_mm,
                stack.panels.size() == 1 ? "a plot" : fmt::format("{} plots", stack.panels.size()), canvas.font_pt),
            .fix = canvas.height_mm < high
                       ? fmt::format("make it {:.0f} mm high, the letters smaller or the measures fewer", high)
                       : "make it wider, or the letters smaller"};
}

Range range_across(const Stack& stack) {
    if (stack.x.range)
        return {(*stack.x.range)[0], (*stack.x.range)[1]};
    Range across;
    for (const Panel& panel : stack.panels)
        for (const Trace& trace : panel.traces)
            for (const double x : trace.x)
                across.take(x);
    return across.lo < across.hi ? across : across.widened();
}

/// Title, legend and the name of the axis across.
void write_around(Words& words, const Stack& stack, const Plan& plan, const Page& page) {
    double top = edge;
    for (const std::string& line : plan.title) {
        words.text(line, edge, top + 0.5 * line_height);
        top += line_height;
    }
    words.legend(labelled(stack.legend), plan.legend, plan.left, top);
    words.text(axis_words(stack.x.label, stack.x.unit), 0.5 * (plan.left + plan.right),
               page.high() - edge - 0.5 * line_height, "center");
}

/// Axes, grid and margins that all panels share.
std::string draw_axes(const Plan& plan, const Page& page, const Range& across) {
    int most = 10;
    while (most > 2 && most * (numbers_width(across, step_of(across, most)) + 1.2) > plan.right - plan.left)
        --most;
    return fmt::format("unset key\nset border 3\nset xtics {:.9g} nomirror out scale 0.5\n"
                       "set ytics nomirror out scale 0.5\nset grid lc rgb '#cccccc'\n"
                       "set lmargin at screen {:.5g}\nset rmargin at screen {:.5g}\nset xrange [{:.9g}:{:.9g}]\n",
                       step_of(across, most), page.across(plan.left), page.across(plan.right), across.lo, across.hi);
}

/// Words and curves of a panel whose words begin at `top` and whose axes are `height` high, ems.
std::string draw_panel(const Stack& stack, std::size_t index, Words& words, const Plan& plan, const Page& page,
                       double top, double height) {
    const Panel& panel = stack.panels[index];
    const Head& head = plan.heads[index];
    words.text(axis_words(panel.y.label, panel.y.unit), plan.left, top + 0.5 * line_height);
    words.legend(labelled(panel), head.key, head.beside ? plan.right - head.key.width() : plan.left,
                 head.beside ? top : top + line_height);
    const Range range = range_of(panel);
    const double ceiling = top + head.height();
    const double step = step_of(range, std::clamp(static_cast<int>(height / tick_room), 2, most_ticks));
    std::string script = words.take();
    script +=
        fmt::format("set tmargin at screen {:.5g}\nset bmargin at screen {:.5g}\nset yrange [{:.9g}:{:.9g}]\n"
                    "set ytics {:.9g}\nset format y '%.{}f'\n",
                    1 - page.up(ceiling), 1 - page.up(ceiling + height), range.lo, range.hi, step, digits_behind(step));
    if (index + 1 == stack.panels.size()) // numbers across at the lowest
        script += "set format x '%g'\n";
    std::string plots;
    for (std::size_t k = 0; k < panel.traces.size(); ++k)
        plots += fmt::format("{}{} with lines {}", k == 0 ? "plot " : ", ", name_of(index, k),
                             Words::pen(panel.traces[k].ink));
    return script + plots + "\n";
}

} // namespace

double usual_height(const Stack& stack, const Canvas& canvas) {
    const Plan plan(stack, Page(canvas).wide());
    return canvas.em() * (plan.words + usual_panel * static_cast<double>(stack.panels.size()));
}

Result<std::string> gnuplot_script(const Stack& stack, const std::filesystem::path& file, const Canvas& canvas) {
    const Page page(canvas);
    const Plan plan(stack, page.wide());
    const auto count = static_cast<double>(stack.panels.size());
    const double height = (page.high() - plan.words) / count;
    if (!(height >= least_panel) || plan.right - plan.left < 2 * least_panel)
        return no_room(stack, plan, file, canvas);
    const Range across = range_across(stack);
    std::string script = open_canvas(canvas, file) + "set encoding utf8\nset minussign\n";
    for (std::size_t p = 0; p < stack.panels.size(); ++p)
        for (std::size_t k = 0; k < stack.panels[p].traces.size(); ++k)
            script += name_of(p, k) + " << END\n" + thinned(stack.panels[p].traces[k], across) + "END\n";
    script += "set multiplot\nset format x ''\n" + draw_axes(plan, page, across);
    Words words(page);
    write_around(words, stack, plan, page);
    double top = edge + line_height * (static_cast<double>(plan.title.size()) + plan.legend.rows);
    for (std::size_t p = 0; p < stack.panels.size(); ++p) {
        script += draw_panel(stack, p, words, plan, page, top, height);
        top += plan.heads[p].height() + height + between;
    }
    return script + "unset multiplot\nunset output\n";
}

Result<Done> draw(const Stack& stack, const std::filesystem::path& file, const Canvas& canvas) {
    const auto script = gnuplot_script(stack, file, canvas);
    if (!script)
        return script.problems();
    return run_gnuplot(*script, file, canvas, "take the numbers from series.csv as they are");
}

} // namespace tumble::sheet
