#include "report/diagnosis_page.h"
#include "report/diagnosis_pictures.h"
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
            .unit = "m_s",
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
    CHECK(page.find(">slow</text>") < page.find("against acceleration"));
    CHECK(page.find(">slow</text>") > page.find("against time"));
}

TEST_CASE("axes have their units in brackets") {
    diagnose::Diagnosis diagnosis;
    diagnosis.curves = {curve_of("first", "slow")};
    const std::string page = page_of(diagnosis, "1");
    for (const char* words :
         {">time [s]<", ">residual [standard errors]<", ">vx as simulated [m/s]<", ">acceleration [(m/s)/s]<"})
        CHECK_MESSAGE(page.find(words) != std::string::npos, words);
}

TEST_CASE("ticks have the digits that their step needs, and a true minus sign") {
    CHECK(tick_word(-0.1, 0.05) == "\u22120.10");
    CHECK(tick_word(1e-17, 0.05) == "0");
    CHECK(tick_word(40, 20) == "40");
    CHECK(tick_word(-0.002, 0.001) == "\u22120.002");
    CHECK(tick_word(2e-6, 1e-6) == "2e-06");
    CHECK(tick_word(2e6, 1e6) == "2e+06");
}

/// Two in a row: 460 + 20 + 460 px wide, and the second row begins 20 px below the higher of the first.
TEST_CASE("plots in a file of their own stand in rows, on white and with their style") {
    Plot plot{.title = "t", .x_label = "x", .y_label = "y", .traces = {}, .levels = {}, .band = {}, .y_range = {}};
    Plot higher = plot;
    higher.height = 300;
    const std::string file = svg_file({svg_of(plot), svg_of(higher), svg_of(plot)}, 2);
    CHECK(file.starts_with("<svg viewBox=\"-8 -8 956 616\" width=\"956\" height=\"616\"")); // with its margins
    CHECK(file.find(".grid{") != std::string::npos);
    CHECK(file.find("fill=\"white\"") != std::string::npos);
    CHECK(count(file, "<svg x=\"480\" y=\"0\"") == 1);
    CHECK(count(file, "<svg x=\"0\" y=\"320\"") == 1);
    CHECK(count(file, "<svg ") == count(file, "</svg>"));
}

TEST_CASE("a diagnosis of records has its residuals as a picture, one of a bed each of its numbers") {
    diagnose::Diagnosis records;
    records.curves = {curve_of("first", "slow")};
    const auto of_records = pictures_of(records);
    REQUIRE(of_records.size() == 1);
    CHECK(of_records[0].name == "residuals.svg");
    CHECK(count(of_records[0].svg, "residual [standard errors]") == 3);
    diagnose::Diagnosis bed;
    bed.beds.resize(2);
    bed.beds[0].condition = "half load";
    bed.beds[0].measure = "surface_slope";
    bed.beds[1].condition = "Shaken: 2 mm";
    bed.beds[1].measure = "circulation";
    const auto of_bed = pictures_of(bed);
    REQUIRE(of_bed.size() == 2);
    CHECK(of_bed[0].name == "half-load-surface-slope.svg");
    CHECK(of_bed[1].name == "shaken-2-mm-circulation.svg");
    CHECK(of_bed[0].svg.find("half load</text>") != std::string::npos);
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
        const std::size_t at = svg.rfind("<circle", svg.find(">" + trace.label + "<"));
        CHECK(attribute(svg.substr(at), "cx") >= 62);
    }
}

} // namespace test_diagnosis_page
