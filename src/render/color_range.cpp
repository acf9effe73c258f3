#include "render/color_range.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {

constexpr double percentile = 0.98;
constexpr int patience = 25; // frames

static double robust_reach(std::vector<double>& values, double least) {
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    if (values.empty()) {
        return 0;
    }
    std::transform(values.begin(), values.end(), values.begin(), [](double v) { return std::abs(v); });
    const auto rank = static_cast<std::ptrdiff_t>(percentile * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    const double reach = values[static_cast<std::size_t>(rank)];
    return reach > least ? round_up(reach) : 0;
}

static Span span_of(double reach, bool has_sign) {
    const double end = reach > 0 ? reach : 1;
    return has_sign ? Span{-end, end} : Span{0, end};
}

Span ColorRange::next(std::vector<double> values, std::optional<double> time) {
    if (fixed_) {
        return *fixed_;
    }
    const bool seen_again = time && time == time_;
    time_ = time;
    const double wanted = robust_reach(values, least_);
    if (wanted > reach_) {
        reach_ = wanted;
    }
    if (3 * wanted < reach_) {
        wanted_since_ = std::max(quiet_frames_ == 0 ? 0.0 : wanted_since_, wanted);
        quiet_frames_ += seen_again ? 0 : 1;
        if (quiet_frames_ >= patience) {
            reach_ = wanted_since_;
            quiet_frames_ = 0;
        }
    } else {
        quiet_frames_ = 0;
    }
    return span_of(reach_, has_sign_);
}

void WidestRange::take_in(std::vector<double> values) {
    reach_ = std::max(reach_, robust_reach(values, least_));
}

Span WidestRange::span(bool has_sign) const {
    return span_of(reach_, has_sign);
}

} // namespace tumble::render
