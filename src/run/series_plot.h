#pragma once

#include "base/problem.h"
#include "observe/series.h"
#include "sheet/stack.h"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

/// series.csv of one or several runs as plots over each other.
namespace tumble::run {

/// Energies, slope and circulation: what a look at any run begins with, by name.
const std::vector<std::string>& main_measures();

/// Heads of the series' columns that a word means: a head, the name of a measure, the name of a group, "tracer:BODY".
/// `run` is where it lies, for the problem: nothing that the series has; what is near, and what there is.
Result<std::vector<std::string>> choose_columns(const observe::Series& series, const std::string& word,
                                                const std::string& run);

struct SeriesPlotOptions {
    // Words of choose_columns; empty: the main ones, and the height of the first tracer.
    std::vector<std::string> measures{};
    double from = -std::numeric_limits<double>::infinity(); // s
    double to = std::numeric_limits<double>::infinity();    // s
    std::vector<std::string> labels{};                      // of the runs; empty: their folders' names
};

struct SeriesPlot {
    sheet::Stack stack;
    std::vector<std::vector<std::string>> columns; // of each panel
    double first = 0, last = 0;                    // s
    std::vector<std::string> warnings;             // what a run has not, columns without a number
};

/// A panel for each unit, and for sizes so far apart that one curve would hide the other's changes. Several runs lie
/// over each other: told apart by colour, or, where a panel has several measures, by dashes. Problems: no runs, a word
/// that the first run's series knows nothing of, no rows in the stretch of time.
Result<SeriesPlot> plot_series(const std::vector<std::filesystem::path>& runs, const SeriesPlotOptions& options);

} // namespace tumble::run
