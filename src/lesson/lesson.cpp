#include "lesson/lesson.h"

#include "base/text.h"
#include "lesson/each.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::lesson {

namespace {

template <class Named> std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all)
        names.push_back(one.name);
    return names;
}

template <class Named> const Named* find(const std::vector<Named>& all, std::string_view name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
}

Result<double> read_value(const Lesson& lesson, const std::string& name, const std::string& text) {
    const Parameter* parameter = find(lesson.parameters, name);
    if (!parameter)
        return Problem{.key = "--" + name,
                       .what = fmt::format("lesson {} has no parameter '{}'", lesson.name, excerpt(name)),
                       .fix = did_you_mean(name, names_of(lesson.parameters))};
    const Result<double> value = parse_number(text);
    if (!value)
        return Problem{.key = "--" + name,
                       .what = fmt::format("--{} takes a number, not '{}'", name, excerpt(text)),
                       .fix = describe(*parameter)};
    if (!parameter->limits.hold(*value))
        return Problem{.key = "--" + name,
                       .what = fmt::format("--{} is {}, out of its range", name, scene::plain(*value)),
                       .fix = describe(*parameter)};
    return *value;
}

} // namespace

const std::vector<Lesson>& all_lessons() {
    static const std::vector<Lesson> lessons{two_discs(), force_law(), time_step(), restitution(),  energy(),
                                             friction(),  clumps(),    repose(),    soft_and_hard()};
    return lessons;
}

Result<const Lesson*> find_lesson(std::string_view name) {
    if (const Lesson* lesson = find(all_lessons(), name))
        return lesson;
    const std::string guess = did_you_mean(name, names_of(all_lessons()));
    return Problem{.what = fmt::format("there is no lesson '{}'", excerpt(name)),
                   .fix = (guess.empty() ? "" : guess + " ") + "`tumble lesson` lists all there are"};
}

Result<Values> read_values(const Lesson& lesson, const std::vector<std::pair<std::string, std::string>>& typed) {
    std::map<std::string, double, std::less<>> values;
    for (const Parameter& parameter : lesson.parameters)
        values[parameter.name] = parameter.standard;
    Problems problems;
    for (const auto& [name, text] : typed) {
        const Result<double> value = read_value(lesson, name, text);
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

} // namespace tumble::lesson
