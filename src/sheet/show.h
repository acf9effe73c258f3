#pragma once

#include "sheet/sheet.h"

#include <nlohmann/json.hpp>
#include <string>

/// A sheet in the forms in which it leaves the program.
namespace tumble::sheet {

constexpr std::size_t text_width = 96; // columns of the terminal it is written for

/// For a terminal; a grid that is wider than 120 letters goes on below itself. Figures are named by title and curves.
std::string to_text(const std::string& title, const Sheet& sheet);

/// Markdown; figures are links to NAME.svg in that folder. A sheet is its parts, an empty line before each.
std::string to_page(const Part& part, const std::string& folder);
std::string to_page(const Sheet& sheet, const std::string& folder);

/// {"facts": ..., "parts": ...}
nlohmann::ordered_json to_json(const Sheet& sheet);

/// For Markdown: names like k_n and signs like * are meant as they stand. In prose what stands in `code` is left alone.
std::string escaped(const std::string& text);
std::string prose(const std::string& text);

/// Lines of at most `width` letters, each ended by a newline; no word is broken.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent = "");

/// Letters shown, not bytes.
std::size_t letters(const std::string& text);

/// "overlap, um".
std::string head_of(const Column& column);

/// The cells as they are shown.
std::vector<std::vector<std::string>> cells_of(const Grid& grid);

} // namespace tumble::sheet
