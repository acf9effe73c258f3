#include "../about.h"
#include "fixtures.h"

#include <numbers>

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using test::about;

namespace test_restyle {

constexpr double half = 0.1; // m, of what square_view shows in 400 pixels

observe::Frame three_balls(const std::shared_ptr<const observe::FrameLayout>& layout) {
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0.03, 0}, {1, 0, 0});
    add_body(frame, 0, {0.05, -0.03, 0.02}, {0, 0.5, 0});
    add_body(frame, 0, {-0.05, 0, -0.05});
    return frame;
}

TEST_CASE("a painter that is restyled draws what one does that was opened with the new camera, clip and colours") {
    const auto layout = spheres({0.02});
    const observe::Frame frame = three_balls(layout);
    scene::Render front = square_view(half);
    front.width = 720; // either camera has the panels beside the scene: their arrangement is that of the first
    scene::Render turned = front;
    turned.camera = "free";
    turned.eye = {0.3, 0.2, 0.25};
    turned.color = "vy";
    turned.colormap = "inferno";
    turned.range = {-1.0, 1.0};
    turned.clip = scene::Box{Vector3d(-1, -1, -0.03), Vector3d(1, 1, 1)};
    Painter painter = painter_for(front, layout, {});
    const Picture first = painter.draw(frame);
    REQUIRE(painter.restyle(turned).ok());
    const Picture second = painter.draw(frame);
    CHECK(second.rgba == painter_for(turned, layout, {}).draw(frame).rgba);
    CHECK(second.rgba != first.rgba);
    REQUIRE(painter.restyle(front).ok());
    CHECK(painter.draw(frame).rgba == first.rgba);
}

TEST_CASE("a painter that is resized draws what one does that was of that size from the first, with what it has seen") {
    // Its colours still reach to the 1 m/s of the first frame, its trail begins there.
    const auto layout = spheres({0.02});
    const observe::Frame first = three_balls(layout);
    observe::Frame second = first;
    second.time = 0.1;
    for (std::size_t b = 0; b < second.bodies(); ++b) {
        second.velocity[b] *= 0.4;
        second.position[b].y() += 0.02;
    }
    scene::Render settings = square_view(half);
    settings.range.reset();
    settings.marks.trails = {"1"};
    Painter painter = painter_for(settings, layout, {});
    (void)painter.draw(first);
    scene::Render wide = settings;
    wide.width = 520;
    wide.height = 300;
    REQUIRE(painter.resize(wide.width, wide.height).ok());
    Painter other = painter_for(wide, layout, {});
    (void)other.draw(first);
    CHECK(painter.draw(second).rgba == other.draw(second).rgba);
    CHECK(painter.range() == Span{0, 1});
    CHECK(painter.draw(second).rgba != painter_for(wide, layout, {}).draw(second).rgba);
    CHECK(!painter.resize(1 << 20, 300).ok());
    CHECK(painter.draw(second).rgba == other.draw(second).rgba);
}

TEST_CASE("settings that cannot be drawn are refused and leave the painter as it is") {
    const auto layout = spheres({0.02});
    const observe::Frame frame = three_balls(layout);
    Painter painter = painter_for(square_view(half), layout, {});
    const Picture first = painter.draw(frame);
    scene::Render wrong = square_view(half);
    wrong.color = "sped";
    CHECK(painter.restyle(wrong).problems().front().key == "render.color");
    CHECK(painter.draw(frame).rgba == first.rgba);
}

TEST_CASE("a sketched sphere covers as many pixels as a smooth one, each wholly or not at all") {
    const auto layout = spheres({0.04});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, Vector3d::Zero());
    Painter painter = painter_for(square_view(half), layout, bare);
    REQUIRE(painter.set_sketching(true).ok());
    const Picture sketch = painter.draw(frame);
    const Vector3d inside = pixel(sketch, 200, 200), outside = pixel(sketch, 2, 2);
    // 0.04 m of 0.1 m in 200 pixels: the margin of 3 % on each side is the view's.
    const double radius = 0.04 * painter.camera().scale;
    CHECK(covered_pixels(sketch, inside, outside) == about(std::numbers::pi * radius * radius, 0.005));
    for (int x = 0; x < 400; ++x)
        CHECK((pixel(sketch, x, 200) == inside || pixel(sketch, x, 200) == outside));
    REQUIRE(painter.set_sketching(false).ok());
    CHECK(painter.draw(frame).rgba == painter_for(square_view(half), layout, bare).draw(frame).rgba);
}

} // namespace test_restyle
