#include "base/column.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tumble {

Stretch longest_at_extreme(std::span<const double> column) {
    Stretch longest;
    if (column.empty())
        return longest;
    const auto [lowest, highest] = std::minmax_element(column.begin(), column.end());
    for (std::size_t k = 0; k < column.size();) {
        std::size_t end = k + 1;
        while (end < column.size() && column[end] == column[k])
            ++end;
        if ((column[k] == *lowest || column[k] == *highest) && end - k > longest.length)
            longest = {k, end - k};
        k = end;
    }
    return longest;
}

std::size_t distinct_levels(std::span<const double> column, std::size_t enough) {
    std::set<double> levels;
    for (const double value : column)
        if (levels.insert(value).second && levels.size() > enough)
            break;
    return levels.size();
}

double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Spread spread_of(std::span<const double> values) {
    Spread spread;
    const auto n = static_cast<double>(values.size());
    for (const double value : values)
        spread.mean += value / n;
    for (const double value : values)
        spread.deviation += (value - spread.mean) * (value - spread.mean);
    spread.deviation = values.size() > 1 ? std::sqrt(spread.deviation / (n - 1)) : 0;
    return spread;
}

} // namespace tumble
