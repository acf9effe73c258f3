#include "base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <system_error>

namespace tumble {
namespace {

constexpr std::string_view blanks = " \t\r\n";

Problem number_problem(std::size_t position, std::string what, std::string fix) {
    Problem problem;
    problem.column = static_cast<int>(position) + 1;
    problem.what = std::move(what);
    problem.fix = std::move(fix);
    return problem;
}

/// from_chars takes no plus sign; a sign after the plus stays an error.
std::size_t digits_start(std::string_view text) {
    return text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
}

template <class Number>
Result<Number> parse_whole(std::string_view text, std::string_view kind, std::string_view example) {
    const std::size_t start = digits_start(text);
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + start, end, value);
    const auto position = static_cast<std::size_t>(stop - text.data());
    std::string fix = fmt::format("write {}", example);
    if (text.empty())
        return number_problem(0, fmt::format("nothing where {} is expected", kind), std::move(fix));
    const std::string shown = excerpt(text);
    if (error == std::errc::result_out_of_range)
        return number_problem(0, fmt::format("'{}' is outside the range of {}", shown, kind), std::move(fix));
    if (error != std::errc{})
        return number_problem(0, fmt::format("'{}' is not {}", shown, kind), std::move(fix));
    if (stop != end)
        return number_problem(
            position,
            fmt::format("'{}' is not {}: it stops being one at '{}'", shown, kind, excerpt(text.substr(position))),
            std::move(fix));
    return value;
}

bool takes_prefix(std::string_view unit) {
    constexpr std::array<std::string_view, 9> prefixed{"m", "g", "s", "N", "Pa", "J", "W", "Hz", "rad"};
    return std::find(prefixed.begin(), prefixed.end(), unit) != prefixed.end();
}

} // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string excerpt(std::string_view text, std::size_t longest) {
    std::string shown(text.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
    return text.size() > longest ? shown + "..." : shown;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    for (std::size_t start = 0;;) {
        const std::size_t end = text.find(separator, start);
        pieces.push_back(text.substr(start, end - start));
        if (end == std::string_view::npos)
            return pieces;
        start = end + 1;
    }
}

std::vector<std::string_view> split_words(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t start = text.find_first_not_of(blanks); start != std::string_view::npos;) {
        const std::size_t end = text.find_first_of(blanks, start);
        words.push_back(text.substr(start, end - start));
        start = text.find_first_not_of(blanks, end);
    }
    return words;
}

std::size_t typing_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        now[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last.swap(last);
        last.swap(now);
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before_last[j - 2] + 1);
        }
    }
    return now[b.size()];
}

std::optional<std::string> nearest_word(std::string_view word, std::span<const std::string> candidates) {
    // Words longer than any key are noise, and comparing them would take their length squared.
    constexpr std::size_t longest_word = 200;
    if (word.size() > longest_word)
        return std::nullopt;
    std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
    std::optional<std::string> nearest;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > word.size() + allowed || candidate.size() + allowed < word.size())
            continue;
        const std::size_t distance = typing_distance(word, candidate);
        if (distance < allowed || (distance == allowed && !nearest)) {
            nearest = candidate;
            allowed = distance;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    const auto nearest = nearest_word(word, candidates);
    return nearest ? fmt::format("did you mean '{}'?", *nearest) : std::string{};
}

Result<double> parse_number(std::string_view text) {
    constexpr std::string_view kind = "a number", example = "a decimal number such as 12, -0.5 or 2.5e-3";
    auto number = parse_whole<double>(text, kind, example);
    if (number && !std::isfinite(*number))
        return number_problem(0, fmt::format("'{}' is not a finite number", text), fmt::format("write {}", example));
    return number;
}

Result<std::int64_t> parse_integer(std::string_view text) {
    return parse_whole<std::int64_t>(text, "a whole number", "a whole number such as 12 or -3");
}

std::string shortest(double value) {
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), end};
}

std::string fixed(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text[0] == '-' ? text.substr(1) : text;
}

std::string format_si(double value, std::string_view unit, int digits) {
    value += 0.0; // of -0 makes 0
    if (unit == "kg") {
        if (std::abs(value) < 1 && value != 0)
            return format_si(value * 1e3, "g", digits);
    } else if (takes_prefix(unit) && std::isfinite(value) && value != 0) {
        constexpr std::string_view prefixes = "pnum kMGT"; // the blank is 10^0
        // Rounded first: 999.99 um at four digits is 1 mm.
        const double rounded = *parse_number(fmt::format("{:.{}e}", value, digits - 1));
        const int exponent = static_cast<int>(std::floor(std::log10(std::abs(rounded)) / 3 + 1e-12));
        const int step = std::clamp(exponent, -4, 4);
        const char prefix = prefixes[static_cast<std::size_t>(step + 4)];
        return fmt::format("{:.{}g} {}{}", rounded / std::pow(10.0, 3 * step), digits,
                           prefix == ' ' ? std::string{} : std::string(1, prefix), unit);
    }
    return unit.empty() ? fmt::format("{:.{}g}", value, digits) : fmt::format("{:.{}g} {}", value, digits, unit);
}

} // namespace tumble
