#include "render/depth_pyramid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble::render {

static std::size_t at(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

DepthPyramid::DepthPyramid(std::vector<float> depth, int width, int height) {
    levels_.push_back({width, height, std::move(depth)});
    while (levels_.back().width > 4 || levels_.back().height > 4) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.farthest.resize(at(0, coarse.height, coarse.width));
        for (int y = 0; y < coarse.height; ++y) {
            const int above = std::min(2 * y + 1, fine.height - 1);
            for (int x = 0; x < coarse.width; ++x) {
                const int beside = std::min(2 * x + 1, fine.width - 1);
                const auto& f = fine.farthest;
                coarse.farthest[at(x, y, coarse.width)] =
                    std::max(std::max(f[at(2 * x, 2 * y, fine.width)], f[at(beside, 2 * y, fine.width)]),
                             std::max(f[at(2 * x, above, fine.width)], f[at(beside, above, fine.width)]));
            }
        }
        levels_.push_back(std::move(coarse));
    }
}

bool DepthPyramid::hides(double left, double bottom, double right, double top, double depth) const {
    const Level& finest = levels_.front();
    const int x0 = std::clamp(static_cast<int>(std::floor(left)), 0, finest.width - 1);
    const int x1 = std::clamp(static_cast<int>(std::floor(right)), 0, finest.width - 1);
    const int y0 = std::clamp(static_cast<int>(std::floor(bottom)), 0, finest.height - 1);
    const int y1 = std::clamp(static_cast<int>(std::floor(top)), 0, finest.height - 1);
    std::size_t l = 0;
    // Four blocks a side follow the outline closely enough and cost few looks.
    while (l + 1 < levels_.size() && (((x1 >> l) - (x0 >> l)) > 3 || ((y1 >> l) - (y0 >> l)) > 3)) {
        ++l;
    }
    const Level& level = levels_[l];
    for (int y = y0 >> l; y <= y1 >> l; ++y) {
        for (int x = x0 >> l; x <= x1 >> l; ++x) {
            if (level.farthest[at(x, y, level.width)] >= depth) {
                return false;
            }
        }
    }
    return true;
}

bool is_hidden(const SphereMark& mark, const Camera& camera, int height, const DepthPyramid& pyramid) {
    const double r = mark.radius;
    const double near_side = -mark.z - r;
    double zoom_near = camera.scale;
    double zoom_far = camera.scale;
    double depth = (near_side - camera.nearest) / (camera.farthest - camera.nearest);
    if (camera.perspective) {
        if (near_side <= camera.nearest) {
            return false;
        }
        zoom_near /= near_side;
        zoom_far /= near_side + 2 * r;
        depth = camera.farthest / near_side * depth;
    }
    const auto least = [&](double v) { return std::min(v * zoom_near, v * zoom_far); };
    const auto most = [&](double v) { return std::max(v * zoom_near, v * zoom_far); };
    // A pixel of slack on each side: the depth kept for a pixel is that of one of its samples.
    const double x = camera.centre.x();
    const double y = height - camera.centre.y();
    return pyramid.hides(x + least(mark.x - r) - 1, y + least(mark.y - r) - 1, x + most(mark.x + r) + 1,
                         y + most(mark.y + r) + 1, depth);
}

} // namespace tumble::render
