#pragma once

#include "base/problem.h"
#include "lesson/walk.h"
#include "sheet/parameter.h"

#include <string>
#include <string_view>
#include <vector>

/// Lessons of the discrete element method: each runs the solvers and laws themselves and holds them against theory.
namespace tumble::lesson {

using sheet::describe;
using sheet::Parameter;
using sheet::Values;

struct Lesson {
    std::string name;
    std::string title;
    std::vector<Parameter> parameters;
    /// Takes some seconds. Problems: values that each are in range but together make no lesson.
    Result<Walk> (*teach)(const Values&) = nullptr;
};

/// In the order in which they build on each other.
const std::vector<Lesson>& all_lessons();

/// Problem: there is no lesson of that name; says which one is near.
Result<const Lesson*> find_lesson(std::string_view name);

/// The defaults with what was typed put in; problems as those of sheet::read_values.
Result<Values> read_values(const Lesson& lesson, const sheet::Typed& typed = {});

} // namespace tumble::lesson
