#pragma once

#include "lesson/lesson.h"
#include "sheet/show.h"

#include <nlohmann/json.hpp>
#include <string>

/// A walk in the forms in which it leaves the program.
namespace tumble::lesson {

/// For a terminal; the answer is not told.
std::string to_text(const Lesson& lesson, const Values& values, const Walk& walk);

/// A Markdown page. Figures are links to NAME.svg in a folder named after the lesson; the answer stands at the end.
std::string to_page(const Lesson& lesson, const Values& values, const Walk& walk);

/// The page that leads to the others.
std::string contents_page();

nlohmann::ordered_json to_json(const Lesson& lesson, const Values& values, const Walk& walk);

} // namespace tumble::lesson
