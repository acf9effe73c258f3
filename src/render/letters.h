#pragma once

#include <string>

namespace tumble::render {

/// The family that drawings are lettered in.
constexpr const char* letter_family = "DejaVu Sans";

/// How wide a text gets in letters of size 1 of that family, or of what the system has in its place.
double width_of_letters(const std::string& text);

} // namespace tumble::render
