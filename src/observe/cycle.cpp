#include "observe/cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::observe {

namespace {

struct Point {
    double time = 0, value = 0;
    bool top = false;
};

/// Tops and bottoms in turn; the first and the last extreme, whose approach or return was not seen, are left out.
std::vector<Point> turning_points(const std::vector<Point>& signal, double step) {
    std::vector<Point> found;
    if (signal.empty())
        return found;
    Point high = signal.front(), low = signal.front();
    int way = 0; // 1 rising, -1 falling, 0 not known yet
    for (const Point& now : signal) {
        if (now.value > high.value)
            high = now;
        if (now.value < low.value)
            low = now;
        if (way >= 0 && high.value - now.value >= step) {
            if (way > 0)
                found.push_back({high.time, high.value, true});
            way = -1;
            low = now;
        } else if (way <= 0 && now.value - low.value >= step) {
            if (way < 0)
                found.push_back({low.time, low.value, false});
            way = 1;
            high = now;
        }
    }
    return found;
}

} // namespace

double quantile(std::vector<double> values, double share) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double at = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

Cycle find_cycle(std::span<const double> times, std::span<const double> values, double threshold) {
    std::vector<Point> signal;
    std::vector<double> finite;
    for (std::size_t i = 0; i < std::min(times.size(), values.size()); ++i)
        if (std::isfinite(values[i])) {
            signal.push_back({times[i], values[i], false});
            finite.push_back(values[i]);
        }
    Cycle cycle;
    cycle.lowest = quantile(finite, 0);
    cycle.highest = quantile(finite, 1);
    const double span = quantile(finite, 0.95) - quantile(finite, 0.05);
    std::vector<Point> points;
    if (span > 0)
        points = turning_points(signal, threshold * span);
    std::vector<double> heights, periods;
    for (std::size_t i = 0; i < points.size(); ++i) {
        (points[i].top ? cycle.tops : cycle.bottoms).push_back(points[i].time);
        if (i >= 1)
            heights.push_back(std::abs(points[i].value - points[i - 1].value));
        if (i >= 2)
            periods.push_back(points[i].time - points[i - 2].time);
    }
    cycle.cycles = 0.5 * static_cast<double>(heights.size());
    cycle.period = quantile(std::move(periods), 0.5);
    cycle.peak_to_peak = quantile(std::move(heights), 0.5);
    return cycle;
}

} // namespace tumble::observe
