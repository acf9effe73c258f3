#include "folder.h"
#include "sheet/plot.h"

#include <cstdlib>
#include <doctest/doctest.h>

namespace test_plot {

using namespace tumble;
using namespace tumble::sheet;

namespace {

const Figure line{.name = "line",
                  .title = "It's a line",
                  .x = {"time", "s"},
                  .y = {"force", "N"},
                  .curves = {{"F", Style::line, {0, 1}, {0, 2}}}};

} // namespace

TEST_CASE("gnuplot is told units, and words as they stand") {
    const std::string script = gnuplot_script(line, "a.svg");
    CHECK(script.find("set xlabel 'time [s]'") != std::string::npos);
    CHECK(script.find("set ylabel 'force [N]'") != std::string::npos);
    CHECK(script.find("set title 'It''s a line'") != std::string::npos);
    CHECK(script.find("1 2\nEND") != std::string::npos);
    CHECK(script.find("set terminal svg size 800,500 font 'DejaVu Sans,13' background 'white' noenhanced rounded\n") ==
          0);
}

TEST_CASE("points with a spread get it as bars, and the mark of a figure knows of it") {
    Figure scattered = line;
    scattered.curves[0].style = Style::points;
    const std::string before = mark_of(scattered);
    scattered.curves[0].spread = {0.5, 0.25};
    const std::string script = gnuplot_script(scattered, "a.svg");
    CHECK(script.find("with yerrorbars") != std::string::npos);
    CHECK(script.find("1 2 0.25\nEND") != std::string::npos);
    CHECK(mark_of(scattered) != before);
}

TEST_CASE("places across are named at the upper edge") {
    Figure named = line;
    named.places = {{0.5, "it's half"}};
    CHECK(gnuplot_script(named, "a.svg").find("set x2tics ('it''s half' 0.5)") != std::string::npos);
    CHECK(mark_of(named) != mark_of(line));
}

TEST_CASE("a figure's mark changes with its data and words, and not with rounding") {
    Figure other = line;
    other.curves[0].y[1] *= 1 + 1e-13;
    CHECK(mark_of(other) == mark_of(line));
    other.curves[0].y[0] = 0.01;
    CHECK(mark_of(other) != mark_of(line));
    other = line;
    other.title = "Another line";
    CHECK(mark_of(other) != mark_of(line));
}

TEST_CASE("without gnuplot there is one clear message") {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    const auto drawn = draw(line, "line.png");
    setenv("PATH", path.c_str(), 1);
    REQUIRE_FALSE(drawn.ok());
    REQUIRE(drawn.problems().size() == 1);
    CHECK(drawn.problems()[0].what == "gnuplot, which draws the figures, is not installed");
    CHECK(drawn.problems()[0].fix.find("gnuplot-nox") != std::string::npos);
}

TEST_CASE("figures are written as PNG and SVG, and a folder that is not there is told" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const test::Folder folder;
    for (const char* ending : {".png", ".svg"}) {
        const auto drawn = draw(line, folder.path / ("line" + std::string(ending)));
        REQUIRE_MESSAGE(drawn.ok(), to_string(drawn.problems()));
    }
    CHECK(test::content_of(folder.path / "line.png").starts_with("\x89PNG"));
    CHECK(test::content_of(folder.path / "line.svg").find("force [N]") != std::string::npos);
    CHECK(test::content_of(folder.path / "line.svg").ends_with(mark_of(line) + "\n"));
    CHECK_FALSE(draw(line, folder.path / "none" / "line.png").ok());
}

} // namespace test_plot
