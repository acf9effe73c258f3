#include "cli/flag_checks.h"

#include "base/ending.h"
#include "base/text.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace tumble::cli {

namespace {

/// `wanted`: "a number above 0"; `mark`: the same for the help, "above 0".
CLI::Validator check(std::function<bool(const std::string&)> fits, const std::string& wanted, const std::string& mark) {
    return {[fits = std::move(fits), wanted](std::string& text) {
                return fits(text) ? std::string() : fmt::format("'{}' is not {}", excerpt(text), wanted);
            },
            mark};
}

} // namespace

CLI::Validator number_from(double lo, double hi) {
    const std::string range = fmt::format("{:g} to {:g}", lo, hi);
    return check(
        [lo, hi](const std::string& text) {
            const auto number = parse_number(text);
            return number && *number >= lo && *number <= hi;
        },
        "a number from " + range, range);
}

CLI::Validator number_above_zero() {
    return check(
        [](const std::string& text) {
            const auto number = parse_number(text);
            return number && *number > 0;
        },
        "a number above 0", "above 0");
}

CLI::Validator whole_number_from(long long lo, long long hi) {
    const std::string range = fmt::format("{} to {}", lo, hi);
    return check(
        [lo, hi](const std::string& text) {
            const auto number = parse_integer(text);
            return number && *number >= lo && *number <= hi;
        },
        "a whole number from " + range, range);
}

CLI::Validator one_of(std::vector<std::string> words) {
    const std::string mark = fmt::format("{}", fmt::join(words, "|"));
    return {[words = std::move(words)](std::string& text) {
                if (std::find(words.begin(), words.end(), text) != words.end())
                    return std::string();
                const std::string guess = did_you_mean(text, words);
                return fmt::format("'{}' is none of {}{}", excerpt(text), fmt::join(words, ", "),
                                   guess.empty() ? "" : "; " + guess);
            },
            mark};
}

CLI::Validator ends_in(std::vector<std::string> endings) {
    const std::string mark = fmt::format("*{}", fmt::join(endings, "|*"));
    return {[endings = std::move(endings)](std::string& text) {
                const std::string own = ending_of(text);
                if (std::find(endings.begin(), endings.end(), own) != endings.end())
                    return std::string();
                return fmt::format("'{}' does not end in {}", excerpt(text), fmt::join(endings, " or "));
            },
            mark};
}

std::string refuse_no_place(const std::string& name) {
    if (name.empty())
        return "an empty name is not a place to write to: give the name of a file or folder";
    return name == "-" ? "'-' is not a place to write to: give the name of a file or folder" : "";
}

std::optional<Problem> refuse_to_overwrite(const std::vector<std::filesystem::path>& files) {
    std::error_code ignored;
    for (const std::filesystem::path& file : files)
        if (std::filesystem::exists(file, ignored))
            return Problem{.file = file.string(),
                           .what = "is there already, and nothing is overwritten",
                           .fix = "--force replaces it; or name another place"};
    return std::nullopt;
}

} // namespace tumble::cli
