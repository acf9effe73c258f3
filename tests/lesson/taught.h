#pragma once

#include "lesson/lesson.h"

#include <doctest/doctest.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tumble::lesson::testing {

using Typed = std::vector<std::pair<std::string, std::string>>;

/// The walk of a lesson with these flags, taught once however many tests look at it.
inline const Walk& taught(const std::string& name, const Typed& typed = {}) {
    static std::map<std::pair<std::string, Typed>, Walk> walks;
    if (const auto known = walks.find({name, typed}); known != walks.end())
        return known->second;
    const auto lesson = find_lesson(name);
    REQUIRE_MESSAGE(lesson.ok(), to_string(lesson.problems()));
    const auto values = read_values(**lesson, typed);
    REQUIRE_MESSAGE(values.ok(), to_string(values.problems()));
    auto walk = (*lesson)->teach(*values);
    REQUIRE_MESSAGE(walk.ok(), to_string(walk.problems()));
    return walks.emplace(std::pair(name, typed), std::move(*walk)).first->second;
}

} // namespace tumble::lesson::testing
