#include "cli/time_range.h"

#include "base/text.h"
#include "run/replay.h"

#include <fmt/format.h>

namespace tumble::cli {

namespace {

/// "; the frames of out/drop go from 0 to 2 s", where there are some.
std::string frames_in_words(const std::filesystem::path& run) {
    if (run.empty())
        return "";
    const auto recording = run::open_recording(run, {}, run::Reading::heads);
    if (!recording)
        return "";
    return fmt::format("; the frames of {} go from {:.6g} to {:.6g} s", run.string(), recording->frames.front().time,
                       recording->frames.back().time);
}

} // namespace

std::optional<Problem> read_time_range(const std::string& text, double& from, double& to,
                                       const std::filesystem::path& run) {
    if (text.empty())
        return std::nullopt;
    const auto wrong = [&](const std::string& what) {
        return Problem{.what = fmt::format("--time {} {}", excerpt(text), what),
                       .fix = "write FROM:TO in seconds, such as 0.5:1.5, or 0.5: or :1.5" + frames_in_words(run)};
    };
    const auto parts = split(text, ':');
    if (parts.size() != 2)
        return wrong("is no stretch of time");
    for (auto [part, value] : {std::pair{parts[0], &from}, std::pair{parts[1], &to}}) {
        if (trimmed(part).empty())
            continue;
        const Result<double> number = parse_number(trimmed(part));
        if (!number)
            return wrong("is no stretch of time");
        *value = *number;
    }
    if (from > to)
        return wrong("ends before it begins");
    return std::nullopt;
}

} // namespace tumble::cli
