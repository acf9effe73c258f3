#pragma once

#include "render/bare.h"
#include "render/pen.h"

#include <cstdint>
#include <vector>

namespace tumble::render {

/// Rows from the top, four bytes a pixel: red, green, blue in sRGB, and opacity, which is 255 in finished pictures.
struct Picture {
    int width = 0;  // pixels
    int height = 0; // pixels
    std::vector<std::uint8_t> rgba;
    double dots_per_metre = 0;      // of paper; 0: nobody said
    std::vector<Crowded> crowded{}; // numbers and units on it that are cut
    Bare bare = Bare::no;
};

} // namespace tumble::render
