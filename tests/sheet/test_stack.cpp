#include "about.h"
#include "folder.h"
#include "sheet/stack.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>

namespace test_stack {

using namespace tumble;
using namespace tumble::sheet;
using tumble::test::about;

namespace {

const Stack two{
    .title = "It's a fall",
    .x = {"time", "s"},
    .legend = {},
    .panels = {{{"energy", "mJ"},
                {{{"kinetic energy", 0, 0}, {0, 1, 2}, {0, 1, 4}}, {{"lost energy", 1, 0}, {0, 1, 2}, {0, 0, 1}}}},
               {{"height", "mm"}, {{{"", 0, 0}, {0, 1, 2}, {500, 400, 100}}}}}};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string script_of(const Stack& stack, const Canvas& canvas, const char* file = "a.svg") {
    const auto script = gnuplot_script(stack, file, canvas);
    REQUIRE_MESSAGE(script.ok(), to_string(script.problems()));
    return *script;
}

/// Lines of data behind the name of a block.
std::vector<std::string> rows_of(const std::string& script, const std::string& name) {
    std::vector<std::string> rows;
    std::size_t at = script.find(name + " << END\n");
    REQUIRE(at != std::string::npos);
    for (at = script.find('\n', at) + 1; script.compare(at, 4, "END\n") != 0; at = script.find('\n', at) + 1)
        rows.push_back(script.substr(at, script.find('\n', at) - at));
    return rows;
}

} // namespace

/// An inch has 25.4 mm, 72 points and, in an SVG file, 96 pixels: 85 mm are 321 of them, 8 pt 10.67; at 300 dpi a PNG
/// file has 1004. Gnuplot's PNG and PDF letters are 4/3 of what it is told.
TEST_CASE("a canvas has the size in print that is asked for, and letters of so many points") {
    const Canvas column{.width_mm = 85, .height_mm = 60, .dpi = 300, .font_pt = 8};
    CHECK(open_canvas(column, "a.svg").starts_with("set terminal svg size 321,227 font 'DejaVu Sans,10.67'"));
    CHECK(open_canvas(column, "a.png").starts_with("set terminal pngcairo size 1004,709 font 'DejaVu Sans,25'"));
    CHECK(open_canvas(column, "a.pdf").starts_with("set terminal pdfcairo size 8.5cm,6cm font 'DejaVu Sans,6'"));
    CHECK(check_drawable("a.pdf").ok());
    CHECK(check_drawable("a.PDF").ok());
    CHECK(open_canvas(column, "a.PDF").starts_with("set terminal pdfcairo"));
    CHECK(!check_drawable("a.jpg").ok());
}

TEST_CASE("each panel has its label with its unit, the lowest the axis across, and words stand as they are") {
    const std::string script = script_of(two, {});
    CHECK(contains(script, "'energy [mJ]'"));
    CHECK(contains(script, "'height [mm]'"));
    CHECK(contains(script, "'It''s a fall'"));
    CHECK(contains(script, "'kinetic energy'"));
    CHECK(contains(script, "'lost energy'"));
    CHECK(contains(script, "'time [s]'"));
    // Numbers across stand at the lowest panel alone.
    const std::size_t none = script.find("set format x ''"), numbers = script.find("set format x '%g'");
    CHECK(none < numbers);
    CHECK(script.find("set format x", numbers + 1) == std::string::npos);
}

TEST_CASE("letters that leave panels no room are refused, and the height that is named is enough") {
    Canvas canvas{.width_mm = 85, .height_mm = 20, .dpi = 300, .font_pt = 8};
    const Problems problems = gnuplot_script(two, "a.pdf", canvas).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "85 x 20 mm leave no room for 2 plots with letters of 8 pt");
    const std::string words = "make it ";
    REQUIRE(problems[0].fix.starts_with(words));
    canvas.height_mm = std::stod(problems[0].fix.substr(words.size()));
    CHECK(gnuplot_script(two, "a.pdf", canvas).ok());
    canvas.height_mm -= 1;
    CHECK(!gnuplot_script(two, "a.pdf", canvas).ok());
    canvas.height_mm = usual_height(two, canvas);
    CHECK(gnuplot_script(two, "a.pdf", canvas).ok());
}

/// 100,000 points of a wave whose highest and lowest are single points; a picture has no more than 800 columns, of
/// which four points each are enough.
TEST_CASE("a long line is thinned out, and keeps its ends and its peaks") {
    constexpr int count = 100000;
    Stack stack{.x = {"time", "s"}, .panels = {{{"force", "N"}, {Trace{}}}}};
    Trace& trace = stack.panels[0].traces[0];
    for (int k = 0; k < count; ++k) {
        trace.x.push_back(k);
        trace.y.push_back(std::sin(0.01 * k));
    }
    trace.y[33333] = 7;
    trace.y[66666] = -7;
    const std::vector<std::string> rows = rows_of(script_of(stack, {}), "$line0_0");
    CHECK(rows.size() <= 4 * 801);
    CHECK(rows.size() > 800);
    CHECK(rows.front() == "0 0");
    CHECK(rows.back().starts_with("99999 "));
    CHECK(std::find(rows.begin(), rows.end(), "33333 7") != rows.end());
    CHECK(std::find(rows.begin(), rows.end(), "66666 -7") != rows.end());
}

TEST_CASE("what is not known interrupts a line") {
    Stack stack = two;
    stack.panels[1].traces[0].y[1] = std::nan("");
    CHECK(rows_of(script_of(stack, {}), "$line1_0") == std::vector<std::string>{"0 500", "", "2 100"});
}

TEST_CASE("gnuplot draws a stack as PNG of its size, as SVG and as PDF" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const test::Folder folder;
    Stack stack = two;
    stack.legend = {{"a run", std::nullopt, 0}, {"another", std::nullopt, 1}};
    const Canvas canvas{.width_mm = 85, .height_mm = 70, .dpi = 300, .font_pt = 8};
    for (const char* name : {"a.png", "a.svg", "a.pdf"}) {
        const auto drawn = draw(stack, folder.path / name, canvas);
        REQUIRE_MESSAGE(drawn.ok(), to_string(drawn.problems()));
    }
    const std::string png = test::content_of(folder.path / "a.png");
    REQUIRE(png.size() > 24);
    const auto number_at = [&](std::size_t at) { // big end first
        int number = 0;
        for (std::size_t k = 0; k < 4; ++k)
            number = 256 * number + static_cast<unsigned char>(png[at + k]);
        return number;
    };
    CHECK(number_at(16) == 1004);
    CHECK(number_at(20) == 827);
    CHECK(png.substr(37, 4) == "pHYs"); // 300 dpi, so that it is 85 mm wide on paper
    CHECK(number_at(41) == 11811);
    CHECK(number_at(45) == 11811);
    const std::string svg = test::content_of(folder.path / "a.svg");
    CHECK(contains(svg, "energy [mJ]"));
    CHECK(contains(svg, "another"));
    CHECK(contains(svg, "time [s]"));
    CHECK(test::content_of(folder.path / "a.pdf").starts_with("%PDF"));
}

} // namespace test_stack
