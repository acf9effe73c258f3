#include "sheet/stack.h"

#include "sheet/gnuplot.h"
#include "sheet/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::sheet {

namespace {

// Ems.
constexpr double line_height = 1.45;
constexpr double below_axis = 1.5 + line_height; // numbers and the label of the axis across
constexpr double between = 0.7;                  // a panel and the words over the next
constexpr double edge = 0.5;
constexpr double sample = 3.5; // a legend's piece of line, and what keeps it from its words
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

/// Ems that the longest number at an axis of that range takes: gnuplot writes about four to ten of them.
double numbers_width(const Range& range) {
    const double step = std::pow(10, std::floor(std::log10((range.hi - range.lo) / 4)));
    const double digits_before = std::floor(std::log10(std::max({std::abs(range.lo), std::abs(range.hi), 1.0}))) + 1;
    const double digits_behind = std::max(0.0, -std::floor(std::log10(step) + 1e-9));
    const double signs = (range.lo < 0 ? 1 : 0) + (digits_behind > 0 ? 1 : 0);
    return 0.64 * (digits_before + digits_behind + signs);
}

/// A legend in columns.
struct Key {
    int columns = 1, rows = 0;
    bool fits = true;

    Key(const std::vector<const Ink*>& inks, double room) {
        double widest = 0;
        for (const Ink* ink : inks)
            widest = std::max(widest, width_of(ink->label) + sample + 1);
        const int count = static_cast<int>(inks.size());
        columns = count > 0 ? std::clamp(static_cast<int>(room / widest), 1, count) : 1;
        rows = (count + columns - 1) / columns;
        fits = columns * widest <= room;
    }
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
        for (const Panel& panel : stack.panels)
            left = std::max(left, numbers_width(range_of(panel)));
        left += 1.2;
        right = wide - 1.8;
        const double room = right - left;
        const auto columns = static_cast<std::size_t>(std::max(1.0, (wide - 2 * edge) / width_of("x")));
        for (std::string lines = stack.title.empty() ? "" : wrapped(stack.title, columns); !lines.empty();) {
            title.push_back(lines.substr(0, lines.find('\n')));
            lines.erase(0, title.back().size() + 1);
        }
        legend = Key(labelled(stack.legend), room);
        words = edge + line_height * static_cast<double>(title.size()) + line_height * legend.rows + below_axis + edge;
        for (const Panel& panel : stack.panels) {
            heads.emplace_back(panel, room);
            words += heads.back().height() + between;
        }
    }
};

std::string line_style(const Ink& ink) {
    return fmt::format("with lines lw 1.5 dt {} lc rgb '{}'", ink.dashes % 5 + 1,
                       ink.color ? color_of(*ink.color) : "#000000");
}

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

/// Written by the plot that comes next, and by no other.
std::string title_at(const Plan& plan, const Page& page, double top) {
    std::string script;
    for (std::size_t line = 0; line < plan.title.size(); ++line, top += line_height)
        script +=
            fmt::format("set label {} {} at screen {:.5g},{:.5g} left front\n", line + 2,
                        in_gnuplots_quotes(plan.title[line]), page.across(edge), 1 - page.up(top + 0.5 * line_height));
    return script;
}

std::string unset_title(const Plan& plan) {
    std::string script;
    for (std::size_t line = 0; line < plan.title.size(); ++line)
        script += fmt::format("unset label {}\n", line + 2);
    return script;
}

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

/// The legend's lines, in a plot of its own that shows nothing else.
std::string draw_legend(const std::vector<Ink>& inks, const Key& key, double left, double top) {
    std::string script = fmt::format("unset border\nunset tics\nset key at screen {:.5g},{:.5g} left top "
                                     "Left reverse horizontal maxcols {} samplen 2\nplot [0:1][0:1] ",
                                     left, top, key.columns);
    bool first = true;
    for (const Ink* ink : labelled(inks)) {
        script += fmt::format("{}NaN {} title {}", first ? "" : ", ", line_style(*ink), in_gnuplots_quotes(ink->label));
        first = false;
    }
    return script + "\nset border 3\nset tics nomirror out\n";
}

/// Words and curves of one panel; `top` is that of its words, ems from above.
std::string draw_panel(const Stack& stack, std::size_t index, const Plan& plan, const Page& page, double top,
                       double height) {
    const Panel& panel = stack.panels[index];
    const Head& head = plan.heads[index];
    const double ceiling = top + head.height(), floor = ceiling + height;
    const bool last = index + 1 == stack.panels.size();
    const auto y = [&](double ems) { return 1 - page.up(ems); };
    std::string script =
        fmt::format("set tmargin at screen {:.5g}\nset bmargin at screen {:.5g}\n", y(ceiling), y(floor));
    script += fmt::format("set label 1 {} at screen {:.5g},{:.5g} left front\n",
                          in_gnuplots_quotes(axis_words(panel.y.label, panel.y.unit)), page.across(plan.left),
                          y(top + 0.5 * line_height));
    const double key_top = head.beside ? top : top + line_height;
    script += head.key.rows > 0
                  ? fmt::format("set key at screen {:.5g},{:.5g} {} top Left reverse horizontal maxcols {} samplen 2\n",
                                page.across(head.beside ? plan.right : plan.left), y(key_top + 0.1),
                                head.beside ? "right" : "left", head.key.columns)
                  : "unset key\n";
    script += last ? fmt::format("set format x '%g'\nset xlabel {} offset 0,0.3\n",
                                 in_gnuplots_quotes(axis_words(stack.x.label, stack.x.unit)))
                   : "set format x ''\nunset xlabel\n";
    const Range range = range_of(panel);
    script += fmt::format("set yrange [{:.9g}:{:.9g}]\n", range.lo, range.hi);
    std::string plots;
    for (std::size_t k = 0; k < panel.traces.size(); ++k) {
        const Ink& ink = panel.traces[k].ink;
        plots += fmt::format("{}{} {} {}", k == 0 ? "plot " : ", ", name_of(index, k), line_style(ink),
                             ink.label.empty() ? "notitle" : "title " + in_gnuplots_quotes(ink.label));
    }
    return script + plots + "\n" + unset_title(plan);
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
    script += fmt::format("set multiplot\nset grid lc rgb '#cccccc'\nset border 3\nset tics nomirror out\n"
                          "set lmargin at screen {:.5g}\nset rmargin at screen {:.5g}\n",
                          page.across(plan.left), page.across(plan.right));
    double top = edge;
    script += title_at(plan, page, top);
    top += line_height * static_cast<double>(plan.title.size());
    if (plan.legend.rows > 0)
        script += draw_legend(stack.legend, plan.legend, page.across(plan.left), 1 - page.up(top)) + unset_title(plan);
    top += line_height * plan.legend.rows;
    script += fmt::format("set xrange [{:.9g}:{:.9g}]\n", across.lo, across.hi);
    for (std::size_t p = 0; p < stack.panels.size(); ++p) {
        script += draw_panel(stack, p, plan, page, top, height);
        top += plan.heads[p].height() + height + between;
    }
    return script + "unset multiplot\nunset output\n";
}

Result<Done> draw(const Stack& stack, const std::filesystem::path& file, const Canvas& canvas) {
    const auto script = gnuplot_script(stack, file, canvas);
    if (!script)
        return script.problems();
    return run_gnuplot(*script, file, "take the numbers from series.csv as they are");
}

} // namespace tumble::sheet
