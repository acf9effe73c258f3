#include "fixtures.h"
#include "render/drafter.h"
#include "render/drawing_pen.h"
#include "render/paper.h"
#include "render/strip_painter.h"

#include <algorithm>
#include <variant>

namespace test_room {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;

namespace {

constexpr double half = 0.5; // m: the box |x|, |y| <= 0.5 m

/// Speeds up to 1 mm/s, and arrows with a key, so that the legend has little room.
scene::Render small_print(double width_mm, double height_mm, double font_pt = 8) {
    scene::Render settings = square_view(half);
    settings.camera = "side";
    settings.paper = scene::Paper{width_mm, height_mm, 300, font_pt};
    settings.plot = false;
    settings.color = "vx";
    settings.range = std::array{-1e-3, 1e-3};
    settings.marks.arrows = "bodies";
    settings.marks.arrow_speed = 1e-3;
    return in_fine_pixels(settings);
}

std::shared_ptr<observe::FrameLayout> one_disc() {
    auto layout = spheres({0.1});
    layout->dimension = 2;
    return layout;
}

observe::Frame disc_at(const std::shared_ptr<observe::FrameLayout>& layout, double time) {
    observe::Frame frame = empty_frame(layout);
    frame.time = time;
    add_body(frame, 0, {0, 0, 0}, {1e-3, 0, 0});
    return frame;
}

Drawing page(const scene::Render& settings) {
    const auto layout = one_disc();
    auto drafter = Drafter::open(settings, layout);
    REQUIRE_MESSAGE(drafter.ok(), to_string(drafter.problems()));
    return drafter->draw(disc_at(layout, 0.5));
}

std::vector<std::string> words_on(const Drawing& drawing) {
    std::vector<std::string> found;
    for (const Shape& shape : drawing.shapes)
        if (const auto* words = std::get_if<Words>(&shape))
            found.push_back(words->text);
    return found;
}

bool holds(const std::vector<std::string>& all, const std::string& part) {
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& words) { return words.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("a small picture for print has its units and numbers whole") {
    for (const auto& [width, height] : {std::pair{85.0, 60.0}, {85.0, 70.0}, {100.0, 60.0}, {60.0, 85.0}}) {
        CAPTURE(width);
        const Drawing drawing = page(small_print(width, height));
        CHECK(drawing.crowded.empty());
        const auto words = words_on(drawing);
        CHECK(holds(words, "[mm/s]")); // of 1 mm/s
        CHECK(holds(words, "1 mm/s")); // the arrow's
        CHECK(!holds(words, "..."));
    }
}

TEST_CASE(
    "a page as wide as two columns has room for a key of forces beside the colours, whatever is thicker than it") {
    scene::Render settings = small_print(170, 90);
    settings.marks.arrows = "none";
    settings.marks.chains = true;
    settings.marks.chain_force = 0.25;
    const auto layout = one_disc();
    observe::Frame frame = disc_at(layout, 0.5);
    add_body(frame, 0, {0.2, 0, 0}, {0, 0, 0});
    frame.contacts.emplace();
    frame.contacts->push_back({.a = 0, .b = 1, .point = {0.1, 0, 0}, .normal = {-1, 0, 0}, .force = {-2, 0, 0}});
    const Eigen::AlignedBox3d box(Vector3d(-half, -half, 0), Vector3d(half, half, 0));
    auto strip = StripDrafter::open(settings, layout, box, {.cells = 1});
    REQUIRE_MESSAGE(strip.ok(), to_string(strip.problems()));
    strip->add(frame, "");
    const Drawing drawing = strip->finish();
    const auto words = words_on(drawing);
    CHECK(std::find(words.begin(), words.end(), "0 to ≥ 0.25 N") != words.end());
    CHECK(check_room(drawing.crowded, settings).ok());
}

TEST_CASE("print without room for its numbers is refused with a size that has it, a screen's picture never") {
    const scene::Render settings = small_print(85, 30, 12);
    const Drawing drawing = page(settings);
    REQUIRE(!drawing.crowded.empty());
    const auto refused = check_room(drawing.crowded, settings);
    REQUIRE(!refused.ok());
    CHECK(refused.problems()[0].what.find("no room in 85 x 30 mm with letters of 12 pt") != std::string::npos);
    CHECK(refused.problems()[0].fix.find("--size-mm") != std::string::npos);
    scene::Render of_screen = settings;
    of_screen.paper.reset();
    CHECK(check_room(drawing.crowded, of_screen).ok());
    CHECK(check_room({}, settings).ok());
}

TEST_CASE("a colour scale has a number at each end, round or not") {
    scene::Render settings = small_print(120, 90);
    settings.marks = {};
    settings.range = std::array{0.0, 0.37};
    const auto words = words_on(page(settings));
    CHECK(holds(words, "0.37"));
    CHECK(std::any_of(words.begin(), words.end(), [](const std::string& w) { return w == "0.00"; }));
}

TEST_CASE("a strip has no more columns than leave room for the words under its cells") {
    scene::Render settings = small_print(85, 60);
    settings.marks = {};
    const auto layout = one_disc();
    // A scene as high as wide in a low picture would stand in one row of six.
    const Eigen::AlignedBox3d box(Vector3d::Constant(-half), Vector3d::Constant(half));
    StripPlan plan{.cells = 6};
    for (int k = 0; k < 6; ++k)
        plan.captions.push_back("t = 0.1" + std::to_string(k) + " s");
    auto strip = StripDrafter::open(settings, layout, box, plan);
    REQUIRE_MESSAGE(strip.ok(), to_string(strip.problems()));
    for (const std::string& words : plan.captions)
        strip->add(disc_at(layout, 0), words);
    const Drawing drawing = strip->finish();
    CHECK(drawing.crowded.empty());
    for (const std::string& words : plan.captions)
        CHECK(holds(words_on(drawing), words));
}

TEST_CASE("of names that differ at their ends a cut leaves both ends") {
    Drawing scrap;
    const DrawingPen pen(scrap, 1);
    const std::string low = "friction coefficient 0.2", high = "friction coefficient 0.4";
    const double room = 0.6 * pen.width(low, Lettering::large);
    const std::string cut = pen.shortened_inside(low, Lettering::large, room);
    CHECK(pen.width(cut, Lettering::large) <= room);
    CHECK(cut.ends_with("0.2"));
    CHECK(cut.starts_with("fric"));
    CHECK(cut != pen.shortened_inside(high, Lettering::large, room));
    CHECK(pen.shortened_inside(low, Lettering::large, 2 * room) == low);
    CHECK(pen.shortened_inside(low, Lettering::large, 1).empty());
}

} // namespace test_room
