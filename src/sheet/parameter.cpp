#include "sheet/parameter.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sheet {

namespace {

Result<double> read_value(const std::string& owner, const std::vector<Parameter>& parameters, const std::string& name,
                          const std::string& text) {
    const auto parameter =
        std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& one) { return one.name == name; });
    if (parameter == parameters.end()) {
        std::vector<std::string> names;
        for (const Parameter& one : parameters)
            names.push_back(one.name);
        return Problem{.key = "--" + name,
                       .what = fmt::format("{} has no parameter '{}'", owner, excerpt(name)),
                       .fix = did_you_mean(name, names)};
    }
    const Result<double> value = parse_number(text);
    if (!value)
        return Problem{.key = "--" + name,
                       .what = fmt::format("--{} takes a number, not '{}'", name, excerpt(text)),
                       .fix = describe(*parameter)};
    if (!parameter->limits.hold(*value))
        return Problem{.key = "--" + name,
                       .what = fmt::format("--{} is {}, out of its range", name, scene::plain(*value)),
                       .fix = describe(*parameter)};
    if (parameter->whole && *value != std::floor(*value))
        return Problem{.key = "--" + name,
                       .what = fmt::format("--{} is {}, and counts something", name, scene::plain(*value)),
                       .fix = "a whole number, " + describe(*parameter)};
    return *value;
}

} // namespace

Result<Values> read_values(const std::string& owner, const std::vector<Parameter>& parameters, const Typed& typed) {
    std::map<std::string, double, std::less<>> values;
    for (const Parameter& parameter : parameters)
        values[parameter.name] = parameter.standard;
    Problems problems;
    for (const auto& [name, text] : typed) {
        const Result<double> value = read_value(owner, parameters, name, text);
        if (value)
            values[name] = *value;
        else
            problems.push_back(value.problems().front());
    }
    if (!problems.empty())
        return problems;
    return Values(std::move(values));
}

std::string describe(const Parameter& parameter) {
    const std::string range = scene::describe(parameter.limits);
    return parameter.unit.empty() ? range : parameter.unit + ", " + range;
}

Grid grid_of(const std::vector<Parameter>& parameters, const Values& values) {
    Grid with{{{"with"}, {"value"}, {"unit"}}, {}};
    for (const Parameter& parameter : parameters)
        with.rows.push_back({parameter.name, values[parameter.name], parameter.unit});
    return with;
}

} // namespace tumble::sheet
