#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// A reader of a file gives up after so many problems.
constexpr std::size_t most_problems = 20;

/// A piece of a line; its column counts from 1.
struct Field {
    std::string_view text;
    int column = 1;
};

struct Line {
    std::string_view text; // without its end, CR LF included
    int number = 1;
};

/// Walks through text line by line without copying it.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}
    /// False at the end.
    bool next(Line& line);

private:
    std::string_view text_;
    std::size_t at_ = 0;
    int number_ = 0;
};

/// The line up to a '#'.
std::string_view without_comment(std::string_view line);
/// Pieces between commas, blanks around them taken off.
std::vector<Field> comma_fields(std::string_view line);
/// Pieces between runs of blanks.
std::vector<Field> blank_fields(std::string_view line);

} // namespace tumble::scene
