#include "sheet/plot.h"

#include "base/hash.h"
#include "base/make_folder.h"
#include "sheet/gnuplot.h"
#include "sheet/show.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <limits>

namespace tumble::sheet {

namespace {

// Okabe and Ito's colours: told apart also by those who see few.
constexpr std::array<const char*, 6> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

std::string axis(char letter, const Axis& axis) {
    std::string script = fmt::format("set {}label {}\n", letter, in_gnuplots_quotes(head_of(axis)));
    if (axis.logarithmic)
        script += fmt::format("set logscale {}\n", letter);
    if (axis.range)
        script += fmt::format("set {}range [{}:{}]\n", letter, (*axis.range)[0], (*axis.range)[1]);
    return script;
}

std::string style(const Curve& curve, std::size_t index) {
    const char* color = colors[curve.color.value_or(index) % colors.size()];
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

/// A drawing of bound scales that is low for its width gets a canvas as low, and ticks that leave each other room.
std::string canvas(const Figure& figure, bool svg) {
    const int width = svg ? 800 : 1200, usual = svg ? 500 : 750;
    std::string ticks;
    int height = usual;
    if (figure.stretch > 0) {
        const double up = span_of(figure, figure.y, &Curve::y), across = span_of(figure, figure.x, &Curve::x);
        const double plot = 0.87 * width * figure.stretch * up / across;
        height = static_cast<int>(std::min(1.0 * usual, plot + 0.36 * usual));
        if (plot < 0.3 * usual)
            ticks = fmt::format("set ytics {:.1g}\n", up / 2);
        ticks += fmt::format("set size ratio {:.6g}\n", -figure.stretch);
    }
    // Rounded: a mitred corner sticks out of a sharp turn, and lines that only end there leave a notch.
    return fmt::format("set terminal {} size {},{} font 'DejaVu Sans,{}' background 'white' noenhanced rounded\n",
                       svg ? "svg" : "pngcairo", width, height, svg ? 13 : 14) +
           ticks;
}

} // namespace

std::string mark_of(const Figure& figure) {
    Hash64 hash;
    hash.add(figure.title).add(head_of(figure.x)).add(head_of(figure.y));
    for (const Curve& curve : figure.curves) {
        hash.add(curve.label).add(static_cast<int>(curve.style));
        add_rounded(hash, curve.x);
        add_rounded(hash, curve.y);
        if (!curve.spread.empty())
            add_rounded(hash, curve.spread);
    }
    return fmt::format("<!-- plotted {} -->", hash.hex());
}

std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file) {
    std::string script = canvas(figure, file.extension() == ".svg");
    script += fmt::format("set output {}\nset title {}\n", in_gnuplots_quotes(file.string()),
                          in_gnuplots_quotes(figure.title));
    script += "set grid lc rgb '#cccccc'\nset key below height 1\nset autoscale noextend\nset offsets graph 0.02, "
              "graph 0.02, "
              "graph 0.05, graph 0.05\n";
    script += axis('x', figure.x) + axis('y', figure.y);
    std::string plots;
    for (std::size_t k = 0; k < figure.curves.size(); ++k) {
        script += data_of(figure.curves[k], k);
        const std::string& label = figure.curves[k].label;
        plots += fmt::format("{}$curve{} {} {}", k ? ", " : "plot ", k, style(figure.curves[k], k),
                             label.empty() ? "notitle" : "title " + in_gnuplots_quotes(label));
    }
    return script + plots + "\nunset output\n";
}

Result<Done> draw(const Figure& figure, const std::filesystem::path& file) {
    if (Result<Done> drawn =
            run_gnuplot(gnuplot_script(figure, file), file, "leave --out away: the text and --json need no gnuplot");
        !drawn)
        return drawn;
    if (file.extension() == ".svg" && !(std::ofstream(file, std::ios::app) << mark_of(figure) << '\n'))
        return Problem{.file = file.string(), .what = "cannot be written to its end"};
    return Done{};
}

Result<std::vector<std::filesystem::path>> draw_all(const Sheet& sheet, const std::filesystem::path& folder,
                                                    const std::vector<std::string>& endings) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::vector<std::filesystem::path> files;
    for (const Figure* figure : sheet.figures())
        for (const std::string& ending : endings) {
            files.push_back(folder / (figure->name + ending));
            if (const Result<Done> drawn = draw(*figure, files.back()); !drawn)
                return drawn.problems();
        }
    return files;
}

} // namespace tumble::sheet
