#include "fixtures.h"
#include "render/clip.h"
#include "render/mark_key.h"
#include "render/pair_painter.h"
#include "render/paper.h"
#include "render/strip_painter.h"

namespace test_clip {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using Rows = std::vector<std::string>;

namespace {

/// A ball of 0.1 m, in a domain of |x|, |y|, |z| <= `half` m.
std::shared_ptr<observe::FrameLayout> ball_within(double half) {
    auto layout = spheres({0.1});
    layout->domain_lo = Vector3d::Constant(-half);
    layout->domain_hi = Vector3d::Constant(half);
    return layout;
}

observe::Frame at_rest(const std::shared_ptr<observe::FrameLayout>& layout) {
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0});
    return frame;
}

/// What lies in front of z = 27 mm is left out; the other faces lie beyond the domain.
scene::Render up_to_27_mm(int width, int height) {
    scene::Render settings = square_view(0.5);
    settings.camera = "side";
    settings.width = width;
    settings.height = height;
    settings.plot = false;
    settings.clip = scene::Box{{-1, -1, -1}, {1, 1, 0.027}};
    return settings;
}

/// Pixels in an area that are not of the background.
int inked(const Picture& picture, const Area& area) {
    const Vector3d background = pixel(picture, static_cast<int>(area.right) - 1, static_cast<int>(area.bottom) - 1);
    int count = 0;
    for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y)
        for (int x = static_cast<int>(area.left); x < static_cast<int>(area.right); ++x)
            count += pixel(picture, x, y) != background ? 1 : 0;
    return count;
}

Picture strip_with(const std::shared_ptr<observe::FrameLayout>& layout, const scene::Render& settings, bool section) {
    auto painter = StripPainter::open(settings, layout, {Vector3d::Constant(-0.5), Vector3d::Constant(0.5)}, {});
    REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
    if (section)
        REQUIRE(painter->cut(*up_to_27_mm(1, 1).clip).ok());
    painter->add(at_rest(layout), "t");
    return painter->finish();
}

} // namespace

TEST_CASE("a plane is named by its axis, its place in mm and the side that is shown") {
    CHECK(plane_words(2, 0.027, false) == "z \u2264 27 mm");
    CHECK(plane_words(0, -0.0205, true) == "x \u2265 \u221220.5 mm");
    CHECK(plane_words(1, 0, false) == "y \u2264 0 mm");
    CHECK(plane_words(1, -1e-20, true) == "y \u2265 0 mm");
    CHECK(plane_words(2, 1.2345678, false) == "z \u2264 1234.6 mm");
    CHECK(plane_words(2, 0.0054479, false) == "z \u2264 5.45 mm");
    CHECK(section_words(2, 0.027, false, true) == "cut: z \u2264 27 mm");
    CHECK(section_words(0, 0.027, true, false) == "shown: x \u2265 27 mm");
}

TEST_CASE("of a clip only the faces within the domain are named, and whether they cut bodies open") {
    const auto layout = ball_within(0.5);
    const auto box = [](const Vector3d& lo, const Vector3d& hi) { return Eigen::AlignedBox3d(lo, hi); };
    CHECK(clip_words(box({-1, -1, -1}, {1, 1, 0.027}), false, *layout) == Rows{"shown: z \u2264 27 mm"});
    CHECK(clip_words(box({-1, -1, -1}, {1, 1, 0.027}), true, *layout) == Rows{"cut: z \u2264 27 mm"});
    CHECK(clip_words(box({-0.1, -0.5, -1}, {0.2, 0.5, 1}), false, *layout) ==
          Rows{"shown: x \u2265 \u2212100 mm", "shown: x \u2264 200 mm"});
    CHECK(clip_words(box(layout->domain_lo, layout->domain_hi), true, *layout).empty());
    scene::Render settings = up_to_27_mm(400, 400);
    CHECK(key_rows(settings, *layout) == 1);
    settings.marks.arrows = "bodies";
    CHECK(key_rows(settings, *layout) == 2);
    auto flat = std::make_shared<observe::FrameLayout>(*layout);
    flat->dimension = 2;
    CHECK(key_rows(settings, *flat) == 1); // two dimensions have no sections
}

TEST_CASE("a picture with a clip says where it cuts, beside its colours, and one without says nothing") {
    const auto layout = ball_within(0.5);
    for (const auto& [width, height] : {std::pair{1280, 720}, std::pair{640, 360}, std::pair{360, 640}}) {
        CAPTURE(width);
        Painter painter = painter_for(up_to_27_mm(width, height), layout, {});
        const Picture picture = painter.draw(at_rest(layout));
        CHECK(painter.mark_key().clip == Rows{"shown: z \u2264 27 mm"});
        CHECK(picture.crowded.empty());
        REQUIRE(painter.layout().key.width() > 0);
        CHECK(inked(picture, painter.layout().key) > 100);
        scene::Render whole = up_to_27_mm(width, height);
        whole.clip.reset();
        REQUIRE(painter.restyle(whole).ok());
        (void)painter.draw(at_rest(layout));
        CHECK(painter.layout().key.width() == 0);
    }
}

/// Letters of 8 points: 60 x 45 mm have room for the row, in 20 x 16 mm it would have to be cut.
TEST_CASE("in a small print the row is laid out like other numbers, or the picture is refused") {
    const auto layout = ball_within(0.5);
    const auto print = [&](double width_mm, double height_mm) {
        scene::Render settings = up_to_27_mm(100, 100);
        settings.paper = scene::Paper{width_mm, height_mm, 300, 8};
        settings.width = static_cast<int>(width_mm / mm_per_inch * 300);
        settings.height = static_cast<int>(height_mm / mm_per_inch * 300);
        settings.color = "none"; // nothing else needs room
        Painter painter = painter_for(settings, layout, {});
        return check_room(painter.draw(at_rest(layout)).crowded, settings);
    };
    CHECK(print(60, 45).ok());
    CHECK_FALSE(print(20, 16).ok());
}

/// The same frame and clip in two domains: in the larger one the face is named, in the smaller it cuts nothing.
TEST_CASE("strips and pairs say it once for all their pictures; what sections are cut to stands under each") {
    const auto named = ball_within(0.5), silent = ball_within(0.02);
    const scene::Render settings = up_to_27_mm(1280, 720);
    const auto differ = [](const Picture& a, const Picture& b) { return a.height != b.height || a.rgba != b.rgba; };
    CHECK(differ(strip_with(named, settings, false), strip_with(silent, settings, false)));
    scene::Render open = settings;
    open.clip.reset();
    CHECK_FALSE(differ(strip_with(named, open, true), strip_with(silent, open, true)));
    const auto pair_of = [&](const std::shared_ptr<observe::FrameLayout>& layout) {
        auto painter = PairPainter::open(settings, {layout, layout}, {"left", "right"});
        REQUIRE_MESSAGE(painter.ok(), to_string(painter.problems()));
        return painter->draw(at_rest(layout), at_rest(layout));
    };
    CHECK(differ(pair_of(named), pair_of(silent)));
}

} // namespace test_clip
