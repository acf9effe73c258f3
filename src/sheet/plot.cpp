#include "sheet/plot.h"

#include "base/ending.h"
#include "base/hash.h"
#include "base/make_folder.h"
#include "sheet/gnuplot.h"
#include "sheet/show.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::sheet {

namespace {

std::string axis(char letter, const Axis& axis) {
    std::string script = fmt::format("set {}label {}\n", letter, in_gnuplots_quotes(axis_words(axis.label, axis.unit)));
    if (axis.logarithmic)
        script += fmt::format("set logscale {}\n", letter);
    if (axis.range)
        script += fmt::format("set {}range [{}:{}]\n", letter, (*axis.range)[0], (*axis.range)[1]);
    return script;
}

std::string style(const Curve& curve, std::size_t index) {
    const std::string color = color_of(curve.color.value_or(index));
    if (curve.style == Style::points && !curve.spread.empty())
        return fmt::format("with yerrorbars pt 7 ps 1 lw 1.5 lc rgb '{}'", color);
    if (curve.style == Style::points)
        return fmt::format("with points pt 7 ps 1 lc rgb '{}'", color);
    if (curve.style == Style::bars)
        return fmt::format("with impulses lw 3 lc rgb '{}'", color);
    return fmt::format("with lines lw 2 {} lc rgb '{}'", curve.style == Style::dashes ? "dt 2" : "dt 1", color);
}

std::string data_of(const Curve& curve, std::size_t index) {
    std::string block = fmt::format("$curve{} << END\n", index);
    for (std::size_t k = 0; k < curve.x.size(); ++k)
        block += fmt::format("{:.9g} {:.9g}{}\n", curve.x[k], curve.y[k],
                             curve.spread.empty() ? "" : fmt::format(" {:.9g}", curve.spread[k]));
    return block + "END\n";
}

/// Numbers in parts of the largest. There are 997 of them, a prime: few numbers that matter lie just between two.
void add_rounded(Hash64& hash, const std::vector<double>& numbers) {
    double size = 0;
    for (const double number : numbers)
        size = std::max(size, std::abs(number));
    for (const double number : numbers)
        hash.add(std::lround(size > 0 ? 997 * number / size : 0.0));
    hash.add(fmt::format("{:.3g}", size));
}

/// How far the curves reach along one axis, from lowest to highest.
double span_of(const Figure& figure, const Axis& axis, std::vector<double> Curve::*numbers) {
    if (axis.range)
        return (*axis.range)[1] - (*axis.range)[0];
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const Curve& curve : figure.curves)
        for (const double number : curve.*numbers) {
            lo = std::min(lo, number);
            hi = std::max(hi, number);
        }
    return hi - lo;
}

/// Names above the plot, slanted so that neighbours leave each other room, and a margin for what leans beyond its end.
std::string names_of(const Figure& figure) {
    if (figure.places.empty())
        return "";
    constexpr double lean = 0.5; // cosine of 60 degrees
    constexpr double wide = 85;  // letters that a plot of this size is wide, about
    const double span = span_of(figure, figure.x, &Curve::x);
    double last = figure.places.front().first;
    for (const Curve& curve : figure.curves)
        for (const double x : curve.x)
            last = std::max(last, x);
    std::string ticks;
    double beyond = 2; // letters
    for (const auto& [x, name] : figure.places) {
        ticks += fmt::format("{}{} {:.9g}", ticks.empty() ? "" : ", ", in_gnuplots_quotes(name), x);
        beyond = std::max(beyond, lean * static_cast<double>(letters(name)) - wide * (last - x) / span);
    }
    return fmt::format("set link x2\nset xtics nomirror\nset x2tics ({}) rotate by 60 left\nset rmargin {:.0f}\n",
                       ticks, beyond);
}

/// A drawing of bound scales that is low for its width gets a canvas as low, and ticks that leave each other room.
std::string bind_scales(const Figure& figure, Canvas& canvas) {
    if (!(figure.stretch > 0))
        return "";
    const double up = span_of(figure, figure.y, &Curve::y), across = span_of(figure, figure.x, &Curve::x);
    const double usual = canvas.height_mm;
    const double plot = 0.87 * canvas.width_mm * figure.stretch * up / across;
    canvas.height_mm = std::min(usual, plot + 0.36 * usual);
    return (plot < 0.3 * usual ? fmt::format("set ytics {:.1g}\n", up / 2) : "") +
           fmt::format("set size ratio {:.6g}\n", -figure.stretch);
}

} // namespace

std::string mark_of(const Figure& figure) {
    Hash64 hash;
    hash.add(figure.title)
        .add(axis_words(figure.x.label, figure.x.unit))
        .add(axis_words(figure.y.label, figure.y.unit));
    for (const auto& [x, name] : figure.places)
        hash.add(name);
    for (const Curve& curve : figure.curves) {
        hash.add(curve.label).add(static_cast<int>(curve.style));
        add_rounded(hash, curve.x);
        add_rounded(hash, curve.y);
        if (!curve.spread.empty())
            add_rounded(hash, curve.spread);
    }
    return fmt::format("<!-- plotted {} -->", hash.hex());
}

std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file, Canvas canvas) {
    const std::string scales = bind_scales(figure, canvas);
    std::string script = open_canvas(canvas, file) + scales;
    if (canvas.titled)
        script += fmt::format("set title {}\n", in_gnuplots_quotes(figure.title));
    script += "set grid lc rgb '#cccccc'\nset key below height 1\nset autoscale noextend\nset offsets graph 0.02, "
              "graph 0.02, "
              "graph 0.05, graph 0.05\n";
    script += axis('x', figure.x) + axis('y', figure.y) + names_of(figure);
    std::string plots;
    for (std::size_t k = 0; k < figure.curves.size(); ++k) {
        script += data_of(figure.curves[k], k);
        const std::string& label = figure.curves[k].label;
        plots += fmt::format("{}$curve{} {} {}", k ? ", " : "plot ", k, style(figure.curves[k], k),
                             label.empty() ? "notitle" : "title " + in_gnuplots_quotes(label));
    }
    return script + plots + "\nunset output\n";
}

Result<Done> draw(const Figure& figure, const std::filesystem::path& file, const Canvas& canvas) {
    return run_gnuplot(gnuplot_script(figure, file, canvas), file, canvas,
                       "leave --out away: the text and --json need no gnuplot",
                       ending_of(file) == ".svg" ? mark_of(figure) + "\n" : "");
}

Result<std::vector<std::filesystem::path>> draw_all(const Sheet& sheet, const std::filesystem::path& folder,
                                                    const std::vector<std::string>& endings, const Canvas& canvas) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::vector<std::filesystem::path> files;
    for (const Figure* figure : sheet.figures())
        for (const std::string& ending : endings) {
            files.push_back(folder / (figure->name + ending));
            if (const Result<Done> drawn = draw(*figure, files.back(), canvas); !drawn)
                return drawn.problems();
        }
    return files;
}

} // namespace tumble::sheet
