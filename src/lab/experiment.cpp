#include "lab/experiment.h"

#include "base/text.h"
#include "lab/each.h"

#include <fmt/format.h>

namespace tumble::lab {

std::string Recording::csv() const {
    std::string text = csv_line(heads);
    for (const std::vector<double>& row : rows)
        text += csv_line(row);
    return text;
}

const std::vector<Experiment>& all_experiments() {
    static const std::vector<Experiment> experiments{drop(),      oblique(), slide(), roll(),    roll_out(),
                                                     spin_down(), plate(),   press(), tension(), weigh(),
                                                     repose(),    sensor(),  thesis()};
    return experiments;
}

Result<const Experiment*> find_experiment(std::string_view name) {
    std::vector<std::string> names;
    for (const Experiment& experiment : all_experiments()) {
        if (experiment.name == name)
            return &experiment;
        names.push_back(experiment.name);
    }
    const std::string guess = did_you_mean(name, names);
    return Problem{.what = fmt::format("there is no experiment '{}'", excerpt(name)),
                   .fix = (guess.empty() ? "" : guess + " ") + "`tumble lab` lists all there are"};
}

Result<Values> read_values(const Experiment& experiment, const sheet::Typed& typed) {
    return sheet::read_values("lab " + experiment.name, experiment.parameters, typed);
}

} // namespace tumble::lab
