#include "sheet/plot.h"

#include "base/child_process.h"
#include "base/text.h"
#include "sheet/show.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>

namespace tumble::sheet {

namespace {

constexpr std::chrono::seconds patience{60};
// Okabe and Ito's colours: told apart also by those who see few.
constexpr std::array<const char*, 6> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

/// In single quotes gnuplot takes every letter as it stands, but for the quote itself.
std::string quoted(const std::string& text) {
    std::string safe = "'";
    for (const char c : text)
        safe += c == '\'' ? std::string("''") : std::string(1, c);
    return safe + "'";
}

std::string axis(char letter, const Axis& axis) {
    std::string script = fmt::format("set {}label {}\n", letter, quoted(head_of(axis)));
    if (axis.logarithmic)
        script += fmt::format("set logscale {}\n", letter);
    if (axis.range)
        script += fmt::format("set {}range [{}:{}]\n", letter, (*axis.range)[0], (*axis.range)[1]);
    return script;
}

std::string style(const Curve& curve, std::size_t index) {
    const char* color = colors[curve.color.value_or(index) % colors.size()];
    if (curve.style == Style::points)
        return fmt::format("with points pt 7 ps 1 lc rgb '{}'", color);
    if (curve.style == Style::bars)
        return fmt::format("with impulses lw 3 lc rgb '{}'", color);
    return fmt::format("with lines lw 2 {} lc rgb '{}'", curve.style == Style::dashes ? "dt 2" : "dt 1", color);
}

std::string data_of(const Curve& curve, std::size_t index) {
    std::string block = fmt::format("$curve{} << END\n", index);
    for (std::size_t k = 0; k < curve.x.size(); ++k)
        block += fmt::format("{:.9g} {:.9g}\n", curve.x[k], curve.y[k]);
    return block + "END\n";
}

} // namespace

std::string gnuplot_script(const Figure& figure, const std::filesystem::path& file) {
    const bool svg = file.extension() == ".svg";
    std::string script = svg ? "set terminal svg size 800,500 font 'DejaVu Sans,13' background 'white' noenhanced\n"
                             : "set terminal pngcairo size 1200,750 font 'DejaVu Sans,14' background 'white' "
                               "noenhanced\n";
    script += fmt::format("set output {}\nset title {}\n", quoted(file.string()), quoted(figure.title));
    script += "set grid lc rgb '#cccccc'\nset key above\nset autoscale noextend\nset offsets graph 0.02, graph 0.02, "
              "graph 0.05, graph 0.05\n";
    if (figure.equal_scales)
        script += "set size ratio -1\n";
    script += axis('x', figure.x) + axis('y', figure.y);
    std::string plots;
    for (std::size_t k = 0; k < figure.curves.size(); ++k) {
        script += data_of(figure.curves[k], k);
        plots += fmt::format("{}$curve{} {} title {}", k ? ", " : "plot ", k, style(figure.curves[k], k),
                             quoted(figure.curves[k].label));
    }
    return script + plots + "\nunset output\n";
}

Result<Done> draw(const Figure& figure, const std::filesystem::path& file) {
    ChildProcess gnuplot({"gnuplot"});
    if (gnuplot.error() == ENOENT)
        return Problem{.what = "gnuplot, which draws the figures, is not installed",
                       .fix = "apt install gnuplot-nox, or leave --out away: the text and --json need no gnuplot"};
    if (gnuplot.error() != 0)
        return Problem{.what = fmt::format("gnuplot could not be started: {}", std::strerror(gnuplot.error()))};
    const std::string script = gnuplot_script(figure, file);
    const bool fed = gnuplot.feed({reinterpret_cast<const std::uint8_t*>(script.data()), script.size()});
    if (gnuplot.wait(patience) == 0 && fed)
        return Done{};
    return Problem{.file = file.string(), .what = "gnuplot failed: " + excerpt(trimmed(gnuplot.printed()), 300)};
}

Result<std::vector<std::filesystem::path>> draw_all(const Sheet& sheet, const std::filesystem::path& folder,
                                                    const std::vector<std::string>& endings) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        return Problem{.file = folder.string(), .what = "cannot be made: " + error.message()};
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
