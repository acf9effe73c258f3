#pragma once

#include "lesson/lesson.h"

#include <doctest/doctest.h>
#include <string>
#include <utility>
#include <vector>

namespace tumble::lesson::testing {

using Typed = std::vector<std::pair<std::string, std::string>>;

/// The walk of a lesson with these flags.
inline Walk taught(const std::string& name, const Typed& typed = {}) {
    const auto lesson = find_lesson(name);
    REQUIRE_MESSAGE(lesson.ok(), to_string(lesson.problems()));
    const auto values = read_values(**lesson, typed);
    REQUIRE_MESSAGE(values.ok(), to_string(values.problems()));
    auto walk = (*lesson)->teach(*values);
    REQUIRE_MESSAGE(walk.ok(), to_string(walk.problems()));
    return std::move(*walk);
}

} // namespace tumble::lesson::testing
