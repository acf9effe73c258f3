#include "report/diagnosis_page.h"
#include "report/svg_plot.h"

#include <doctest/doctest.h>
#include <string>

namespace test_diagnosis_page {

using namespace tumble;
using namespace tumble::report;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

/// The number of an attribute where it first stands, as in height="294".
double attribute(const std::string& svg, const std::string& name) {
    const std::size_t at = svg.find(" " + name + "=\"");
    REQUIRE(at != std::string::npos);
    return std::stod(svg.substr(at + name.size() + 3));
}

diagnose::Curve curve_of(const std::string& record, const std::string& condition) {
    return {.record = record,
            .condition = condition,
            .head = "vx_m_s",
            .unit = "m/s",
            .sigma = 0.1,
            .time = {0, 1, 2},
            .measured = {0, 1, 1},
            .baseline = {0, 1, 2},
            .extended = {},
            .left_out = {false, false, false}};
}

} // namespace

TEST_CASE("the colours of residuals are named once for each condition, in the first plot alone") {
    diagnose::Diagnosis diagnosis;
    diagnosis.curves = {curve_of("first", "slow"), curve_of("second", "slow"), curve_of("third", "swift")};
    const std::string page = page_of(diagnosis, "1");
    CHECK(count(page, ">slow</text>") == 1);
    CHECK(count(page, ">swift</text>") == 1);
    CHECK(page.find(">slow</text>") < page.find("against speed"));
    CHECK(page.find(">slow</text>") > page.find("against time"));
}

TEST_CASE("axes have their units in brackets") {
    diagnose::Diagnosis diagnosis;
    diagnosis.curves = {curve_of("first", "slow")};
    const std::string page = page_of(diagnosis, "1");
    for (const char* words : {">time [s]<", ">residual [standard errors]<", ">reading [m/s]<", ">speed [m/s/s]<"})
        CHECK_MESSAGE(page.find(words) != std::string::npos, words);
}

/// Ten labels of twenty letters need more than the 386 pixels between the axes: the legend gets rows, and the picture
/// grows by them, so that nothing lies over the plot or beyond the picture's edge.
TEST_CASE("a legend that is longer than its plot is wide goes on in further rows") {
    Plot plot{.title = "t", .x_label = "x", .y_label = "y", .traces = {}, .levels = {}, .band = {}, .y_range = {}};
    const auto add = [&] {
        const std::string label = "condition of number " + std::to_string(plot.traces.size());
        plot.traces.push_back({.label = label, .x = {0, 1}, .y = {0, 1}, .color = color_of(plot.traces.size())});
    };
    add();
    const double one_row = attribute(svg_of(plot), "height");
    CHECK(one_row == plot.height);
    for (int k = 0; k < 9; ++k)
        add();
    const std::string svg = svg_of(plot);
    CHECK(attribute(svg, "height") > one_row + 50);
    for (const Trace& trace : plot.traces) {
        const std::size_t at = svg.rfind("<rect", svg.find(">" + trace.label + "<"));
        CHECK(attribute(svg.substr(at), "x") >= 62);
    }
}

} // namespace test_diagnosis_page
