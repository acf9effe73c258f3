#pragma once

#include <string>
#include <vector>

namespace tumble::render {

/// Lowest and highest value of a scale, in the same unit.
struct Span {
    double lo = 0;
    double hi = 1;

    friend bool operator==(const Span&, const Span&) = default;
};

/// The smallest 1, 2, 2.5 or 5 times a power of ten that is not below a positive value (within 1e-9 of it).
double round_up(double value);

/// The largest 1, 2 or 5 times a power of ten that is not above a positive value (within 1e-9 of it).
double round_down(double value);

/// Multiples of a round step inside the span, at most `most` of them and never fewer than two: one number is no scale.
/// A coarser step that meets both ends of the span is taken before a finer one that does not.
std::vector<double> ticks_in(const Span& span, int most);

/// The ticks as numbers with just the digits that their step needs; a true minus sign.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

/// How a scale is written: values times `factor` are in `unit`.
struct DisplayUnit {
    std::string unit;
    double factor = 1;
};

/// A prefix (n, µ, m, k, M, G) for units that take one, so that the scale's numbers have few zeros; a power of ten in
/// front of the unit for the others.
DisplayUnit display_unit(const std::string& unit, const Span& span);

} // namespace tumble::render
