#pragma once

#include "render/ticks.h"

#include <optional>
#include <vector>

namespace tumble::render {

// m/s and the like: anything slower is numerical noise of a bulk at rest. Forces have no such floor.
constexpr double slowest = 1e-9;

/// The range of the colour scale over a row of frames. A fixed range stays. An automatic one reaches to the 98th
/// percentile of the absolute values, rounded up to 1, 2, 2.5 or 5 times a power of ten, so that a few fast bodies do
/// not take the colours from the others; it starts at 0, or is symmetric about 0 for a quantity with a sign.
class ColorRange {
public:
    /// `least` is what values must exceed to count as more than the numerical noise of a bulk at rest.
    ColorRange(std::optional<Span> fixed, bool has_sign, double least = slowest)
        : fixed_(fixed), has_sign_(has_sign), least_(least) {}

    /// The range for the next frame. To keep colours comparable it grows at once but shrinks only after 25 frames in a
    /// row that used less than a third of it. Values that are not finite are passed over; without motion it is unit 1.
    /// A frame of the same time (s) as the one before is that one seen again and counts no more; without a time each
    /// counts.
    Span next(std::vector<double> values, std::optional<double> time = {});

private:
    std::optional<Span> fixed_;
    bool has_sign_ = false;
    double least_ = slowest;
    std::optional<double> time_; // s, of the last frame
    double reach_ = 0;
    double wanted_since_ = 0; // largest reach asked for during the quiet frames
    int quiet_frames_ = 0;
};

/// One range for many frames: the widest of those that the automatic one of each would have, in any order.
class WidestRange {
public:
    explicit WidestRange(double least = slowest) : least_(least) {}
    void take_in(std::vector<double> values);
    /// Of all that were taken in; without motion in any it is unit 1.
    [[nodiscard]] Span span(bool has_sign) const;

private:
    double least_;
    double reach_ = 0;
};

} // namespace tumble::render
