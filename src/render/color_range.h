#pragma once

#include "render/ticks.h"

#include <optional>
#include <vector>

namespace tumble::render {

/// The range of the colour scale over a row of frames. A fixed range stays. An automatic one reaches to the 98th
/// percentile of the absolute values, rounded up to 1, 2, 2.5 or 5 times a power of ten, so that a few fast bodies do
/// not take the colours from the others; it starts at 0, or is symmetric about 0 for a quantity with a sign.
class ColorRange {
public:
    ColorRange(std::optional<Span> fixed, bool has_sign) : fixed_(fixed), has_sign_(has_sign) {}

    /// The range for the next frame. To keep colours comparable it grows at once but shrinks only after 25 frames in a
    /// row that used less than a third of it. Values that are not finite are passed over; without motion it is unit 1.
    Span next(std::vector<double> values);

private:
    std::optional<Span> fixed_;
    bool has_sign_ = false;
    double reach_ = 0;
    double wanted_since_ = 0; // largest reach asked for during the quiet frames
    int quiet_frames_ = 0;
};

/// One range for many frames: the widest of those that the automatic one of each would have, in any order.
class WidestRange {
public:
    void take_in(std::vector<double> values);
    /// Of all that were taken in; without motion in any it is unit 1.
    [[nodiscard]] Span span(bool has_sign) const;

private:
    double reach_ = 0;
};

} // namespace tumble::render
