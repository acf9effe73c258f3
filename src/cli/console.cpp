#include "cli/console.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <unistd.h>

namespace tumble::cli {

namespace {

int silenced = 0;

} // namespace

SilentOutput::SilentOutput() {
    ++silenced;
}

SilentOutput::~SilentOutput() {
    --silenced;
}

bool stderr_is_terminal() {
    return isatty(STDERR_FILENO) == 1;
}

bool stderr_takes_color() {
    const char* no_color = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    const bool refused = (no_color && *no_color) || (terminal && std::string_view(terminal) == "dumb");
    return stderr_is_terminal() && !refused;
}

void say(std::string_view text) {
    if (silenced > 0)
        return;
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
}

void say_json(const nlohmann::ordered_json& json) {
    say(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

void note(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fputc('\n', stderr);
}

int refuse(const Problems& problems, bool json, int code) {
    const bool color = stderr_takes_color();
    for (const Problem& problem : problems)
        note((color ? "\033[31merror:\033[0m " : "error: ") + to_string(problem));
    if (!json)
        return code;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Problem& problem : problems)
        list.push_back({{"file", problem.file},
                        {"line", problem.line},
                        {"column", problem.column},
                        {"key", problem.key},
                        {"what", problem.what},
                        {"fix", problem.fix}});
    say_json(nlohmann::ordered_json{{"problems", list}});
    return code;
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths.resize(std::max(widths.size(), i + 1));
            widths[i] = std::max(widths[i], row[i].size());
        }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += i + 1 < row.size() ? fmt::format("{:<{}}  ", row[i], widths[i]) : row[i];
        line.erase(line.find_last_not_of(' ') + 1);
        text += (text.empty() ? "" : "\n") + line;
    }
    return text;
}

std::string counted(long long number, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string duration(double seconds) {
    if (!(seconds < 1e11))
        return "for ever";
    if (seconds < 60)
        return fmt::format("{:.{}f} s", seconds, seconds < 10 ? 1 : 0);
    const auto whole = static_cast<long long>(seconds + 0.5);
    if (whole < 3600)
        return fmt::format("{} min {} s", whole / 60, whole % 60);
    constexpr long long day = 24 * 3600;
    if (whole < 2 * day)
        return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
    if (whole < 2 * 365 * day)
        return fmt::format("{} days", whole / day);
    return fmt::format("{} years", whole / (365 * day));
}

} // namespace tumble::cli
