#include "render/sphere_raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tumble::render {

namespace {

constexpr int depths_told_apart = 4096;  // when balls are sorted from front to back
constexpr double farthest_pixel = 32000; // of 16 bits

/// Pixels whose samples lie between two places, ends included.
std::int16_t pixel_of(double place) {
    return static_cast<std::int16_t>(std::floor(std::clamp(place, -farthest_pixel, farthest_pixel)));
}

Sight sight_of(const Camera& camera, int height) {
    Sight sight;
    sight.perspective = camera.perspective;
    sight.scale = static_cast<float>(camera.scale);
    sight.centre_x = static_cast<float>(camera.centre.x());
    sight.centre_y = static_cast<float>(height - camera.centre.y());
    const double depth = camera.farthest - camera.nearest;
    if (camera.perspective) {
        sight.depth_at_0 = static_cast<float>(camera.farthest / depth);
        sight.depth_slope = static_cast<float>(camera.farthest * camera.nearest / depth);
    } else {
        sight.depth_at_0 = static_cast<float>(-camera.nearest / depth);
        sight.depth_slope = static_cast<float>(-1 / depth);
    }
    return sight;
}

/// In perspective between what it would cover at its nearest and at its farthest point.
Ball ball_of(const SphereMark& mark, const Camera& camera, int height) {
    const double r = mark.radius;
    const double zoom = camera.perspective ? camera.scale / -mark.z : camera.scale;
    const double near_zoom = camera.perspective ? camera.scale / (-mark.z - r) : zoom;
    const double far_zoom = camera.perspective ? camera.scale / (-mark.z + r) : zoom;
    const auto least = [&](double v) { return std::min(v * near_zoom, v * far_zoom); };
    const auto most = [&](double v) { return std::max(v * near_zoom, v * far_zoom); };
    const double x = camera.centre.x(), y = height - camera.centre.y();
    Ball ball{};
    ball.x = static_cast<float>(x + zoom * mark.x);
    ball.y = static_cast<float>(y + zoom * mark.y);
    ball.z = mark.z;
    ball.radius = mark.radius;
    ball.nearest = static_cast<float>(mark.z + r + 1e-6 * (std::abs(mark.z) + r)); // float's roundings
    ball.color = mark.color;
    ball.left = pixel_of(x + least(mark.x - r));
    ball.right = pixel_of(x + most(mark.x + r));
    ball.bottom = pixel_of(y + least(mark.y - r));
    ball.top = pixel_of(y + most(mark.y + r));
    return ball;
}

/// The box' faces in view space.
std::vector<CutPlane> planes_of(const Eigen::AlignedBox3d& box, const Camera& camera) {
    std::vector<CutPlane> planes;
    for (const bool upper : {false, true})
        for (int axis = 0; axis < 3; ++axis) {
            const Eigen::Vector3d outwards = (upper ? 1 : -1) * Eigen::Vector3d::Unit(axis);
            const Eigen::Vector3f normal = (camera.axes * outwards).cast<float>();
            const double offset = outwards.dot((upper ? box.max() : box.min()) - camera.eye);
            planes.push_back({normal.x(), normal.y(), normal.z(), static_cast<float>(offset)});
        }
    return planes;
}

} // namespace

void SphereRaster::take(std::span<const SphereMark> marks, const Camera& camera, int width, int height,
                        const Area& window, const Sampling& sampling, bool skip_hidden,
                        const std::optional<Eigen::AlignedBox3d>& cut) {
    sampling_ = sampling;
    sight_ = sight_of(camera, height);
    skip_hidden_ = skip_hidden;
    cut_ = cut ? planes_of(*cut, camera) : std::vector<CutPlane>{};
    const int tile_width = sampling.tile_width(), tile_height = sampling.tile_height();
    columns_ = (width + tile_width - 1) / tile_width;
    rows_ = (height + tile_height - 1) / tile_height;
    row_length_ = static_cast<std::size_t>(columns_ * tile_width * sampling.samples);
    const auto tile = [](double pixel, int side, int count) {
        return std::clamp(static_cast<int>(std::floor(pixel)) / side, 0, count);
    };
    left_ = tile(window.left, tile_width, columns_);
    right_ = tile(window.right + tile_width, tile_width, columns_);
    low_ = tile(height - window.bottom, tile_height, rows_);
    high_ = tile(height - window.top + tile_height, tile_height, rows_);
    place(marks, camera, height);
    sort_from_front();
    deal_to_tiles();
}

/// Those that may be seen in the window.
void SphereRaster::place(std::span<const SphereMark> marks, const Camera& camera, int height) {
    const int left = left_ * sampling_.tile_width(), right = right_ * sampling_.tile_width();
    const int low = low_ * sampling_.tile_height(), high = high_ * sampling_.tile_height();
    placed_.clear();
    placed_.reserve(marks.size());
    for (const SphereMark& mark : marks) {
        if (camera.perspective && -mark.z < camera.nearest)
            continue; // before the picture's near side
        const Ball ball = ball_of(mark, camera, height);
        if (ball.left < right && ball.right >= left && ball.bottom < high && ball.top >= low)
            placed_.push_back(ball);
    }
}

/// By counting: which of two balls of one bin comes first does not change what is seen, only what it costs.
void SphereRaster::sort_from_front() {
    float near_end = -std::numeric_limits<float>::infinity(), far_end = -near_end;
    for (const Ball& ball : placed_) {
        near_end = std::max(near_end, ball.nearest);
        far_end = std::min(far_end, ball.nearest);
    }
    const float bin = std::max((near_end - far_end) / (depths_told_apart - 1), 1e-12F);
    const auto bin_of = [&](const Ball& ball) {
        return std::clamp(static_cast<int>((near_end - ball.nearest) / bin), 0, depths_told_apart - 1);
    };
    disorder_ = 2 * bin; // one, and roundings
    order_.assign(depths_told_apart + 1, 0);
    for (const Ball& ball : placed_)
        ++order_[static_cast<std::size_t>(bin_of(ball)) + 1];
    for (std::size_t k = 1; k < order_.size(); ++k)
        order_[k] += order_[k - 1];
    balls_.resize(placed_.size());
    for (const Ball& ball : placed_)
        balls_[order_[static_cast<std::size_t>(bin_of(ball))]++] = ball;
}

void SphereRaster::deal_to_tiles() {
    const int width = sampling_.tile_width(), height = sampling_.tile_height();
    // Both sides are powers of 2.
    const int across = std::countr_zero(static_cast<unsigned>(width));
    const int up = std::countr_zero(static_cast<unsigned>(height));
    const auto for_tiles = [&](const Ball& ball, const auto& visit) {
        const int left = std::max(ball.left >> across, left_);
        const int right = std::min(ball.right >> across, right_ - 1);
        const int low = std::max(ball.bottom >> up, low_);
        const int high = std::min(ball.top >> up, high_ - 1);
        for (int row = low; row <= high; ++row)
            for (int column = left; column <= right; ++column)
                visit(row, column, static_cast<std::size_t>(row * columns_ + column));
    };
    const auto within = [](int pixel, int begin, int side) {
        return static_cast<std::uint8_t>(std::clamp(pixel - begin, 0, side - 1));
    };
    begins_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const Ball& ball : balls_)
        for_tiles(ball, [&](int, int, std::size_t tile) { ++begins_[tile + 1]; });
    for (std::size_t t = 1; t < begins_.size(); ++t)
        begins_[t] += begins_[t - 1];
    listed_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const Ball& ball = balls_[b];
        for_tiles(ball, [&](int row, int column, std::size_t tile) {
            const int left = column * width, low = row * height;
            listed_[next[tile]++] = {static_cast<std::uint32_t>(b),    ball.nearest,
                                     within(ball.left, left, width),   within(ball.right, left, width),
                                     within(ball.bottom, low, height), within(ball.top, low, height)};
        });
    }
}

std::vector<SphereRaster::Run> SphereRaster::draw(int first, int count, const Light& light, std::uint32_t* colors,
                                                  float* depths, Crew& crew) {
    const int width = sampling_.tile_width(), height = sampling_.tile_height();
    std::vector<TileJob> jobs;
    std::vector<Run> runs;
    for (int row = first; row < std::min(first + count, rows_); ++row)
        for (int column = left_; column < right_; ++column) {
            const auto tile = static_cast<std::size_t>(row * columns_ + column);
            const std::uint32_t begin = begins_[tile];
            if (begins_[tile + 1] == begin)
                continue;
            TileJob& job = jobs.emplace_back();
            job.sampling = sampling_;
            job.sight = sight_;
            job.light = light;
            job.left = column * width;
            job.bottom = row * height;
            job.balls = balls_.data();
            job.listed = listed_.data() + begin;
            job.count = static_cast<int>(begins_[tile + 1] - begin);
            job.disorder = disorder_;
            job.skip_hidden = skip_hidden_;
            job.cut = cut_.empty() ? nullptr : cut_.data();
            const auto at =
                static_cast<std::ptrdiff_t>(row - first) * height * static_cast<std::ptrdiff_t>(row_length_) +
                static_cast<std::ptrdiff_t>(column) * width * sampling_.samples;
            job.colors = colors + at;
            job.depths = depths + at;
            job.row = static_cast<std::ptrdiff_t>(row_length_);
            if (runs.empty() || runs.back().bottom != job.bottom || runs.back().right != job.left)
                runs.push_back({job.left, job.bottom, job.left, job.bottom + height});
            runs.back().right = job.left + width;
        }
    crew.share(static_cast<int>(jobs.size()), [&](int k) { kernels_->draw_tile(jobs[static_cast<std::size_t>(k)]); });
    return runs;
}

} // namespace tumble::render
