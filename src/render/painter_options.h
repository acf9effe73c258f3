#pragma once

namespace tumble::render {

/// What a caller with an own surface (a viewer, a test) may leave out of the pictures.
struct PainterOptions {
    bool lettering = true;    // title, time, legend, scale bar, plot
    bool lighting = true;     // false: bodies in the bare colours of the colour map
    double unit = 1;          // pixels: what lines over the bodies go by without lettering (render/layout.h)
    bool skip_hidden = true;  // false: draws spheres that lie behind others too, for the same picture
    bool time_phases = false; // true: waits after each phase of a picture to see how long it took
};

} // namespace tumble::render
