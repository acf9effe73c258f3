#include "about.h"
#include "base/checksum.h"
#include "fixtures.h"
#include "render/paper.h"
#include "render/png_writer.h"
#include "scene/load.h"

namespace test_paper {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

scene::Render for_print(double width_mm, double height_mm, double dpi, double font_pt) {
    scene::Render settings = square_view(1);
    settings.paper = scene::Paper{width_mm, height_mm, dpi, font_pt};
    settings.width = static_cast<int>(std::lround(width_mm / 25.4 * dpi));
    settings.height = static_cast<int>(std::lround(height_mm / 25.4 * dpi));
    settings.plot = false;
    return settings;
}

std::uint32_t whole_at(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    return std::uint32_t{bytes[at]} << 24U | std::uint32_t{bytes[at + 1]} << 16U | std::uint32_t{bytes[at + 2]} << 8U |
           std::uint32_t{bytes[at + 3]};
}

} // namespace

TEST_CASE("a picture for print says its dots per metre in the chunk that the PNG specification has for it") {
    // 300 dots an inch are 300 / 0.0254 = 11811 a metre. The chunk follows the header: 8 bytes of signature, 25 of
    // IHDR.
    Picture picture{.width = 3, .height = 2, .rgba = std::vector<std::uint8_t>(24, 200)};
    const auto plain = encode_png(picture);
    picture.dots_per_metre = dots_per_metre(for_print(85, 60, 300, 8));
    CHECK(picture.dots_per_metre == about(11811.02, 1e-6));
    const auto sized = encode_png(picture);
    REQUIRE(sized.size() == plain.size() + 21);
    CHECK(whole_at(sized, 33) == 9);
    CHECK(std::string(sized.begin() + 37, sized.begin() + 41) == "pHYs");
    CHECK(whole_at(sized, 41) == 11811);
    CHECK(whole_at(sized, 45) == 11811);
    CHECK(sized[49] == 1);
    CHECK(whole_at(sized, 50) == crc32({reinterpret_cast<const char*>(sized.data()) + 37, 13}));
    CHECK(std::equal(sized.begin() + 54, sized.end(), plain.begin() + 33));
}

TEST_CASE("on paper the background is white, there is no title, and digits are as high as their points say") {
    // DejaVu's digits are 0.729 of its size high: at 8 pt and 600 dpi 48.6 pixels.
    const auto layout = spheres({0.2});
    layout->title = "Not to be seen";
    Painter painter = painter_for(for_print(85, 60, 600, 8), layout, {});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0.5, 0, 0});
    const Picture picture = painter.draw(frame);
    CHECK(picture.width == 2008);
    CHECK(picture.height == 1417);
    CHECK(picture.dots_per_metre == about(600 / 0.0254));
    CHECK(pixel(picture, 3, 3) == Vector3d(255, 255, 255));
    CHECK(painter.layout().title.width() == 0);
    // The lowest number of the legend stands right of its end, at half its height below it.
    const Area bar = painter.legend_bar();
    const double unit = painter.layout().unit;
    int top = 2000, bottom = 0;
    for (int y = static_cast<int>(bar.bottom - 12 * unit); y < static_cast<int>(bar.bottom + 12 * unit); ++y)
        for (int x = static_cast<int>(bar.right + 10 * unit); x < static_cast<int>(bar.right + 20 * unit); ++x)
            if (pixel(picture, x, y).x() < 128) {
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    CHECK(std::abs(bottom - top + 1 - 0.729 * 8 / 72 * 600) <= 2.5); // a round letter reaches a little beyond
}

TEST_CASE("a style that a command line asks for puts away the size that the file has for the other") {
    const std::string file = TUMBLE_ROOT "/scenes/drop.toml";
    const auto scene = scene::load_scene(file, {{"render.style=\"paper\""}, {"render.width_mm=100"}});
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    REQUIRE(scene->render.paper);
    CHECK(scene->render.width == 1181); // 100 / 25.4 * 300
    CHECK(scene->render.height == 709); // 60 / 25.4 * 300
    CHECK(scene->render.background == "white");
    CHECK(!scene->render.plot);
}

} // namespace test_paper
