#include "about.h"
#include "fixtures.h"
#include "render/color_map.h"
#include "render/theme.h"

namespace test_lettering {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

double color_distance(const Vector3d& a, const Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

observe::Frame one_body(std::shared_ptr<observe::FrameLayout>& layout) {
    layout = spheres({0.2});
    layout->title = "A title";
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, Vector3d::Zero(), {0.5, 0, 0});
    return frame;
}

PlotLine rising_line() {
    PlotLine line{"kinetic energy", "J", {}, {}};
    for (int i = 0; i <= 100; ++i) {
        line.times.push_back(0.01 * i);
        line.values.push_back(0.002 * i);
    }
    return line;
}

scene::Render settings_of(int width, int height, const std::string& background) {
    scene::Render settings = square_view(1);
    settings.width = width;
    settings.height = height;
    settings.background = background;
    return settings;
}

bool differs(const Picture& picture, int x, int y, const Vector3d& from) {
    return color_distance(pixel(picture, x, y), from) > 12;
}

/// Whether anything is drawn inside an area.
bool has_ink(const Picture& picture, const Area& area, const Vector3d& background) {
    for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y) {
        for (int x = static_cast<int>(area.left); x < static_cast<int>(area.right); ++x) {
            if (differs(picture, x, y, background)) {
                return true;
            }
        }
    }
    return false;
}

bool inside(const Area& area, int x, int y, double slack) {
    return x >= area.left - slack && x < area.right + slack && y >= area.top - slack && y < area.bottom + slack;
}

} // namespace

TEST_CASE("the colour bar shows the colours that bodies of those values have") {
    for (const int width : {640, 1280}) {
        std::shared_ptr<observe::FrameLayout> layout;
        const observe::Frame frame = one_body(layout);
        Painter painter = painter_for(settings_of(width, width * 9 / 16, "dark"), layout, {});
        const Picture picture = painter.draw(frame);
        const Area bar = painter.legend_bar();
        REQUIRE(bar.height() > bar.width());
        const auto map = find_color_map("viridis", false);
        const int x = static_cast<int>(0.5 * (bar.left + bar.right));
        for (const double share : {0.05, 0.25, 0.5, 0.75, 0.95}) {
            const double y = bar.bottom - share * bar.height();
            const double middle = (bar.bottom - (std::floor(y) + 0.5)) / bar.height(); // of the pixel that is read
            CHECK(color_distance(pixel(picture, x, static_cast<int>(y)), 255 * map->at(middle)) <= 2);
        }
    }
}

TEST_CASE("the lying colour bar runs from left to right") {
    std::shared_ptr<observe::FrameLayout> layout;
    const observe::Frame frame = one_body(layout);
    scene::Render settings = settings_of(1280, 720, "dark");
    settings.view = scene::Box{{-1, -0.2, -1}, {1, 0.2, 1}};
    Painter painter = painter_for(settings, layout, {});
    const Picture picture = painter.draw(frame);
    const Area bar = painter.legend_bar();
    REQUIRE(bar.width() > bar.height());
    const auto map = find_color_map("viridis", false);
    const int y = static_cast<int>(0.5 * (bar.top + bar.bottom));
    for (const double share : {0.1, 0.5, 0.9}) {
        const double x = bar.left + share * bar.width();
        const double middle = (std::floor(x) + 0.5 - bar.left) / bar.width();
        CHECK(color_distance(pixel(picture, static_cast<int>(x), y), 255 * map->at(middle)) <= 2);
    }
}

TEST_CASE("the scale bar is as long as its length at the picture's scale") {
    std::shared_ptr<observe::FrameLayout> layout;
    const observe::Frame frame = one_body(layout);
    Painter painter = painter_for(settings_of(1280, 720, "dark"), layout, {});
    const Picture picture = painter.draw(frame);
    const Area area = painter.layout().scale_bar;
    const Vector3d text = 255 * find_theme("dark")->text;
    // The longest run of the text's colour in a row of its area is the bar.
    int longest = 0;
    for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y) {
        int run = 0;
        for (int x = static_cast<int>(area.left) - 2; x < static_cast<int>(area.right); ++x) {
            run = color_distance(pixel(picture, x, y), text) < 30 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    const double metres = longest / painter.camera().scale;
    // 2 m in about 620 pixels: the round length that fits into some 200 pixels is 0.5 m.
    CHECK(metres == about(0.5, 1.5 / longest));
}

TEST_CASE("a white background is white and a dark one is dark wherever nothing is drawn") {
    for (const char* background : {"white", "dark"}) {
        std::shared_ptr<observe::FrameLayout> layout;
        const observe::Frame frame = one_body(layout);
        Painter painter = painter_for(settings_of(640, 360, background), layout, {});
        const Picture picture = painter.draw(frame, rising_line());
        const Vector3d expected = 255 * find_theme(background)->background;
        CHECK(color_distance(pixel(picture, 0, 0), expected) <= 0.5);
        CHECK(color_distance(pixel(picture, 639, 359), expected) <= 0.5);
        // Between the panels and around the sphere more than half of the picture stays free.
        int free = 0;
        for (int y = 0; y < 360; ++y) {
            for (int x = 0; x < 640; ++x) {
                free += color_distance(pixel(picture, x, y), expected) <= 0.5 ? 1 : 0;
            }
        }
        CHECK(free > 640 * 360 / 2);
    }
}

TEST_CASE("every panel holds its writing and nothing is written outside of them, at all sizes") {
    const std::vector<std::array<int, 2>> sizes{{640, 360}, {1280, 720}, {1920, 1080}, {700, 700}};
    for (const auto& [width, height] : sizes) {
        for (const double flat : {1.0, 0.15}) {
            CAPTURE(width);
            CAPTURE(flat);
            std::shared_ptr<observe::FrameLayout> layout;
            observe::Frame frame = one_body(layout);
            layout->title = "A title that is far too long for any picture because its author wanted to say everything "
                            "that could be said about the machine, the media, the load and the day of the test";
            frame.position[0] = {0, 500, 0}; // out of sight
            frame.time = 123.456;
            scene::Render settings = settings_of(width, height, "white");
            settings.view = scene::Box{{-1, -flat, -1}, {1, flat, 1}};
            settings.range = {0.0, 0.0371};
            Painter painter = painter_for(settings, layout, {});
            PlotLine line = rising_line();
            line.label = "a measure with a very long name that does not fit above the plot";
            line.values.back() = -1234.5;
            const Picture picture = painter.draw(frame, line);
            const Layout& at = painter.layout();
            const Vector3d white = Vector3d::Constant(255);
            for (const Area& panel : {at.title, at.time, at.legend, at.plot, at.scale_bar}) {
                CHECK(has_ink(picture, panel, white));
            }
            int stray = 0;
            const double slack = 2 * at.unit;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    if (differs(picture, x, y, white) && !inside(at.title, x, y, slack) &&
                        !inside(at.time, x, y, slack) && !inside(at.legend, x, y, slack) &&
                        !inside(at.plot, x, y, slack) && !inside(at.scale_bar, x, y, slack)) {
                        ++stray;
                    }
                }
            }
            CHECK(stray == 0);
        }
    }
}

TEST_CASE("a plot without points, with gaps, and with one point is drawn without harm") {
    std::shared_ptr<observe::FrameLayout> layout;
    const observe::Frame frame = one_body(layout);
    Painter painter = painter_for(settings_of(640, 360, "dark"), layout, {});
    const Vector3d line_color = 255 * find_theme("dark")->line;
    const auto inked = [&](const PlotLine& line) {
        const Picture picture = painter.draw(frame, line);
        const Area area = painter.layout().plot;
        int count = 0;
        for (int y = static_cast<int>(area.top); y < static_cast<int>(area.bottom); ++y) {
            for (int x = static_cast<int>(area.left); x < static_cast<int>(area.right); ++x) {
                count += color_distance(pixel(picture, x, y), line_color) < 40 ? 1 : 0;
            }
        }
        return count;
    };
    CHECK(inked({"energy", "J", {}, {}}) == 0);
    CHECK(inked({"energy", "J", {0}, {1}}) > 0);
    CHECK(inked({"energy", "J", {0, 1, 2}, {std::nan(""), std::nan(""), std::nan("")}}) == 0);
    // The frame's time is 0: only the first of these points has happened.
    PlotLine line = rising_line();
    const int now = inked(line);
    for (double& t : line.times) {
        t -= 1;
    }
    CHECK(inked(line) > 4 * now);
}

TEST_CASE("what goes on beyond the view is cut off before the panels") {
    auto layout = spheres({0.2});
    layout->walls = {pane(50, 50, 1)};
    const observe::Frame frame = empty_frame(layout);
    for (const double flat : {1.0, 0.2}) {
        scene::Render settings = settings_of(1280, 720, "dark");
        settings.view = scene::Box{{-1, -flat, -1}, {1, flat, 1}};
        Painter painter = painter_for(settings, layout, {});
        const Picture picture = painter.draw(frame, rising_line());
        const Vector3d dark = 255 * find_theme("dark")->background;
        const Area window = painter.layout().window;
        for (const Area& panel : {painter.layout().title, painter.layout().legend, painter.layout().scale_bar})
            CHECK(!differs(picture, static_cast<int>(panel.right) - 2, static_cast<int>(panel.top) + 1, dark));
        CHECK(differs(picture, static_cast<int>(window.left) + 1, static_cast<int>(window.top) + 2, dark));
        CHECK(differs(picture, static_cast<int>(window.right) - 2, static_cast<int>(window.bottom) - 2, dark));
    }
}

TEST_CASE("a curve of zeros has no other number on its axis than 0") {
    std::shared_ptr<observe::FrameLayout> layout;
    observe::Frame frame = one_body(layout);
    frame.time = 1;
    Painter painter = painter_for(settings_of(640, 360, "dark"), layout, {});
    const Picture picture = painter.draw(frame, {"energy", "J", {0, 1}, {0, 0}});
    const Area plot = painter.layout().plot;
    const Area above{plot.left, plot.top + 0.3 * plot.height(), plot.right, plot.top + 0.6 * plot.height()};
    CHECK(!has_ink(picture, above, 255 * find_theme("dark")->background));
    CHECK(has_ink(picture, plot, 255 * find_theme("dark")->background));
}

TEST_CASE("the present value stands at the right of a plot's label, and nothing where it is not known") {
    std::shared_ptr<observe::FrameLayout> layout;
    observe::Frame frame = one_body(layout);
    frame.time = 1;
    Painter painter = painter_for(settings_of(640, 360, "dark"), layout, {});
    const auto with = [&](double now) { return painter.draw(frame, {"energy", "J", {0, 1, 2}, {0, now, 1}}); };
    const Vector3d dark = 255 * find_theme("dark")->background;
    const Picture quarter = with(0.25), other = with(0.75);
    const Area& plot = painter.layout().plot;
    const Area right{plot.left + 0.6 * plot.width(), plot.top, plot.right, plot.top + 0.1 * plot.height()};
    CHECK(has_ink(quarter, right, dark));
    CHECK(!has_ink(with(std::nan("")), right, dark));
    int changed = 0; // 0.25 and 0.75 share two of their digits
    for (int y = static_cast<int>(right.top); y < static_cast<int>(right.bottom); ++y)
        for (int x = static_cast<int>(right.left); x < static_cast<int>(right.right); ++x)
            changed += differs(other, x, y, pixel(quarter, x, y)) ? 1 : 0;
    CHECK(changed > 0);
}

TEST_CASE("the time axis of a run that goes on stands still") {
    std::shared_ptr<observe::FrameLayout> layout;
    observe::Frame frame = one_body(layout);
    Painter painter = painter_for(settings_of(640, 360, "dark"), layout, {});
    PlotLine whole{"energy", "J", {}, {}};
    PlotLine half{"energy", "J", {}, {}, 1.0};
    for (int i = 0; i <= 100; ++i)
        for (PlotLine* line : {&whole, &half})
            if (line == &whole || i <= 50) {
                line->times.push_back(0.01 * i);
                line->values.push_back(i % 2);
            }
    frame.time = 0.5;
    CHECK(painter.draw(frame, whole).rgba == painter.draw(frame, half).rgba);
}

TEST_CASE("two painters of different sizes draw in turn and on other threads") {
    std::shared_ptr<observe::FrameLayout> layout;
    const observe::Frame frame = one_body(layout);
    Painter small = painter_for(settings_of(640, 360, "dark"), layout, {});
    Painter large = painter_for(settings_of(800, 600, "white"), layout, {});
    const Picture first = small.draw(frame);
    const Picture other = large.draw(frame);
    CHECK(small.draw(frame).rgba == first.rgba);
    CHECK(large.draw(frame).rgba == other.rgba);
}

} // namespace test_lettering
