#include "render/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <string_view>

namespace tumble::render {

constexpr double slack = 1e-9;

double round_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 2.5, 5.0}) {
        if (step * power >= value * (1 - slack)) {
            return step * power;
        }
    }
    return 10 * power;
}

double round_down(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value) + slack));
    for (const double step : {5.0, 2.0}) {
        if (step * power <= value * (1 + slack)) {
            return step * power;
        }
    }
    return power;
}

static double ticks_count(const Span& span, double step) {
    return std::floor(span.hi / step + slack) - std::ceil(span.lo / step - slack) + 1;
}

static bool meets_both_ends(const Span& span, double step) {
    const auto whole = [&](double v) { return std::abs(v / step - std::round(v / step)) < 1e-6; };
    return whole(span.lo) && whole(span.hi);
}

std::vector<double> ticks_in(const Span& span, int most) {
    const double width = span.hi - span.lo;
    if (!(width > 0) || !std::isfinite(width)) {
        return {};
    }
    const int limit = std::max(most, 2);
    double finest = round_up(width / limit);
    while (ticks_count(span, finest) > limit) {
        finest = round_up(finest * 1.01);
    }
    double step = finest;
    for (int i = 0; i < 3 && !meets_both_ends(span, step); ++i) {
        step = round_up(step * 1.01);
    }
    if (!meets_both_ends(span, step) || ticks_count(span, step) < std::min(3, limit)) {
        step = finest;
    }
    while (ticks_count(span, step) < 2) { // one number is no scale
        step = round_up(0.5 * step);
    }
    std::vector<double> ticks;
    const double last = std::floor(span.hi / step + slack);
    for (double n = std::ceil(span.lo / step - slack); n <= last; n += 1) {
        ticks.push_back(n == 0 ? 0.0 : n * step);
    }
    if (ticks.size() > static_cast<std::size_t>(limit)) { // three of the finer step, where two are the most
        ticks = {ticks.front(), ticks.back()};
    }
    return ticks;
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks) {
    double step = 0;
    double largest = 0;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        largest = std::max(largest, std::abs(ticks[i]));
        if (i > 0) {
            step = ticks[1] - ticks[0];
        }
    }
    step = step > 0 ? step : std::max(largest, 1.0);
    const auto needs_more = [&](int digits) {
        const double power = std::pow(10, digits);
        const auto has_rest = [&](double value) {
            return std::abs(value * power - std::round(value * power)) > 1e-6 * step * power;
        };
        return has_rest(step) || std::any_of(ticks.begin(), ticks.end(), has_rest);
    };
    int digits = 0;
    while (digits < 12 && needs_more(digits)) {
        ++digits;
    }
    std::vector<std::string> labels;
    for (const double tick : ticks) {
        labels.push_back((tick < 0 ? "\u2212" : "") + fmt::format("{:.{}f}", std::abs(tick), digits));
    }
    return labels;
}

static bool takes_prefix(std::string_view unit) {
    constexpr std::array<std::string_view, 8> units{"m/s", "J", "N", "W", "m", "Pa", "s", "Hz"};
    return std::find(units.begin(), units.end(), unit) != units.end();
}

DisplayUnit display_unit(const std::string& unit, const Span& span) {
    const double largest = std::max(std::abs(span.lo), std::abs(span.hi));
    if (!(largest > 0) || !std::isfinite(largest)) {
        return {unit, 1};
    }
    // A scale up to 0.1 is easier to read as one up to 100 with a prefix; one up to 0.5 stays.
    const int thousands = static_cast<int>(std::floor((std::log10(largest) + slack) / 3 + 0.3));
    if (thousands == 0) {
        return {unit, 1};
    }
    if (takes_prefix(unit) && thousands >= -3 && thousands <= 3) {
        constexpr std::array<const char*, 7> prefixes{"n", "\u00b5", "m", "", "k", "M", "G"};
        return {prefixes[static_cast<std::size_t>(thousands + 3)] + unit, std::pow(10.0, -3 * thousands)};
    }
    std::string power = thousands < 0 ? "\u207b" : "";
    for (const char digit : std::to_string(std::abs(3 * thousands))) {
        constexpr std::array<const char*, 10> raised{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                     "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
        power += raised[static_cast<std::size_t>(digit - '0')];
    }
    return {"10" + power + (unit.empty() ? "" : " ") + unit, std::pow(10.0, -3 * thousands)};
}

} // namespace tumble::render
