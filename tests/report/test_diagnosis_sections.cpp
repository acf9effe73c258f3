// What a page of a diagnosis shows of causes, columns and directions.
#include "report/bar_chart.h"
#include "report/cause_section.h"
#include "report/diagnosis_page.h"
#include "report/fingerprint_section.h"
#include "report/measured_words.h"
#include "report/record_section.h"
#include "report/residual_plots.h"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace test_diagnosis_sections {

using namespace tumble;
using namespace tumble::report;

namespace {

std::size_t times(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++found;
    return found;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The number of an attribute of the first element that begins at `at` or behind it.
double number_of(const std::string& svg, std::size_t at, const std::string& name) {
    const std::size_t found = svg.find(" " + name + "=\"", at);
    REQUIRE(found != std::string::npos);
    return std::stod(svg.substr(found + name.size() + 3));
}

/// Causes that are seen, with these falls of chi-square; below 0: one that does not act.
diagnose::Diagnosis of_falls(const std::vector<std::pair<std::string, double>>& falls, double gate) {
    diagnose::Diagnosis diagnosis;
    diagnosis.decision.outcome = diagnose::Outcome::consistent;
    diagnosis.decision.gate = gate;
    for (const auto& [id, fall] : falls) {
        diagnosis.causes.push_back({.id = id, .lo = 0, .hi = 1});
        diagnose::Seen seen;
        seen.visible = fall >= 0;
        seen.gain = std::max(0.0, fall);
        seen.share = fall >= 0 ? 1 : 0;
        seen.upper = 0.25;
        diagnosis.decision.seen.push_back(seen);
    }
    return diagnosis;
}

diagnose::Curve curve_of(const std::string& record, const std::string& head, double off, std::size_t readings = 40) {
    diagnose::Curve curve{.record = record,
                          .condition = record,
                          .head = head,
                          .unit = "m",
                          .sigma = 0.001,
                          .time = {},
                          .measured = {},
                          .baseline = {},
                          .extended = {},
                          .left_out = std::vector<bool>(readings, false)};
    for (std::size_t k = 0; k < readings; ++k) {
        curve.time.push_back(0.01 * static_cast<double>(k));
        curve.baseline.push_back(0.1);
        curve.measured.push_back(0.1 + off * 0.001 * (k % 2 ? 1 : -1));
        curve.extended.push_back(0.1 + (off - 1) * 0.001 * (k % 2 ? 1 : -1));
    }
    return curve;
}

/// One cause, with which every residual is 1.
diagnose::Diagnosis of_curves(std::vector<diagnose::Curve> curves) {
    diagnose::Diagnosis diagnosis = of_falls({{"drag.linear", 100}}, 11);
    diagnosis.decision.outcome = diagnose::Outcome::named;
    diagnosis.decision.causes = {0};
    diagnosis.decision.best = diagnose::Refit{.causes = {0},
                                              .amplitude = Eigen::VectorXd::Ones(1),
                                              .error = Eigen::VectorXd::Ones(1),
                                              .gain = 100,
                                              .residual = {},
                                              .slopes = {}};
    diagnosis.curves = std::move(curves);
    return diagnosis;
}

} // namespace

TEST_CASE("causes stand by their fall of chi-square; what does nothing, and what cannot act, is one line of words") {
    auto diagnosis = of_falls({{"small", 3}, {"idle", 0.02}, {"largest", 9}, {"absent", -1}, {"middle", 6}}, 11);
    const std::string section = cause_section(diagnosis);
    CHECK(section.find(">largest<") < section.find(">middle<"));
    CHECK(section.find(">middle<") < section.find(">small<"));
    CHECK(times(section, "<rect") == 3);
    CHECK(!has(section, ">idle<"));
    CHECK(has(section, "less than 1 with: idle (below 0.25 (95 %))."));
    CHECK(has(section, "absent: does not act here."));
    CHECK(has(section, ">gate 11<"));
    CHECK(!has(section, ">margin")); // nobody passed the gate
    diagnosis.decision.seen[2].gain = 40;
    diagnosis.settings.margin = 3;
    CHECK(has(cause_section(diagnosis), ">margin 34<")); // 3 nats are 6 of chi-square
    diagnosis.decision.outcome = diagnose::Outcome::named;
    CHECK(has(cause_section(diagnosis), ">margin 34<"));
    CHECK(cause_section({}).empty());
}

TEST_CASE("where only two causes together explain it, each alone is held against the pair") {
    auto diagnosis = of_falls({{"first", 80}, {"second", 60}, {"third", 50}}, 11);
    diagnosis.decision.outcome = diagnose::Outcome::two_causes;
    diagnosis.decision.causes = {0, 1};
    diagnosis.decision.best = diagnose::Refit{.causes = {0, 1},
                                              .amplitude = Eigen::VectorXd::Ones(2),
                                              .error = Eigen::VectorXd::Ones(2),
                                              .gain = 150,
                                              .residual = {},
                                              .slopes = {}};
    const std::string section = cause_section(diagnosis);
    CHECK(has(section, ">both 150<"));
    CHECK(!has(section, ">margin"));
    CHECK(has(section, ">alone 50.0 nats behind the pair<"));
    CHECK(times(section, ">named<") == 2);
}

/// Ticks, bars and limits share one scale: a bar of 20 ends where the tick of 20 stands, and so does a limit of 20.
TEST_CASE("bars, ticks and limits share a scale, and words of limits that lie near each other do not touch") {
    const std::string svg =
        svg_of({{"a", "", "red", 40}, {"b", "", "red", 20}}, {{20, "gate"}, {20.5, "margin"}}, "fall");
    const double tick = number_of(svg, svg.rfind("<text", svg.find(">20<")), "x");
    const std::size_t bar = svg.find("<rect", svg.find(">b<"));
    CHECK(std::abs(number_of(svg, bar, "x") + number_of(svg, bar, "width") - tick) < 0.2);
    const std::size_t gate = svg.rfind("<text", svg.find(">gate<")), margin = svg.rfind("<text", svg.find(">margin<"));
    CHECK(std::abs(number_of(svg, gate, "x") - tick) < 0.2);
    CHECK(number_of(svg, gate, "y") > number_of(svg, margin, "y") + 10);
    CHECK(has(svg, ">fall</text>"));
}

TEST_CASE("every measured column has its residual before and after, with unit, size of a standard error and scatter") {
    const auto diagnosis = of_curves({curve_of("low", "height_mm", 3), curve_of("low", "way_mm", 2)});
    const std::string section = record_section(diagnosis);
    for (const char* words :
         {"<h3>height [m]</h3>", "<h3>way [m]</h3>", ">height: residual against time<", ">way: residual against time<",
          ">height: with drag.linear<", ">way: with drag.linear<",
          "One standard error of a reading is 0.001 m. Root mean square of 40 residuals: 3.00 before, "
          "1.00 with drag.linear"})
        CHECK_MESSAGE(has(section, words), words);
    CHECK(!has(section, "Not drawn"));
}

TEST_CASE("of many columns those nearest to noise are named instead of drawn, and of many records some are drawn") {
    std::vector<diagnose::Curve> curves;
    for (int k = 0; k < 15; ++k)
        curves.push_back(curve_of("one", "c" + std::to_string(k) + "_mm", 20 - k));
    const auto columns = residuals_by_column(of_curves(curves));
    REQUIRE(columns.size() == 15);
    for (std::size_t k = 0; k < 15; ++k)
        CHECK(columns[k].plots.size() == (k < 3 ? 4U : k < 12 ? 2U : 0U)); // the first lie farthest off
    const std::string section = record_section(of_curves(curves));
    CHECK(has(section, "nearest to noise: c12 [m], c13 [m], c14 [m]; residuals.csv"));
    CHECK(has(section, "12 of 15 records are drawn"));
}

TEST_CASE("more conditions than colours: those farthest off have their own, the others share one") {
    std::vector<diagnose::Curve> curves;
    for (int k = 0; k < 10; ++k)
        curves.push_back(curve_of("c" + std::to_string(k), "height_mm", 1 + k));
    const std::string plot = residuals_by_column(of_curves(curves))[0].plots[0];
    for (const char* name : {">c9</text>", ">c4</text>", ">4 others</text>"})
        CHECK_MESSAGE(times(plot, name) == 1, name);
    CHECK(!has(plot, ">c3</text>"));
}

TEST_CASE("where walls vibrate residuals stand against the phase of the shaking") {
    diagnose::Curve curve = curve_of("one", "height_mm", 3);
    curve.shaken = 0.04;
    CHECK(has(record_section(of_curves({curve})), ">phase of the slowest vibration [deg]<"));
    curve.shaken = 0;
    CHECK(!has(record_section(of_curves({curve})), "phase of the"));
}

TEST_CASE("single numbers are a table, not plots of one point") {
    const std::string section = record_section(of_curves({curve_of("first drop", "rebound_mm", 3, 1)}));
    CHECK(!has(section, "<svg"));
    CHECK(has(section, "<td>first drop</td><td>rebound [m]</td>"));
    CHECK(has(section, ">\u22123.0</td>"));
    CHECK(has(section, ">\u22121.0</td>"));
}

TEST_CASE("the scatter that was stated and that was found stand in one row for each column") {
    auto diagnosis = of_curves({curve_of("low", "height_mm", 3), curve_of("low", "clock_ms", 2)});
    diagnosis.curves[0].measure = "centre_of_mass_y";
    diagnosis.curves[0].stated = 0.0005;
    diagnosis.curves[1].measure = "time";
    diagnosis.noise.of["time"].correlation = 0.25;
    const std::string table = scatter_table(diagnosis);
    CHECK(has(table,
              "<td>height [m]</td><td>centre_of_mass_y</td><td class=\"n\">0.0005</td><td class=\"n\">0.001</td>"));
    CHECK(has(table, "<td>time</td><td class=\"n\">no</td><td class=\"n\">0.001</td><td class=\"n\">0.25</td>"));
}

/// A residual of 0.5 t in standard errors: it follows time, and with a cause that does just that it is gone.
TEST_CASE("the table of directions stamps what the residual follows, and says what a cause's effect looks like") {
    auto diagnosis = of_falls({{"ins.drift", 100}}, 11);
    const Eigen::VectorXd time = Eigen::VectorXd::LinSpaced(100, -10, 10);
    diagnose::Evidence& evidence = diagnosis.evidence;
    evidence.residual = 0.5 * time;
    evidence.nuisances = Eigen::MatrixXd::Zero(100, 0);
    evidence.effects = time;
    evidence.causes = diagnosis.causes;
    evidence.directions.names = {"a constant (way)", "time (way)", "impacts, one up and one down (way)",
                                 "a constant in 'low' alone (way)"};
    evidence.directions.own = {"", "", "", "the zero of way"};
    evidence.directions.units = {"m", "m/s", "m", "m"};
    evidence.directions.prints = Eigen::MatrixXd(100, 4);
    evidence.directions.prints << Eigen::VectorXd::Ones(100), time, Eigen::VectorXd::Ones(100),
        Eigen::VectorXd::Ones(100);
    evidence.directions.lengths = evidence.directions.prints.colwise().norm();
    evidence.directions.prints = diagnose::unit_columns(evidence.directions.prints);
    diagnosis.follows.tried = 4;
    diagnosis.follows.gate = 3.3;
    diagnosis.decision.outcome = diagnose::Outcome::none_known;
    CHECK(has(fingerprint_section(diagnosis), "<td>time</td><td class=\"n\">0.500 &plusmn; 0.017 m/s</td>"));
    CHECK(times(fingerprint_section(diagnosis), "<b>FOLLOWS</b>") == 1);
    CHECK(!has(fingerprint_section(diagnosis), "impacts, one up")); // the same as a constant here
    CHECK(has(fingerprint_section(diagnosis), "1 further directions, of one condition alone each"));

    diagnosis.decision.best = refit_linear(evidence, {0});
    diagnosis.decision.causes = {0};
    diagnosis.decision.outcome = diagnose::Outcome::named;
    const std::string section = fingerprint_section(diagnosis);
    CHECK(has(section, "Of its effect 100 % goes along <i>time (way)</i>"));
    CHECK(has(section, "follows, then gone"));
    CHECK(!has(section, "FOLLOWS"));
    CHECK(has(section, ">with ins.drift</th>"));
}

TEST_CASE("numbers have the digits that their error allows") {
    CHECK(with_error(0.186, 0.00052) == "0.18600 &plusmn; 0.00052");
    CHECK(with_error(-84.6123, 6.14) == "\u221284.6 &plusmn; 6.1");
    CHECK(with_error(1234.5, 67) == "1234 &plusmn; 67");
    CHECK(with_error(-5.332e-8, 4.1e-9) == "(\u22125.33 &plusmn; 0.41)&middot;10<sup>\u22128</sup>");
    CHECK(with_error(0.25, 0) == "0.25");
    CHECK(with_minus("-0.0") == "0.0");
    CHECK(with_minus("+0.0") == "0.0");
    CHECK(with_minus("-1.5") == "\u22121.5");
}

TEST_CASE("a page without a decision speaks of no explanation") {
    diagnose::Diagnosis diagnosis;
    diagnosis.curves = {curve_of("one", "height_mm", 1)};
    diagnosis.curves[0].extended.clear();
    const std::string page = page_of(diagnosis, "1");
    for (const char* words : {"best explanation", "How far each cause", "with what is named", "nan"})
        CHECK_MESSAGE(!has(page, words), words);
}

} // namespace test_diagnosis_sections
