#pragma once

#include "base/problem.h"
#include "lesson/walk.h"
#include "scene/keys.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Lessons of the discrete element method: each runs the solvers and laws themselves and holds them against theory.
namespace tumble::lesson {

/// A number that a student may change; becomes the flag --name.
struct Parameter {
    std::string name; // its unit stands in it
    std::string unit; // for sentences; empty: none
    double standard = 0;
    scene::Limits limits;
    std::string sentence;
};

/// A value for every parameter of a lesson, by name and in the parameter's unit.
class Values {
public:
    explicit Values(std::map<std::string, double, std::less<>> values) : values_(std::move(values)) {}
    double operator[](std::string_view name) const { return values_.find(name)->second; }
    [[nodiscard]] const std::map<std::string, double, std::less<>>& all() const { return values_; }

private:
    std::map<std::string, double, std::less<>> values_;
};

struct Lesson {
    std::string name;
    std::string title;
    std::vector<Parameter> parameters;
    /// Takes a few seconds at most. Problems: values that each are in range but together make no lesson.
    Result<Walk> (*teach)(const Values&) = nullptr;
};

/// In the order in which they build on each other.
const std::vector<Lesson>& all_lessons();

/// Problem: there is no lesson of that name; says which one is near.
Result<const Lesson*> find_lesson(std::string_view name);

/// The defaults with what was typed put in, (name, number) pairs. Problems, one per pair that is wrong: no such
/// parameter, not a number, out of its range.
Result<Values> read_values(const Lesson& lesson, const std::vector<std::pair<std::string, std::string>>& typed = {});

/// "N/m, above 0, at most 1e+06": what a parameter may be.
std::string describe(const Parameter& parameter);

} // namespace tumble::lesson
