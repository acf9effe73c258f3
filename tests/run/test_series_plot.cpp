#include "../folder.h"
#include "about.h"
#include "run/run_scene.h"
#include "run/series_plot.h"
#include "scenes.h"

#include <doctest/doctest.h>
#include <set>
#include <utility>

namespace test_series_plot {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// A run of the ball that falls from 0.5 m for 0.02 s, rows every 1 ms: y = h - g t^2 / 2.
fs::path fallen(const fs::path& folder, const std::vector<std::string>& sets = {}) {
    run::RunOptions options;
    options.folder = folder;
    run::RunListener silent;
    const auto summary = run::run_scene(loaded(falling_ball, sets), options, silent);
    REQUIRE_MESSAGE(summary.ok(), to_string(summary.problems()));
    return folder;
}

run::SeriesPlot plotted(const std::vector<fs::path>& runs, const run::SeriesPlotOptions& options) {
    auto plot = run::plot_series(runs, options);
    REQUIRE_MESSAGE(plot.ok(), to_string(plot.problems()));
    return *plot;
}

using Heads = std::vector<std::string>;

} // namespace

TEST_CASE("a plot of a run that did not reach its end says so") {
    const Folder folder;
    const fs::path run = fallen(folder.path / "ball");
    CHECK(plotted({run}, {.measures = {"kinetic_translation"}}).warnings.empty());
    std::string summary = content_of(run / "run.json");
    const std::string finished = "\"state\": \"finished\"";
    REQUIRE(summary.find(finished) != std::string::npos);
    put(run / "run.json", summary.replace(summary.find(finished), finished.size(), "\"state\": \"running\""));
    const auto warnings = plotted({run}, {.measures = {"kinetic_translation"}}).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].starts_with("this run did not end: it was killed, or is still going on"));
}

TEST_CASE("measures of one unit share a panel, in a unit that people read, and their numbers are the run's") {
    const Folder folder;
    const fs::path run = fallen(folder.path / "ball");
    const run::SeriesPlot plot = plotted({run}, {.measures = {"centre_of_mass", "kinetic_translation"}});
    REQUIRE(plot.columns.size() == 2);
    CHECK(plot.columns[0] == Heads{"centre_of_mass_x_m", "centre_of_mass_y_m", "centre_of_mass_z_m"});
    CHECK(plot.columns[1] == Heads{"kinetic_translation_J"});
    const sheet::Panel& height = plot.stack.panels[0];
    CHECK(height.y.label == "length");
    CHECK(height.y.unit == "m");
    CHECK(height.traces[1].ink.label == "centre of mass y");
    REQUIRE(height.traces[1].y.size() == 21);
    // 20 ms: a fall of 9.81 m/s2 * (0.02 s)^2 / 2.
    CHECK(height.traces[1].y.back() == about(0.5 - 9.81 * 0.02 * 0.02 / 2));
    CHECK(plot.stack.x.unit == "ms");
    CHECK(height.traces[1].x.back() == about(20));
    CHECK(plot.stack.panels[1].y.label == "kinetic translation");
    CHECK(plot.stack.title == "A ball that falls");
    CHECK(plot.stack.legend.empty());
}

/// 9.81 m/s2 * 0.01 s: 98 mm/s; from 10 to 20 ms eleven rows.
TEST_CASE("a stretch of time cuts the rows, and one without rows is refused with what there is") {
    const Folder folder;
    const fs::path run = fallen(folder.path / "ball");
    const run::SeriesPlot plot = plotted({run}, {.measures = {"centre_of_mass_y_m"}, .from = 0.0095});
    CHECK(plot.first == about(0.01));
    CHECK(plot.stack.panels[0].traces[0].y.size() == 11);
    const Problems problems = run::plot_series({run}, {.from = 5}).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "has no row in the time asked for");
    CHECK(problems[0].fix == "its rows go from 0 to 0.02 s");
}

TEST_CASE("curves of far different sizes get panels of their own, though they have one unit") {
    const Folder folder;
    // 10 g of glass that fall with 1 m/s have 5 mJ; the balance closes to rounding.
    const fs::path run = fallen(folder.path / "ball", {"observe.measures=[\"kinetic_energy\", \"energy_closure\"]"});
    const run::SeriesPlot plot = plotted({run}, {.measures = {"kinetic_energy", "energy_closure"}});
    CHECK(plot.columns.size() == 2);
}

TEST_CASE("without measures the main ones are plotted that the run has, and all where it has none of them") {
    const Folder folder;
    const fs::path usual = fallen(folder.path / "usual", {"observe.measures=[\"mean_speed\", \"kinetic_energy\"]"});
    CHECK(plotted({usual}, {}).columns == std::vector<Heads>{{"kinetic_energy_J"}});
    const fs::path traced = fallen(folder.path / "traced", {"observe.measures=[\"mean_speed\", \"tracer:ball\"]"});
    CHECK(plotted({traced}, {}).columns == std::vector<Heads>{{"tracer:ball_y_m"}});
    CHECK(plotted({traced}, {}).stack.panels[0].y.label == "ball y");
    const fs::path other = fallen(folder.path / "other", {"observe.measures=[\"mean_speed\"]"});
    CHECK(plotted({other}, {}).columns == std::vector<Heads>{{"mean_speed_m_s"}});
}

TEST_CASE("of one body alone neither circulation nor slope is plotted unasked") {
    const Folder folder;
    const fs::path one =
        fallen(folder.path / "one", {"observe.measures=[\"kinetic_energy\", \"circulation\", \"bodies\"]"});
    CHECK(plotted({one}, {}).columns == std::vector<Heads>{{"kinetic_energy_J"}});
    CHECK(plotted({one}, {.measures = {"circulation"}}).columns == std::vector<Heads>{{"circulation_rad_s"}});
}

TEST_CASE("a measure that is not in the series is named with what is near, what there is, and how to get it") {
    const Folder folder;
    const fs::path run = fallen(folder.path / "ball", {"observe.measures=[\"mean_speed\", \"kinetic_energy\"]"});
    const auto problem_of = [&](const char* word) {
        const Problems problems = run::plot_series({run}, {.measures = {word}}).problems();
        REQUIRE(problems.size() == 1);
        return problems[0];
    };
    const Problem misspelt = problem_of("kinetic_enrgy");
    CHECK(misspelt.what == "the series of this run has no 'kinetic_enrgy'");
    CHECK(misspelt.fix == "did you mean 'kinetic_energy'? it has mean_speed, kinetic_energy");
    CHECK(problem_of("circulation").fix ==
          "run the scene again with it in observe.measures; it has mean_speed, kinetic_energy");
    CHECK(problem_of("x").fix == "it has mean_speed, kinetic_energy");
}

TEST_CASE("several runs lie over each other in colours of their own, by their names or those given") {
    const Folder folder;
    fs::create_directories(folder.path / "more");
    const fs::path a = fallen(folder.path / "a"), b = fallen(folder.path / "more" / "a", {"gravity_m_s2=[0, -1, 0]"});
    const run::SeriesPlot plot = plotted({a, b}, {.measures = {"centre_of_mass_y"}});
    REQUIRE(plot.stack.panels[0].traces.size() == 2);
    CHECK(plot.stack.panels[0].traces[0].ink.color == 0U);
    CHECK(plot.stack.panels[0].traces[1].ink.color == 1U);
    CHECK(plot.stack.panels[0].traces[1].y.back() == about(0.5 - 1.0 * 0.02 * 0.02 / 2));
    REQUIRE(plot.stack.legend.size() == 2);
    CHECK(plot.stack.legend[1].label == b.string()); // both folders are called a
    CHECK(plotted({a, b}, {.measures = {"centre_of_mass_y"}, .labels = {"Earth", "Moon"}}).stack.legend[1].label ==
          "Moon");
    CHECK(!run::plot_series({a, b}, {.labels = {"Earth"}}).ok());
    // Where measures have the colours, runs have dashes.
    const run::SeriesPlot dashed = plotted({a, b}, {.measures = {"centre_of_mass"}});
    CHECK(dashed.stack.panels[0].traces[3].ink.color == 1U);
    CHECK(dashed.stack.panels[0].traces[3].ink.dashes == 1);
    CHECK(!dashed.stack.legend[1].color);
    CHECK(dashed.stack.legend[1].dashes == 1);
}

TEST_CASE("more runs than there are colours get dashes too, and a warning says where lines look alike all the same") {
    const Folder folder;
    const std::vector<fs::path> eight(8, fallen(folder.path / "a"));
    const run::SeriesPlot one = plotted(eight, {.measures = {"centre_of_mass_y"}});
    std::set<std::pair<std::size_t, std::size_t>> looks;
    for (const sheet::Trace& trace : one.stack.panels[0].traces)
        looks.emplace(trace.ink.color.value() % sheet::colors, trace.ink.dashes % sheet::dash_patterns);
    CHECK(looks.size() == 8);
    CHECK(one.stack.legend[7].dashes == one.stack.panels[0].traces[7].ink.dashes);
    CHECK(one.warnings.empty());
    const run::SeriesPlot several = plotted(eight, {.measures = {"centre_of_mass"}});
    REQUIRE(several.warnings.size() == 1);
    CHECK(several.warnings[0].starts_with("8 runs have only 5 kinds of dashes between them"));
    CHECK(plotted({eight.begin(), eight.begin() + 5}, {.measures = {"centre_of_mass"}}).warnings.empty());
}

TEST_CASE("what only one of two runs has is plotted of that, with a warning; a folder that is no run is refused") {
    const Folder folder;
    const fs::path a = fallen(folder.path / "a"),
                   b = fallen(folder.path / "b", {"observe.measures=[\"kinetic_energy\"]"});
    const run::SeriesPlot plot = plotted({a, b}, {.measures = {"centre_of_mass_y"}});
    CHECK(plot.stack.panels[0].traces.size() == 1);
    REQUIRE(plot.warnings.size() == 1);
    CHECK(plot.warnings[0] == b.string() + ": its series has no centre_of_mass_y_m");
    CHECK(!run::plot_series({a, folder.path}, {}).ok());
}

} // namespace test_series_plot
