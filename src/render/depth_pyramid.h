#pragma once

#include "render/camera.h"
#include "render/sphere_list.h"

#include <vector>

namespace tumble::render {

/// The depth of what has been drawn, in blocks of 1, 2, 4 ... pixels a side, each block with its farthest depth: tells
/// cheaply that a sphere would lie behind it all (after Greene, Kass, Miller 1993, Hierarchical Z-buffer visibility).
class DepthPyramid {
public:
    /// depth: rows from the bottom as glReadPixels gives them, 0 near to 1 far, width * height values.
    DepthPyramid(std::vector<float> depth, int width, int height);

    /// True when everything in the pixel rectangle (bottom up, clipped to the picture) is nearer than `depth`.
    [[nodiscard]] bool hides(double left, double bottom, double right, double top, double depth) const;

private:
    struct Level {
        int width = 0;
        int height = 0;
        std::vector<float> farthest;
    };
    std::vector<Level> levels_;
};

/// Which spheres of a picture of that height (pixels) are hidden by what the pyramid was built from. Never true for a
/// sphere that any pixel centre would see.
[[nodiscard]] bool is_hidden(const SphereMark& mark, const Camera& camera, int height, const DepthPyramid& pyramid);

} // namespace tumble::render
