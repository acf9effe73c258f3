#pragma once

#include "base/table.h"
#include "sheet/parameter.h"
#include "sheet/sheet.h"

#include <string>
#include <string_view>
#include <vector>

/// Experiments that a laboratory does to find a material's numbers, done by the solvers.
namespace tumble::lab {

using sheet::Parameter;
using sheet::Sheet;
using sheet::Values;

/// What an instrument would have written: a CSV file with units in its heads.
struct Recording {
    std::string name; // of the file, without extension
    std::vector<std::string> heads;
    std::vector<std::vector<double>> rows{};

    [[nodiscard]] std::string csv() const;
};

struct Outcome {
    Sheet sheet;
    std::vector<Recording> recordings;
};

struct Experiment {
    std::string name;
    std::string title;
    std::vector<Parameter> parameters;
    /// Problems: values that each are in range but together make no experiment; those of the solver.
    Result<Outcome> (*perform)(const Values&) = nullptr;
    /// The same numbers from a record that a laboratory wrote, CSV; null where there is none to read. Problems: those
    /// of the table.
    Result<Outcome> (*evaluate)(const Table&, const Values&) = nullptr;
    std::string record_form{}; // for help: "force_N, strain"
};

const std::vector<Experiment>& all_experiments();

/// Problem: there is no experiment of that name; says which one is near.
Result<const Experiment*> find_experiment(std::string_view name);

/// The defaults with what was typed put in; problems as those of sheet::read_values.
Result<Values> read_values(const Experiment& experiment, const sheet::Typed& typed = {});

} // namespace tumble::lab
