#pragma once

#include "lab/experiment.h"

#include <doctest/doctest.h>
#include <string>
#include <utility>

namespace tumble::lab::testing {

/// What an experiment finds with these flags.
inline Outcome performed(const std::string& name, const sheet::Typed& typed = {}) {
    const auto experiment = find_experiment(name);
    REQUIRE_MESSAGE(experiment.ok(), to_string(experiment.problems()));
    const auto values = read_values(**experiment, typed);
    REQUIRE_MESSAGE(values.ok(), to_string(values.problems()));
    auto outcome = (*experiment)->perform(*values);
    REQUIRE_MESSAGE(outcome.ok(), to_string(outcome.problems()));
    return std::move(*outcome);
}

/// The problem that refuses these flags.
inline Problem refused(const std::string& name, const sheet::Typed& typed) {
    const Experiment& experiment = **find_experiment(name);
    const auto outcome = experiment.perform(*read_values(experiment, typed));
    REQUIRE_FALSE(outcome.ok());
    return outcome.problems().front();
}

} // namespace tumble::lab::testing
