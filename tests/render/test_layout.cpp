#include "about.h"
#include "render/layout.h"

#include <array>
#include <doctest/doctest.h>
#include <vector>

namespace test_layout {

using namespace tumble::render;
using tumble::test::about;

namespace {

std::vector<Area> panels(const Layout& layout) {
    std::vector<Area> all{layout.scene, layout.title, layout.time, layout.legend, layout.scale_bar};
    if (layout.plot.width() > 0) {
        all.push_back(layout.plot);
    }
    return all;
}

bool overlap(const Area& a, const Area& b) {
    return a.left < b.right - 1e-9 && b.left < a.right - 1e-9 && a.top < b.bottom - 1e-9 && b.top < a.bottom - 1e-9;
}

} // namespace

TEST_CASE("panels stay inside the picture and off each other at every size from 320 x 200 up") {
    const std::vector<std::array<int, 2>> sizes{{320, 200},  {640, 360},   {640, 480},   {500, 500},
                                                {1280, 720}, {1920, 1080}, {3840, 2160}, {720, 1280},
                                                {1600, 400}, {400, 1600},  {360, 640}};
    for (const auto& [width, height] : sizes) {
        for (const bool plot : {false, true}) {
            for (const bool wide : {false, true}) {
                CAPTURE(width);
                CAPTURE(height);
                CAPTURE(plot);
                const auto zoom = [&](const Area& a) { return wide ? a.width() : a.height(); };
                const Layout layout = make_layout(width, height, plot, zoom);
                REQUIRE(layout.lettered);
                for (const Area& panel : {layout.title, layout.time, layout.legend, layout.plot, layout.scale_bar}) {
                    CHECK(!overlap(layout.window, panel));
                }
                const auto all = panels(layout);
                for (std::size_t i = 0; i < all.size(); ++i) {
                    CHECK(all[i].left >= 0);
                    CHECK(all[i].top >= 0);
                    CHECK(all[i].right <= width);
                    CHECK(all[i].bottom <= height);
                    CHECK(all[i].width() > 0);
                    CHECK(all[i].height() > 0);
                    for (std::size_t k = 0; k < i; ++k) {
                        CHECK(!overlap(all[i], all[k]));
                    }
                }
            }
        }
    }
}

TEST_CASE("a wide scene gets the strip, a high one the column") {
    const auto fit = [](double w, double h) {
        return [=](const Area& a) { return std::min(a.width() / w, a.height() / h); };
    };
    CHECK(make_layout(1280, 720, true, fit(1, 1)).column);
    CHECK(!make_layout(1280, 720, true, fit(4, 1)).column);
}

TEST_CASE("an upright picture has letters as large as one that lies, and its scene takes the most of it") {
    const auto fit = [](const Area& a) { return std::min(a.width() / 0.56, a.height() / 0.47); };
    const Layout upright = make_layout(360, 640, true, fit);
    CHECK(upright.unit == about(make_layout(640, 360, true, fit).unit));
    CHECK(0.47 * fit(upright.scene) > 0.4 * 640);
}

TEST_CASE("a picture too small for letters belongs to the scene") {
    const Layout layout = make_layout(200, 120, true, [](const Area&) { return 1.0; });
    CHECK(!layout.lettered);
    CHECK(layout.scene.width() == 200);
    CHECK(layout.scene.height() == 120);
}

} // namespace test_layout
