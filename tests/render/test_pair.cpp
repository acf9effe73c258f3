#include "fixtures.h"
#include "render/color_map.h"
#include "render/pair_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test_pair {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;

namespace {

/// A scene of one disc of radius 0.2 m.
std::shared_ptr<observe::FrameLayout> flat() {
    const auto layout = spheres({0.2});
    layout->dimension = 2;
    return layout;
}

observe::Frame disc_at(const std::shared_ptr<observe::FrameLayout>& layout, const Vector3d& place, double speed) {
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, place, {speed, 0, 0});
    return frame;
}

PairPainter pair_of(scene::Render settings, const std::shared_ptr<observe::FrameLayout>& layout) {
    auto painter = PairPainter::open(settings, {layout, layout}, {"left", "right"});
    REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
    return std::move(*painter);
}

scene::Render wide() {
    scene::Render settings = square_view(1);
    settings.camera = "side";
    settings.width = 1280;
    settings.height = 720;
    return settings;
}

/// Pixels of that colour, in the given half.
double pixels_of(const Picture& picture, const Area& area, const Vector3d& color) {
    double sum = 0;
    for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y)
        for (int x = static_cast<int>(area.left); x < static_cast<int>(area.right); ++x)
            sum += (pixel(picture, x, y) - color).cwiseAbs().maxCoeff() < 3 ? 1 : 0;
    return sum;
}

} // namespace

TEST_CASE("two frames side by side have one scale and one meaning of the colours") {
    const auto layout = flat();
    PairPainter painter = pair_of(wide(), layout);
    const Picture picture = painter.draw(disc_at(layout, {0, 0, 0}, 0.25), disc_at(layout, {0.3, 0.1, 0}, 0.75));
    CHECK(picture.width == 1280);
    CHECK(picture.height == 720);
    const auto& [left, right] = painter.halves();
    CHECK(left.width() == right.width());
    CHECK(left.right < right.left);
    const ColorMap map = *find_color_map("viridis", false);
    // 2 m fit into the smaller side of a half, less a margin of 3 % at either end; the outline and the spoke cost a
    // little of the disc's colour.
    const double per_metre = 0.94 * std::min(left.width(), left.height()) / 2;
    const double area = std::numbers::pi * 0.04 * per_metre * per_metre;
    for (const auto& [half, speed] : {std::pair{left, 0.25}, std::pair{right, 0.75}}) {
        CAPTURE(speed);
        const double seen = pixels_of(picture, half, 255 * map.at(speed));
        CHECK(seen > 0.9 * area);
        CHECK(seen < area);
        CHECK(pixels_of(picture, half, 255 * map.at(1 - speed)) < 0.01 * area);
    }
}

TEST_CASE("a wide flat scene is drawn one above the other, so that it fills the picture's width") {
    const auto layout = flat();
    scene::Render settings = wide();
    settings.view = scene::Box{{-2, -0.3, -1}, {2, 0.3, 1}};
    const PairPainter painter = pair_of(settings, layout);
    const auto& [upper, lower] = painter.halves();
    CHECK(upper.width() > 0.95 * 1280);
    CHECK(upper.width() == lower.width());
    CHECK(upper.height() == lower.height());
    CHECK(upper.bottom < lower.top);
    CHECK(lower.bottom < 720);
    settings.view = scene::Box{{-1, -1, -1}, {1, 1, 1}};
    CHECK(pair_of(settings, layout).halves()[0].right < 640);
}

TEST_CASE("a pair of frames needs one range of colours and room for its lettering") {
    const auto layout = flat();
    scene::Render settings = wide();
    settings.range.reset();
    CHECK(PairPainter::open(settings, {layout, layout}, {"", ""}).problems().at(0).key == "render.range");
    settings = wide();
    settings.height = 200;
    CHECK(PairPainter::open(settings, {layout, layout}, {"", ""}).problems().at(0).key == "render.width_px");
    settings = wide();
    settings.color = "spede";
    CHECK(!PairPainter::open(settings, {layout, layout}, {"", ""}).ok());
}

} // namespace test_pair
