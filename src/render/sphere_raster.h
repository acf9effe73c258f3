#pragma once

#include "base/parallel_for.h"
#include "render/area.h"
#include "render/camera.h"
#include "render/kernels.h"
#include "render/sphere_list.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tumble::render {

/// Draws spheres by the processor, tile by tile of the picture, from front to back: what lies behind what has been
/// drawn is left out early, which in a dense bed is most. Samples are exact: each meets the true spheres. Any number of
/// threads draws the same bits.
class SphereRaster {
public:
    /// Tiles beside each other that hold something; pixels from the picture's left and lower edge, ends not included.
    struct Run {
        int left, bottom, right, top;
    };

    /// Takes up the spheres of a picture of that size (pixels). What lies outside the window (pixels from the top) is
    /// left out, whole tiles at a time. The faces of `cut` (m, in the world) cut spheres open: what is seen lies in it.
    void take(std::span<const SphereMark> marks, const Camera& camera, int width, int height, const Area& window,
              const Sampling& sampling, bool skip_hidden, const std::optional<Eigen::AlignedBox3d>& cut = {});

    /// Samples from a row of pixels to the one above it.
    [[nodiscard]] std::size_t row_length() const { return row_length_; }
    /// Of tiles.
    [[nodiscard]] int rows() const { return rows_; }
    /// Pixels.
    [[nodiscard]] int tile_height() const { return sampling_.tile_height(); }

    /// Draws `count` rows of tiles from the `first` on; colours (bytes red, green, blue, opacity) and depths (OpenGL's,
    /// 0 near to 1 far) have room for row_length() * tile_height() * count samples, the lowest row of pixels first.
    /// Only what lies in the runs is written.
    std::vector<Run> draw(int first, int count, const Light& light, std::uint32_t* colors, float* depths, Crew& crew);

private:
    void place(std::span<const SphereMark> marks, const Camera& camera, int height);
    void sort_from_front();
    void deal_to_tiles();

    const Kernels* kernels_ = &choose_kernels();
    Sampling sampling_;
    Sight sight_;
    bool skip_hidden_ = true;
    std::vector<CutPlane> cut_; // planes_of_cut of them, or none
    std::size_t row_length_ = 0;
    int columns_ = 0, rows_ = 0;                    // tiles
    int left_ = 0, right_ = 0, low_ = 0, high_ = 0; // tiles of the window, ends not included
    std::vector<Ball> balls_;
    std::vector<Ball> placed_;          // as they came
    std::vector<std::uint32_t> order_;  // how many of each depth
    float disorder_ = 0;                // m, between balls that the sorting takes for equal
    std::vector<std::uint32_t> begins_; // of each tile's part of listed_, and its end
    std::vector<ListedBall> listed_;
};

} // namespace tumble::render
