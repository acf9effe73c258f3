#pragma once

#include "lesson/lesson.h"

#include <nlohmann/json.hpp>
#include <string>

/// A walk in the forms in which it leaves the program.
namespace tumble::lesson {

/// For a terminal of 96 columns. Figures are named by title and curves; the answer is not told.
std::string to_text(const Lesson& lesson, const Values& values, const Walk& walk);

/// A Markdown page. Figures are links to NAME.svg in a folder named after the lesson; the answer stands at the end.
std::string to_page(const Lesson& lesson, const Values& values, const Walk& walk);

/// The page that leads to the others.
std::string contents_page();

nlohmann::ordered_json to_json(const Lesson& lesson, const Values& values, const Walk& walk);

/// Lines of at most `width` letters, each ended by a newline; no word is broken.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent = "");

/// Letters shown, not bytes.
std::size_t letters(const std::string& text);

/// "overlap, um".
std::string head_of(const Column& column);
std::string head_of(const Axis& axis);

/// The cells as they are shown.
std::vector<std::vector<std::string>> cells_of(const Grid& grid);

} // namespace tumble::lesson
