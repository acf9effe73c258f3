#include "fixtures.h"
#include "render/strip_painter.h"

namespace test_strip {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;

namespace {

const Eigen::AlignedBox3d cube(Vector3d::Constant(-0.5), Vector3d::Constant(0.5));

scene::Render wide() {
    scene::Render settings = square_view(0.5);
    settings.width = 1280;
    settings.height = 720;
    return settings;
}

observe::Frame ball_at(const std::shared_ptr<observe::FrameLayout>& layout, int k) {
    observe::Frame frame = empty_frame(layout);
    frame.time = 0.1 * k;
    add_body(frame, 0, {0, 0.1 * k - 0.2, 0}, {0, 0.2 * k, 0});
    return frame;
}

StripPainter strip_of(const scene::Render& settings, const std::shared_ptr<observe::FrameLayout>& layout,
                      const StripPlan& plan, const Eigen::AlignedBox3d& box = cube) {
    auto painter = StripPainter::open(settings, layout, box, plan);
    REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
    return std::move(*painter);
}

} // namespace

TEST_CASE("each cell of a strip is the picture that a painter of that size makes of its frame") {
    const auto layout = spheres({0.1});
    StripPainter strip = strip_of(wide(), layout, {.cells = 4});
    for (int k = 0; k < 4; ++k)
        strip.add(ball_at(layout, k), "t");
    const Picture whole = strip.finish();
    REQUIRE(strip.cells().size() == 4);
    scene::Render of_cell = wide();
    of_cell.width = static_cast<int>(strip.cells()[0].width());
    of_cell.height = static_cast<int>(strip.cells()[0].height());
    Painter single = painter_for(of_cell, layout, {.lettering = false});
    single.fit(cube);
    for (int k = 0; k < 4; ++k) {
        const Picture one = single.draw(ball_at(layout, k));
        const Area& cell = strip.cells()[static_cast<std::size_t>(k)];
        int different = 0;
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x)
                different +=
                    pixel(one, x, y) != pixel(whole, x + static_cast<int>(cell.left), y + static_cast<int>(cell.top))
                        ? 1
                        : 0;
        CHECK(different == 0);
    }
}

TEST_CASE("cells stand so that the scene is large, do not overlap, and the picture is no higher than they need") {
    const auto layout = spheres({0.1});
    for (const auto& [box, plan, columns] :
         {std::tuple{cube, StripPlan{.cells = 6}, 3},
          std::tuple{Eigen::AlignedBox3d(Vector3d(-0.5, -2, -0.5), Vector3d(0.5, 2, 0.5)), StripPlan{.cells = 6}, 6},
          std::tuple{cube, StripPlan{.cells = 8, .columns = 4}, 4}}) {
        scene::Render settings = wide();
        settings.view.reset();
        StripPainter strip = strip_of(settings, layout, plan, box);
        const std::vector<Area>& cells = strip.cells();
        REQUIRE(static_cast<int>(cells.size()) == plan.cells);
        int in_first_row = 0;
        for (const Area& cell : cells) {
            in_first_row += cell.top == cells[0].top ? 1 : 0;
            CHECK(cell.left >= 0);
            CHECK(cell.right <= 1280);
        }
        CHECK(in_first_row == columns);
        for (std::size_t a = 0; a < cells.size(); ++a)
            for (std::size_t b = a + 1; b < cells.size(); ++b)
                CHECK((cells[a].right < cells[b].left || cells[a].bottom < cells[b].top));
        strip.add(ball_at(layout, 0), "t");
        const Picture picture = strip.finish();
        CHECK(picture.height <= 720);
        CHECK(picture.height > cells.back().bottom + 68); // room for the legend
    }
    // A flat wide scene in a column: three cells 12.5 times as wide as high leave most of the height away.
    scene::Render settings = wide();
    settings.view.reset();
    StripPainter flat = strip_of(settings, layout, {.cells = 3, .columns = 1},
                                 Eigen::AlignedBox3d(Vector3d(-0.5, -0.1, -1.25), Vector3d(0.5, 0.1, 1.25)));
    flat.add(ball_at(layout, 0), "t");
    CHECK(flat.finish().height < 600);
}

TEST_CASE("a cell with another clip shows no body outside it") {
    const auto layout = spheres({0.1});
    scene::Render settings = wide();
    StripPainter strip = strip_of(settings, layout, {.cells = 2});
    const scene::Box none{{0.2, -1, -1}, {1, 1, 1}}, all{{-0.2, -1, -1}, {1, 1, 1}};
    const observe::Frame frame = ball_at(layout, 2);
    REQUIRE(strip.cut(none).ok());
    strip.add(frame, "cut");
    REQUIRE(strip.cut(all).ok());
    strip.add(frame, "whole");
    const Picture picture = strip.finish();
    const auto centre = [&](std::size_t k) {
        const Area& cell = strip.cells()[k];
        return pixel(picture, static_cast<int>(0.5 * (cell.left + cell.right)),
                     static_cast<int>(0.5 * (cell.top + cell.bottom)));
    };
    const Area& cell = strip.cells()[0];
    CHECK(centre(0) == pixel(picture, static_cast<int>(cell.left), static_cast<int>(cell.top)));
    CHECK(centre(1) != centre(0));
}

TEST_CASE("a strip needs a range, and cells that can be seen") {
    const auto layout = spheres({0.1});
    scene::Render settings = wide();
    settings.range.reset();
    CHECK(StripPainter::open(settings, layout, cube, {.cells = 2}).problems().at(0).key == "render.range");
    settings = wide();
    settings.width = 320;
    settings.height = 240;
    const Problems problems = StripPainter::open(settings, layout, cube, {.cells = 100}).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].what == "100 pictures in one of 320 x 240 pixels would be too small to see anything");
}

} // namespace test_strip
