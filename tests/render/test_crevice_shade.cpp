#include "about.h"
#include "fixtures.h"
#include "render/kernels.h"

#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace test_crevice_shade {

using namespace tumble;
using namespace tumble::render;

namespace {

/// A surface by its depth, and what is made of it. Parallel, 1 m of depth, a ball of 0.1 m on 10 pixels.
struct Surface {
    int width, height;
    std::vector<float> depth, distance, sky;
    std::vector<std::uint8_t> shade;
    CreviceJob job;

    Surface(int w, int h, float d)
        : width(w), height(h), depth(static_cast<std::size_t>(w * h), d),
          distance(static_cast<std::size_t>((w + 32) * h)), sky(distance.size()), shade(distance.size()) {
        job.width = w;
        job.height = h;
        job.last = h;
        job.row = w + 32;
        job.nearest = 2;
        job.farthest = 3;
        job.radius = 0.1F;
        job.scale = 100;
        job.strength = 0.8F;
    }
    void work(const Kernels& kernels) {
        job.depth = depth.data();
        job.distance = distance.data() + 8;
        job.sky = sky.data() + 8;
        job.shade = shade.data() + 8;
        kernels.measure_distances(job);
        kernels.gather_sky(job);
        kernels.blur_sky(job);
    }
    float& at(int x, int y) { return depth[static_cast<std::size_t>(y * width + x)]; }
    [[nodiscard]] float sky_at(int x, int y) const { return job.sky[y * job.row + x]; }
    [[nodiscard]] int shade_at(int x, int y) const { return job.shade[y * job.row + x]; }
};

} // namespace

TEST_CASE("half of the ball about a flat surface is free and counts as open sky; a pit sees none, beside nothing all "
          "is open") {
    for (const bool perspective : {false, true}) {
        Surface flat(61, 47, 0.5F);
        flat.job.perspective = perspective;
        if (perspective)
            flat.job.scale *= 2.4F;                     // 2 * 3 / (3 - 0.5) m away
        flat.at(30, 20) = perspective ? 0.647F : 0.65F; // the bottom of a hole of one pixel, one and a half balls deep
        for (int y = 30; y < 47; ++y)
            for (int x = 0; x < 61; ++x)
                flat.at(x, y) = 1; // nothing
        flat.work(choose_kernels());
        CHECK(flat.sky_at(10, 10) == 1);
        CHECK(flat.shade_at(10, 10) == 255);
        CHECK(flat.sky_at(30, 20) == 0);
        CHECK(flat.sky_at(10, 29) == 1);
        CHECK(flat.shade_at(10, 40) == 255);
        // Of 16 points of the blur the hole itself counts 1, its neighbours 0.2 each: (15 * 0.2) / (1 + 15 * 0.2).
        CHECK(flat.shade_at(30, 20) == static_cast<int>(255 * (1 + 0.8 * (0.75 - 1)) + 0.5));
    }
}

TEST_CASE("at the foot of a step as high as the ball half of the free half is taken") {
    // Looks are even over the disc: those on the step's side see none of their half chords, the others theirs.
    Surface step(80, 60, 0.5F);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 40; ++x)
            step.at(x, y) = 0.4F;
    step.work(choose_kernels());
    double mean = 0; // over the pattern of 4 x 4 pixels that the looks are turned in
    for (int y = 20; y < 24; ++y)
        mean += step.sky_at(40, y) / 4.0;
    CHECK(mean > 0.4);
    CHECK(mean < 0.6);
    CHECK(step.sky_at(55, 20) == 1); // more than a radius away
}

TEST_CASE("where nothing is drawn a picture keeps its background, right up to the rows that are shaded") {
    using namespace testing;
    auto layout = spheres({0.2});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0.18, 0});
    add_body(frame, 0, {0, -0.18, 0});
    const double top = 200 - 188 * 0.38, bottom = 200 + 188 * 0.38, side = 188 * 0.2; // 188 pixels a metre
    for (const char* projection : {"orthographic", "perspective"}) {
        scene::Render settings = square_view(1);
        settings.projection = projection;
        const Picture picture = painter_for(settings, layout, {.lettering = false}).draw(frame);
        const Vector3d background = pixel(picture, 2, 2);
        for (int y = 0; y < 400; ++y)
            for (int x = 0; x < 400; ++x)
                if (y < top - 12 || y > bottom + 12 || std::abs(x - 200) > side + 12)
                    REQUIRE(pixel(picture, x, y) == background);
    }
}

TEST_CASE("every instruction set shades the same bits") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> depth(0.3F, 1.02F);
    for (const bool perspective : {false, true}) {
        Surface first(83, 41, 0.5F);
        first.job.perspective = perspective;
        for (float& d : first.depth)
            d = std::min(depth(random), 1.0F);
        first.work(*kernels_named("baseline"));
        for (const char* name : {"x86-64-v3", "x86-64-v4"})
            if (const Kernels* kernels = kernels_named(name)) {
                Surface other = first;
                std::fill(other.sky.begin(), other.sky.end(), 0.0F);
                std::fill(other.shade.begin(), other.shade.end(), std::uint8_t{0});
                other.work(*kernels);
                for (int y = 0; y < first.height; ++y)
                    for (int x = 0; x < first.width; ++x) {
                        REQUIRE(other.sky_at(x, y) == first.sky_at(x, y));
                        REQUIRE(other.shade_at(x, y) == first.shade_at(x, y));
                    }
            }
    }
}

} // namespace test_crevice_shade
