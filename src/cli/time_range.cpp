#include "cli/time_range.h"

#include "base/text.h"

namespace tumble::cli {

std::optional<Problem> read_time_range(const std::string& text, double& from, double& to) {
    if (text.empty())
        return std::nullopt;
    const Problem wrong{.what = "'" + text + "' is no stretch of time",
                        .fix = "write --time FROM:TO in seconds, such as 0.5:1.5, 0.5: or :1.5"};
    const auto parts = split(text, ':');
    if (parts.size() != 2)
        return wrong;
    for (auto [part, value] : {std::pair{parts[0], &from}, std::pair{parts[1], &to}}) {
        if (part.empty())
            continue;
        const Result<double> number = parse_number(part);
        if (!number)
            return wrong;
        *value = *number;
    }
    if (from > to)
        return wrong;
    return std::nullopt;
}

} // namespace tumble::cli
