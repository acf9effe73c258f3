#pragma once

namespace tumble::render {

/// A rectangle of the picture in pixels; x grows to the right, y downwards, pixel centres lie at halves.
struct Area {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
};

} // namespace tumble::render
