#pragma once

#include <algorithm>
#include <cmath>

namespace tumble {

/// Width of the cells that fill a box of `length` m along each axis (an Eigen vector): `width` m, or wider, so that
/// there are no more than `room` of them. A width of 0, as a world without bodies asks for, counts as very small.
template <class Lengths> double cell_width_for(const Lengths& length, double width, double room) {
    width = std::max(width, 1e-12);
    while ((length / width).array().floor().max(1).prod() > room)
        width *= 1.26; // halves the number of cubes
    return width;
}

} // namespace tumble
