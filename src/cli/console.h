#pragma once

#include "base/problem.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

/// Everything that reaches the terminal goes through here: results to stdout, the rest to stderr.
namespace tumble::cli {

/// Colours are used on a terminal unless NO_COLOR is set (no-color.org) or TERM is dumb.
bool stderr_is_terminal();
bool stderr_takes_color();

/// To stdout, with a line end.
void say(std::string_view text);
void say_json(const nlohmann::ordered_json& json);

/// While one lives nothing is said on stdout: for a command that runs others.
class SilentOutput {
public:
    SilentOutput();
    SilentOutput(const SilentOutput&) = delete;
    SilentOutput& operator=(const SilentOutput&) = delete;
    ~SilentOutput();
};

/// To stderr, with a line end.
void note(std::string_view text);

/// Problems to stderr; with `json` also as {"problems": [...]} to stdout. Returns `code`.
int refuse(const Problems& problems, bool json, int code);

/// Rows of cells as columns, two blanks apart; the last column is not padded.
std::string table(const std::vector<std::vector<std::string>>& rows);

/// "1 body", "12 bodies".
std::string counted(long long number, std::string_view one, std::string_view many);

/// "3.2 s", "4 min 10 s", "2 h 5 min", "385 days", "12 years".
std::string duration(double seconds);

} // namespace tumble::cli
