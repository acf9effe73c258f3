#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// The loops over samples. kernels/*.cpp are built once per instruction set; everything they see is a plain pointer or
/// number, so that no template of the standard library is built for a set the machine may lack. Every set draws the
/// same bits.
namespace tumble::render {

/// A sphere as it lies over the picture. Pixels count from the picture's left and lower edge, z (m) in view space
/// towards the eye.
struct alignas(32) Ball {
    float x;                               // pixels, of its centre
    float y;                               // pixels
    float z;                               // m, of its centre
    float radius;                          // m
    float nearest;                         // m, no point of it has a larger z
    std::uint32_t color;                   // bytes red, green, blue, opacity in memory order
    std::int16_t left, right, bottom, top; // pixels in which it may be seen, ends included
};
static_assert(sizeof(Ball) == 32);

/// Eight samples are drawn at once: those of so many neighbouring pixels of a row, pixel after pixel.
constexpr int samples_at_once = 8;
/// A tile: the part of a picture that one thread draws at a time and one core's cache holds.
constexpr int samples_in_tile = 2048;

/// Where a picture's samples lie.
struct Sampling {
    int samples = 1; // a pixel: 1, 2, 4 or 8
    float across[samples_at_once] = {};
    float up[samples_at_once] = {}; // pixels from the left lower corner of the first pixel

    [[nodiscard]] int pixels_at_once() const { return samples_at_once / samples; }
    [[nodiscard]] int tile_width() const { return samples == 1 ? 64 : 32; } // pixels
    [[nodiscard]] int tile_height() const { return samples_in_tile / (tile_width() * samples); }
};

/// How a place in view space gets to the picture and into its depth.
struct Sight {
    bool perspective = false;
    float scale = 1;       // pixels a metre; perspective: pixels a unit of the tangent
    float centre_x = 0;    // pixels, where the axis meets the picture
    float centre_y = 0;    // pixels
    float depth_at_0 = 0;  // depth 0 (near) to 1 is this plus
    float depth_slope = 0; // this times z; perspective: over z
};

struct Light {
    bool lit = true; // false: bare colours
    float rim = 0;   // added where a body bends away from the eye
};

/// A plane in view space: what lies on its side of normal . place <= offset is seen.
struct CutPlane {
    float x, y, z; // unit normal
    float offset;  // m
};
constexpr int planes_of_cut = 6; // of a box

/// A ball in a tile: what tells whether it is hidden stands together, since most are.
struct ListedBall {
    std::uint32_t ball;                    // index
    float nearest;                         // m, of the ball
    std::uint8_t left, right, bottom, top; // pixels of the tile in which it may be seen, ends included
};

struct TileJob {
    Sampling sampling;
    Sight sight;
    Light light;
    int left = 0;   // pixels
    int bottom = 0; // pixels
    const Ball* balls = nullptr;
    const ListedBall* listed = nullptr; // those that may be seen in this tile, the nearest first
    int count = 0;                      // of them
    float disorder = 0;                 // m, how much nearer than one before it one of them may be
    bool skip_hidden = true;            // false: draws what lies behind others too, for the same picture
    const CutPlane* cut = nullptr;      // planes_of_cut of them, which cut balls open; null: none does
    std::uint32_t* colors = nullptr;    // of the tile's first sample
    float* depths = nullptr;
    std::ptrdiff_t row = 0; // samples from a row of the picture to the one above it
};

/// Some rows of a picture whose crevices are darkened. All pictures are rows from the lowest on, `row` entries apart,
/// with room for eight entries before and sixteen behind each row's `width`.
struct CreviceJob {
    int width = 0, height = 0;     // pixels
    int first = 0, last = 0;       // rows to work on, the last not included
    std::ptrdiff_t row = 0;        // entries from a row to the one above it
    const float* depth = nullptr;  // OpenGL's; width entries a row, without room
    bool perspective = false;      //
    float nearest = 0;             // m, of depth 0
    float farthest = 1;            // m, of depth 1, which also says that there is nothing
    float radius = 0;              // m, of the ball about each point
    float scale = 1;               // pixels a metre; perspective: pixels a unit of the tangent
    float strength = 1;            // 0: no shade
    float* distance = nullptr;     // m; infinite where there is nothing
    float* sky = nullptr;          // share of the ball that is in front of the surface
    std::uint8_t* shade = nullptr; // what colours are multiplied by, 255 is 1
};

struct Kernels {
    /// Colour and depth (1 where there is no ball) of every sample of a tile: each ball meets each sample's line of
    /// sight where the true sphere does, the nearest is seen, of equals the first. Where a plane cuts a ball its inside
    /// is seen, flat.
    void (*draw_tile)(const TileJob& job);
    /// depth -> distance
    void (*measure_distances)(const CreviceJob& job);
    /// distance of all rows -> sky
    void (*gather_sky)(const CreviceJob& job);
    /// distance and sky of all rows -> shade
    void (*blur_sky)(const CreviceJob& job);
};

/// "x86-64-v4", "x86-64-v3" or "baseline"; null when this processor or this build lacks it.
const Kernels* kernels_named(std::string_view name);
/// The best that the processor has.
const Kernels& choose_kernels();

} // namespace tumble::render
