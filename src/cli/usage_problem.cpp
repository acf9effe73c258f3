#include "cli/usage_problem.h"

#include "base/text.h"

#include <fmt/format.h>

namespace tumble::cli {

namespace {

/// The option that CLI11's sentence begins with or names first.
const CLI::Option* option_in(const std::string& sentence, const CLI::App& command) {
    const CLI::Option* found = nullptr;
    std::size_t first = std::string::npos, length = 0;
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        const std::size_t at = sentence.find(name);
        if (at == std::string::npos || at > first || (at == first && name.size() <= length))
            continue;
        found = option;
        first = at;
        length = name.size();
    }
    return found;
}

std::string behind(const std::string& sentence, const std::string& words) {
    const std::size_t at = sentence.find(words);
    return at == std::string::npos ? "" : sentence.substr(at + words.size());
}

/// "tumble list measures" of a help that begins with "Example: tumble list measures".
std::string example_in(const std::string& help) {
    const std::string line = help.substr(0, help.find('\n'));
    return behind(line, "Example: ");
}

std::string what_is_wrong(const CLI::ParseError& error, const CLI::App& command, const std::string& words) {
    const std::string sentence = error.what(), kind = error.get_name();
    const CLI::Option* option = option_in(sentence, command);
    if (!option)
        return sentence;
    const std::string name = option->get_name();
    if (kind == "RequiredError")
        return fmt::format("`{}` needs {}: {}", words, name, option->get_description());
    if (kind == "ExcludesError")
        return fmt::format("{} and {} do not go together", name, behind(sentence, " excludes "));
    if (kind == "RequiresError")
        return fmt::format("{} goes only with {}", name, behind(sentence, " requires "));
    if (kind == "ArgumentMismatch")
        return name + (sentence.find("At Most") == std::string::npos ? " lacks a value" : " has too many values");
    if (kind == "ConversionError") {
        const std::string value = behind(sentence, " = ");
        return value.empty() ? name + " takes no value"
                             : fmt::format("{}: '{}' cannot be read as {}", name, excerpt(value),
                                           option->get_expected_max() > 1 ? "numbers" : "a number");
    }
    return sentence; // of checks, whose words are the program's own
}

} // namespace

Problem usage_problem(const CLI::ParseError& error, const CLI::App& command, const std::string& words) {
    const std::string example = example_in(command.get_description());
    return {.what = what_is_wrong(error, command, words),
            .fix = (example.empty() ? "" : fmt::format("for example `{}`; ", example)) +
                   fmt::format("`{} --help` shows how it is meant", words)};
}

} // namespace tumble::cli
