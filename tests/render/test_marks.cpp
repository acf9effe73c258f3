#include "about.h"
#include "fixtures.h"
#include "render/marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace test_marks {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using Eigen::Vector2d;
using tumble::test::about;

namespace {

// Front view of square_view(0.5): z to the right, y up, 376 pixels a metre about (200, 200).
constexpr double per_metre = 0.94 * 400;

scene::Render marked(const scene::Marks& marks) {
    scene::Render settings = square_view(0.5);
    settings.marks = marks;
    return settings;
}

scene::Marks arrows(const std::string& kind, std::optional<double> speed = {}) {
    scene::Marks marks;
    marks.arrows = kind;
    marks.arrow_speed = speed;
    return marks;
}

scene::Marks chains(double force) {
    scene::Marks marks;
    marks.chains = true;
    marks.chain_force = force;
    return marks;
}

scene::Marks trails(const std::vector<std::string>& names) {
    scene::Marks marks;
    marks.trails = names;
    return marks;
}

/// Columns and rows of the pixels that are nearly of that colour (0 to 1).
struct Extent {
    int left = 400, right = -1, top = 400, bottom = -1, count = 0;
};
Extent extent_of(const Picture& picture, const Vector3d& color) {
    Extent extent;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if ((pixel(picture, x, y) - 255 * color).cwiseAbs().maxCoeff() < 25) {
                extent.left = std::min(extent.left, x);
                extent.right = std::max(extent.right, x);
                extent.top = std::min(extent.top, y);
                extent.bottom = std::max(extent.bottom, y);
                ++extent.count;
            }
    return extent;
}

/// A maker with the view of the front camera that it draws for.
struct Drawing {
    scene::Render settings;
    Camera camera = *make_camera(settings, Eigen::AlignedBox3d(settings.view->lo, settings.view->hi), {0, 0, 400, 400});
    Theme theme = *find_theme("dark");
    MarkMaker maker{settings.marks};

    explicit Drawing(const scene::Marks& marks) : settings(marked(marks)) {}
    [[nodiscard]] MarkView view() const { return {camera, {0, 0, 400, 400}, 1, theme, {}}; }
    std::vector<Patch> of(const observe::Frame& frame) {
        maker.take_in(frame, view());
        return maker.patches(frame, view());
    }
    /// Without halos.
    std::vector<Patch> inked(const observe::Frame& frame, const Vector3d& color) {
        std::vector<Patch> patches = of(frame);
        std::erase_if(patches, [&](const Patch& patch) { return patch.color != color; });
        return patches;
    }
};

double width_of(const Patch& line) {
    return (line.corners[1] - line.corners[0]).norm();
}
double length_of(const Patch& line) {
    return (line.corners[2] - line.corners[1]).norm();
}

/// Of the patches of a trail its lines, which are 2.4 pixels thick.
std::vector<Patch> without_dot(std::vector<Patch> trail) {
    std::erase_if(trail, [](const Patch& patch) { return width_of(patch) != about(2.4); });
    return trail;
}

observe::FrameContact between(std::int64_t a, std::int64_t b, const Vector3d& point, const Vector3d& force) {
    return {.a = a, .b = b, .point = point, .normal = force.normalized(), .force = force};
}

const Vector3d white = find_theme("dark")->arrow;
const Vector3d orange = find_theme("dark")->chain;

} // namespace

TEST_CASE("an arrow is as long as its speed says and points where the body goes") {
    // The legend's arrow of 2 m/s is 40 pixels long: 1.5 m/s along z are 30 pixels to the right of the body's centre,
    // 3 m/s along y 60 upwards; what goes along x, towards the eye's back, is not seen.
    const auto layout = spheres({0.001});
    Painter painter = painter_for(marked(arrows("bodies", 2)), layout, bare);
    for (const auto& [velocity, right, up] :
         {std::tuple{Vector3d(7, 0, 1.5), 30, 0}, std::tuple{Vector3d(0, 3, 0), 0, 60}}) {
        observe::Frame frame = empty_frame(layout);
        add_body(frame, 0, {0, 0, 0}, velocity);
        const Extent seen = extent_of(painter.draw(frame), white);
        if (right > 0) {
            CHECK(std::abs(seen.left - 200) <= 1);
            CHECK(std::abs(seen.right - (200 + right)) <= 3); // a tip is narrower than a pixel
        } else {
            CHECK(std::abs(seen.bottom - 200) <= 1);
            CHECK(std::abs(seen.top - (200 - up)) <= 3);
        }
    }
    const MarkKey key = painter.mark_key();
    REQUIRE(key.arrow);
    CHECK(key.arrow->speed == 2);
    CHECK(key.arrow->length == 40);
    CHECK(key.rows() == 1);
}

TEST_CASE("of crowded bodies each square of the grid shows one arrow: in space the foremost body's") {
    const auto layout = spheres({0.001});
    observe::Frame frame = empty_frame(layout);
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column) {
            add_body(frame, 0, {-0.1, 0.0165 * (row - 29.5), 0.0165 * (column - 29.5)}, {0, 0, 1}); // seen first
            add_body(frame, 0, {0.1, 0.0165 * (row - 29.5), 0.0165 * (column - 29.5)}, {0, 1, 0});
        }
    Drawing drawing(arrows("bodies", 1));
    const auto drawn = drawing.inked(frame, white);
    // 59 * 0.0165 m * 376 pixels/m = 366 pixels are 15 or 16 squares of 26 pixels; an arrow is two patches.
    CHECK(drawn.size() >= 2 * 14 * 14);
    CHECK(drawn.size() <= 2 * 16 * 16);
    std::set<std::pair<int, int>> squares;
    for (std::size_t k = 0; k < drawn.size(); k += 2) {
        const Vector2d tail = 0.5 * (drawn[k].corners[0] + drawn[k].corners[1]);
        const Vector2d tip = drawn[k + 1].corners[2];
        CHECK(tip.x() - tail.x() == about(40)); // along z: the bodies in front
        CHECK(squares.emplace(static_cast<int>(tail.x() / 26), static_cast<int>(tail.y() / 26)).second);
    }
}

TEST_CASE("without a speed of its own the legend's arrow is the 98th percentile rounded up, as with colours") {
    const auto layout = spheres({0.001});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {0, 0, 0.34});
    Drawing drawing(arrows("bodies"));
    drawing.of(frame);
    CHECK(drawing.maker.key(*layout, drawing.view()).arrow->speed == about(0.5));
}

TEST_CASE("the mean field is the mass-weighted mean over the frames, and stands still where all were foreseen") {
    // Two bodies in one square: 1 m/s of a shape of 3 kg and 5 m/s of one of 1 kg make 2 m/s; a second frame of 4 and
    // 4 m/s makes 3 in the mean.
    const auto layout = spheres({0.001, 0.001});
    layout->shapes[0].mass = 3;
    layout->shapes[1].mass = 1;
    const auto frame_at = [&](double time, double heavy, double light) {
        observe::Frame frame = empty_frame(layout);
        frame.time = time;
        add_body(frame, 0, {0, 0.01, 0.01}, {0, 0, heavy});
        add_body(frame, 1, {0, 0.02, 0.02}, {0, 0, light});
        return frame;
    };
    const auto first = frame_at(0, 1, 5), second = frame_at(0.1, 4, 4);
    const auto length = [](const std::vector<Patch>& arrow) {
        REQUIRE(arrow.size() == 2);
        return (arrow[1].corners[2] - 0.5 * (arrow[0].corners[0] + arrow[0].corners[1])).x();
    };
    Drawing drawing(arrows("field", 2));
    CHECK(length(drawing.inked(first, white)) == about(40));
    CHECK(length(drawing.inked(first, white)) == about(40)); // drawn twice it counts once
    CHECK(length(drawing.inked(second, white)) == about(60));
    Drawing foreseen(arrows("field", 2));
    foreseen.maker.foresee(first, foreseen.view());
    foreseen.maker.foresee(second, foreseen.view());
    CHECK(length(foreseen.inked(first, white)) == about(60));
    CHECK(length(foreseen.inked(second, white)) == about(60));
    CHECK(foreseen.maker.key(*layout, foreseen.view()).arrow->mean);
}

TEST_CASE("an arrow of the mean field stands at the centre of mass of what its cell holds, in the plane and in space") {
    // 3 kg at y = z = 10 mm and 1 kg at 20 mm: the centre at 12.5 mm, 376 pixels a metre. In the next frame both have
    // gone 4 mm to the right, so over both it is 2 mm further.
    for (const int dimension : {2, 3}) {
        const auto layout = spheres({0.001, 0.001});
        layout->dimension = dimension;
        layout->shapes[0].mass = 3;
        layout->shapes[1].mass = 1;
        const Vector3d right = dimension == 2 ? Vector3d::UnitX() : Vector3d::UnitZ(); // side and front camera
        const auto frame_at = [&](double time, double shift) {
            observe::Frame frame = empty_frame(layout);
            frame.time = time;
            add_body(frame, 0, 0.01 * Vector3d::UnitY() + (0.01 + shift) * right, right);
            add_body(frame, 1, 0.02 * Vector3d::UnitY() + (0.02 + shift) * right, right);
            return frame;
        };
        scene::Marks marks = arrows("field", 2);
        Drawing drawing(marks);
        drawing.settings.camera = dimension == 2 ? "side" : "front";
        drawing.camera =
            *make_camera(drawing.settings, Eigen::AlignedBox3d(drawing.settings.view->lo, drawing.settings.view->hi),
                         {0, 0, 400, 400});
        for (const double shift : {0.0, 0.004}) {
            const observe::Frame frame = frame_at(shift, shift);
            drawing.maker.take_in(frame, drawing.view());
            const auto strokes = drawing.maker.strokes(frame, drawing.view());
            REQUIRE(strokes.size() == 1);
            const Vector2d middle = 0.5 * (strokes[0].points[0] + strokes[0].points[1]);
            CHECK(middle.x() == about(200 + per_metre * (0.0125 + 0.5 * shift)));
            CHECK(middle.y() == about(200 - per_metre * 0.0125));
        }
    }
}

TEST_CASE("force chains go from centre over contact to centre or wall, as thick as the force that presses") {
    const auto layout = spheres({0.1});
    observe::Frame frame = empty_frame(layout);
    for (const double z : {-0.3, -0.1, 0.1})
        add_body(frame, 0, {0, 0, z});
    frame.contacts = {between(0, 1, {0, 0, -0.2}, {0, 0, -2}), between(2, 1, {0, 0, 0}, {0, 0, 1})};
    observe::FrameContact& wall = frame.contacts->emplace_back(between(0, -1, {0, -0.1, -0.3}, {0.9, 0.5, 0}));
    wall.wall = 0;
    wall.normal = {0, 1, 0}; // 0.5 N press, 0.9 N shear
    Drawing drawing(chains(4));
    const auto lines = drawing.inked(frame, orange);
    REQUIRE(lines.size() == 5); // weakest first
    CHECK(width_of(lines[0]) == about(1));
    CHECK(length_of(lines[0]) == about(0.1 * per_metre));
    for (const std::size_t k : {1, 2})
        CHECK(width_of(lines[k]) == about(2));
    for (const std::size_t k : {3, 4}) {
        CHECK(width_of(lines[k]) == about(4));
        CHECK(length_of(lines[k]) == about(0.1 * per_metre));
    }
    CHECK(drawing.maker.key(*layout, drawing.view()).chain->thickness == 8);

    // In the picture the line of 2 N covers twice what that of 1 N does, 0.2 m or 75.2 pixels long each.
    Painter painter = painter_for(
        [&] {
            scene::Render settings = marked(chains(0.5));
            settings.color = "none";
            settings.range.reset();
            return settings;
        }(),
        layout, bare);
    frame.contacts->pop_back();
    const Picture picture = painter.draw(frame);
    std::array<int, 2> covered{};
    for (int y = 0; y < 400; ++y)
        for (int x = 88; x <= 237; ++x)
            covered[x < 200 - 0.1 * per_metre ? 0 : 1] +=
                (pixel(picture, x, y) - 255 * orange).cwiseAbs().maxCoeff() < 40 ? 1 : 0;
    CHECK(covered[0] == about(32 * 0.2 * per_metre, 0.05));
    CHECK(covered[1] == about(16 * 0.2 * per_metre, 0.08));
}

TEST_CASE("a chain through a periodic side is half a line at either side, and a clipped body has none") {
    const auto layout = spheres({0.1});
    layout->domain_lo = Vector3d::Constant(-0.4);
    layout->domain_hi = Vector3d::Constant(0.4);
    layout->periodic = {false, false, true};
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, -0.32});
    add_body(frame, 0, {0, 0, 0.3});
    frame.contacts = {between(0, 1, {0, 0, -0.41}, {0, 0, 1})};
    Drawing drawing(chains(1));
    const auto lines = drawing.inked(frame, orange);
    REQUIRE(lines.size() == 2);
    CHECK(length_of(lines[0]) == about(0.09 * per_metre));
    CHECK(length_of(lines[1]) == about(0.09 * per_metre));
    MarkView view = drawing.view();
    view.clip = Eigen::AlignedBox3d(Vector3d(-1, -1, 0), Vector3d(1, 1, 1));
    CHECK(drawing.maker.patches(frame, view).empty());
}

TEST_CASE("a trail follows a body by name or id through the frames up to now, and back") {
    const auto layout = spheres({0.01, 0.01});
    layout->shapes[1].name = "tracer";
    const auto frame_at = [&](int k) {
        observe::Frame frame = empty_frame(layout);
        frame.time = 0.1 * k;
        add_body(frame, 0, {0, 0.1 * k, 0});
        add_body(frame, 1, {0, 0, 0.1 * k});
        return frame;
    };
    Drawing drawing(trails({"tracer", "0"}));
    for (int k = 0; k < 4; ++k)
        drawing.of(frame_at(k));
    const MarkKey key = drawing.maker.key(*layout, drawing.view());
    REQUIRE(key.trails.size() == 2);
    CHECK(key.trails[0].name == "tracer");
    CHECK(key.trails[1].name == "body 0");
    const auto pieces = [&](int k, std::size_t trail) {
        int count = 0;
        for (const Patch& patch : drawing.inked(frame_at(k), key.trails[trail].color))
            count += length_of(patch) == about(0.1 * per_metre) ? 1 : 0;
        return count;
    };
    CHECK(pieces(3, 0) == 3);
    CHECK(pieces(3, 1) == 3);
    CHECK(pieces(1, 0) == 1); // back in time
    CHECK(pieces(2, 0) == 2);
}

TEST_CASE("a trail has no more lines than it has pixels, no more than 4000 steps, and keeps its shape") {
    // A circle of 0.4 m radius, or 150 pixels, gone round a hundred times in 50000 steps of 1.9 pixels. Of 30 steps a
    // turn the chords lie 150 (1 - cos(pi/30)) = 0.8 pixels inside, and uneven ones no more than three times as far.
    const auto layout = spheres({0.01});
    Drawing drawing(trails({"0"}));
    const auto frame_at = [&](int k, double turns) {
        observe::Frame frame = empty_frame(layout);
        frame.time = 1e-3 * k;
        const double angle = 2 * std::numbers::pi * turns;
        add_body(frame, 0, {0, 0.4 * std::sin(angle), 0.4 * std::cos(angle)});
        return frame;
    };
    for (int k = 0; k < 50000; ++k)
        drawing.maker.take_in(frame_at(k, k / 500.0), drawing.view());
    const Vector3d ink = drawing.maker.key(*layout, drawing.view()).trails[0].color;
    const observe::Frame last = frame_at(50000, 100);
    const auto lines = without_dot(drawing.inked(last, ink));
    CHECK(lines.size() > 2000);
    CHECK(lines.size() < 4000);
    double nearest = 1e9;
    for (const Patch& line : lines) {
        const Vector2d middle = 0.25 * (line.corners[0] + line.corners[1] + line.corners[2] + line.corners[3]);
        nearest = std::min(nearest, (middle - Vector2d(200, 200)).norm());
    }
    CHECK(nearest > 0.4 * per_metre - 2.5);

    // One that hardly moves: 3000 steps of 0.01 pixels along a line.
    Drawing resting(trails({"0"}));
    for (int k = 0; k < 3000; ++k) {
        observe::Frame frame = empty_frame(layout);
        frame.time = 1e-3 * k;
        add_body(frame, 0, {0, 0, 0.01 * k / per_metre});
        resting.maker.take_in(frame, resting.view());
    }
    observe::Frame end = empty_frame(layout);
    end.time = 3;
    add_body(end, 0, {0, 0, 30 / per_metre});
    CHECK(without_dot(resting.inked(end, ink)).size() == about(30, 0.05));
}

TEST_CASE("a trail stays within the clip and breaks where whoever looks leaps in time") {
    const auto layout = spheres({0.01});
    const auto frame_at = [&](int k) {
        observe::Frame frame = empty_frame(layout);
        frame.time = 0.01 * k;
        add_body(frame, 0, {0, 0, 0.01 * k - 0.4});
        return frame;
    };
    Drawing drawing(trails({"0"}));
    for (int k = 0; k <= 5; ++k)
        drawing.of(frame_at(k));
    const Vector3d ink = drawing.maker.key(*layout, drawing.view()).trails[0].color;
    const auto length = [&](std::vector<Patch> lines) {
        double sum = 0;
        std::erase_if(lines, [&](const Patch& patch) { return patch.color != ink; });
        for (const Patch& line : without_dot(lines))
            sum += length_of(line);
        return sum / per_metre;
    };
    drawing.maker.take_in(frame_at(55), drawing.view());
    CHECK(length(drawing.maker.patches(frame_at(55), drawing.view())) == about(0.05)); // not 0.55
    drawing.maker.take_in(frame_at(56), drawing.view());
    CHECK(length(drawing.maker.patches(frame_at(56), drawing.view())) == about(0.06));
    MarkView view = drawing.view();
    view.clip = Eigen::AlignedBox3d(Vector3d(-1, -1, -0.375), Vector3d(1, 1, 0));
    CHECK(length(drawing.maker.patches(frame_at(56), view)) == about(0.02)); // from step 3 to 5
    CHECK(drawing.maker.patches(frame_at(56), view).size() == 4);            // two lines with halos, no dot
    Drawing back = drawing;
    back.maker.take_in(frame_at(30), back.view());
    CHECK(length(back.maker.patches(frame_at(30), back.view())) == about(0.05)); // not 0.3
    // A new pace is none: the first two such steps are not known from leaps, those after them are steps.
    for (int k = 57; k < 57 + 4 * 12; k += 12)
        drawing.maker.take_in(frame_at(k), drawing.view());
    CHECK(length(drawing.maker.patches(frame_at(93), drawing.view())) == about(0.06 + 0.01 + 0.12, 0.001));
}

TEST_CASE("another clip is another mean field") {
    const auto layout = spheres({0.001});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {-0.1, 0.01, 0.01}, {0, 0, 1});
    add_body(frame, 0, {0.1, 0.02, 0.02}, {0, 0, 3});
    const auto length = [](const std::vector<Patch>& patches) {
        const auto body = std::find_if(patches.begin(), patches.end(), [](const Patch& p) { return p.color == white; });
        REQUIRE(body != patches.end());
        return (patches.back().corners[2] - 0.5 * (body->corners[0] + body->corners[1])).x();
    };
    for (const bool foreseen : {false, true}) {
        Drawing drawing(arrows("field", 2));
        if (foreseen)
            drawing.maker.foresee(frame, drawing.view());
        CHECK(length(drawing.of(frame)) == about(40)); // 2 m/s
        MarkView view = drawing.view();
        view.clip = Eigen::AlignedBox3d(Vector3d(0, -1, -1), Vector3d(1, 1, 1));
        drawing.maker.take_in(frame, view);
        CHECK(length(drawing.maker.patches(frame, view)) == about(60)); // 3 m/s alone
    }
}

TEST_CASE("pulls do not count in the scale of chains, and the key says where a line is thicker than its own") {
    const auto layout = spheres({0.1});
    observe::Frame frame = empty_frame(layout);
    for (const double z : {-0.3, -0.1, 0.1})
        add_body(frame, 0, {0, 0, z});
    frame.contacts = {between(1, 0, {0, 0, -0.2}, {0, 0, 1e-10}), between(2, 1, {0, 0, 0}, {0, 0, -7})};
    frame.contacts->back().normal = {0, 0, 1};
    scene::Marks wanted;
    wanted.chains = true;
    Drawing drawing(wanted);
    drawing.of(frame);
    CHECK(drawing.maker.key(*layout, drawing.view()).chain->force == about(1e-10));
    CHECK(!drawing.maker.key(*layout, drawing.view()).chain->beyond);
    Drawing fixed(chains(5e-11));
    fixed.of(frame);
    CHECK(fixed.maker.key(*layout, fixed.view()).chain->beyond);
}

TEST_CASE("the key says over which time a mean is taken, since when trails go, and counts those it does not name") {
    const auto layout = spheres({0.01});
    const auto frame_at = [&](double time) {
        observe::Frame frame = empty_frame(layout);
        frame.time = time;
        for (int b = 0; b < 7; ++b)
            add_body(frame, 0, {0, 0.1 * time, 0.05 * b}, {0, 0, 1});
        return frame;
    };
    scene::Marks marks = arrows("field", 1);
    for (int b = 0; b < 7; ++b)
        marks.trails.push_back(std::to_string(b));
    Drawing drawing(marks);
    const auto key = [&] { return drawing.maker.key(*layout, drawing.view()); };
    // An arrow and its time, four trails of as many as there are colours less one, the others, since when.
    CHECK(key_rows(marks) == 8);
    CHECK(key().rows() == 8);
    for (const double time : {1.0, 1.5, 2.0})
        drawing.of(frame_at(time));
    CHECK(key().arrow->over == Span{1, 2});
    CHECK(key().since == 1.0);
    CHECK(key().trails.size() == 4);
    CHECK(key().more_trails == 3);
    CHECK(key().rows() == 8);
    drawing.of(frame_at(0.5)); // whoever goes back begins anew
    CHECK(key().arrow->over == Span{0.5, 0.5});
    CHECK(key().since == 0.5);
    CHECK(key_rows(trails({"0", "1", "2", "3", "4"})) == 6);
    CHECK(key_rows(scene::Marks{}) == 0);
}

TEST_CASE("a chain outside the window is left out, whatever the order of the ids") {
    const auto layout = spheres({0.1});
    observe::Frame frame = empty_frame(layout);
    for (const double z : {-0.1, 0.1, 0.9, 1.1})
        add_body(frame, 0, {0, 0, z});
    frame.id = {7, 3, 12, 5};
    frame.contacts = {between(3, 7, {0, 0, 0}, {0, 0, 1}), between(5, 12, {0, 0, 1}, {0, 0, 1})};
    Drawing drawing(chains(1));
    CHECK(drawing.inked(frame, orange).size() == 2);
}

TEST_CASE("bodies without a colour are alike and pale, and the picture has no colour legend but the key of the lines") {
    const auto layout = spheres({0.1});
    scene::Render settings = marked(chains(1));
    settings.color = "none";
    settings.width = 1280;
    settings.height = 720;
    Painter painter = painter_for(settings, layout, {});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, 0}, {3, 0, 0});
    frame.contacts.emplace();
    const Picture picture = painter.draw(frame);
    CHECK(painter.legend_bar().width() == 0);
    const Area& key = painter.layout().key;
    REQUIRE(key.width() > 0);
    int wedge = 0;
    for (int y = static_cast<int>(key.top); y < static_cast<int>(key.bottom); ++y)
        for (int x = static_cast<int>(key.left); x < static_cast<int>(key.right); ++x)
            wedge += (pixel(picture, x, y) - 255 * orange).cwiseAbs().maxCoeff() < 40 ? 1 : 0;
    CHECK(wedge == about(0.5 * 44 * 8, 0.2)); // a triangle as long as the key's samples and as thick as 1 N
    CHECK(painter.layout().legend.bottom <= key.top);
}

} // namespace test_marks
