#pragma once

#include "base/problem.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Words and numbers as people type them. Nothing here depends on the locale.
namespace tumble {

/// Without the blanks (space, tab, CR, LF) at both ends.
std::string_view trimmed(std::string_view text);

/// For a message: at most `longest` bytes with "..." behind what is cut, control characters as '?'.
std::string excerpt(std::string_view text, std::size_t longest = 60);

/// The pieces between separators, empty ones included: n separators give n + 1 pieces.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The pieces between runs of blanks, never empty.
std::vector<std::string_view> split_words(std::string_view text);

/// Typing mistakes between two words: letters added, lost or changed, neighbours swapped (Damerau 1964, each stretch of
/// the word edited once). Bytes are compared, case counts.
std::size_t typing_distance(std::string_view a, std::string_view b);

/// The candidate that was probably meant, the first of equally near ones; none when every candidate is more than a
/// third of the word's length (at least one mistake) away.
std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'friction'?", or nothing when no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// The whole text as a finite number, written as C writes decimal numbers ("1", "-.5", "+2.5e-3"); blanks around it are
/// already too much. The problem's column is where reading stopped, counted from 1; its file and line are the caller's.
Result<double> parse_number(std::string_view text);

/// The whole text as a whole number that fits 64 bits. Problems as in parse_number.
Result<std::int64_t> parse_integer(std::string_view text);

/// The shortest decimal form that reads back to the same bits.
std::string shortest(double value);

/// So many digits behind the point; a value that rounds to 0 has no sign: "0.000", never "-0.000".
std::string fixed(double value, int digits);

/// "40.34 us", "10.7 kN", "4.675 g": the value in its SI unit, with a prefix from p to T and at most `digits`
/// significant digits. Compound units and those that take no prefix ("kg/m3", "m2", "deg", "%", "") stay as they are.
std::string format_si(double value, std::string_view unit, int digits = 4);

} // namespace tumble
