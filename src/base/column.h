#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// What a column of measured numbers tells about the instrument that wrote it.
namespace tumble {

/// Rows from `first` on, `length` of them.
struct Stretch {
    std::size_t first = 0, length = 0;
};

/// The longest run of equal neighbours at the column's largest or smallest value: a clipped signal stays there.
Stretch longest_at_extreme(std::span<const double> column);

/// How many different values there are; counting ends above `enough`.
std::size_t distinct_levels(std::span<const double> column, std::size_t enough);

/// The middle value, of an even number of them the upper of the middle two; 0 for none.
double median(std::vector<double> values);

struct Spread {
    double mean = 0;
    double deviation = 0; // of single values, n - 1; 0 of one
};
Spread spread_of(std::span<const double> values);

} // namespace tumble
