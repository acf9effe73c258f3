#include "about.h"
#include "fixtures.h"
#include "render/marks.h"

#include <algorithm>
#include <optional>

namespace test_trails {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

// Front view of square_view(0.5): z to the right, y up, 376 pixels a metre.
constexpr double per_metre = 0.94 * 400;

/// Follows bodies as they are seen by the front camera.
struct Follower {
    scene::Render settings = square_view(0.5);
    Camera camera = *make_camera(settings, Eigen::AlignedBox3d(settings.view->lo, settings.view->hi), {0, 0, 400, 400});
    Theme theme = *find_theme("dark");
    MarkMaker maker;

    explicit Follower(const std::vector<std::string>& bodies) {
        scene::Marks marks;
        marks.trails = bodies;
        maker.restyle(marks);
    }
    [[nodiscard]] MarkView view() const { return {camera, {0, 0, 400, 400}, 1, theme, {}}; }
    void take_in(const observe::Frame& frame) { maker.take_in(frame, view()); }
    [[nodiscard]] std::vector<Stroke> strokes(const observe::Frame& frame) const {
        return maker.strokes(frame, view());
    }
};

/// m, of the lines of all trails.
double length_of(const std::vector<Stroke>& strokes) {
    double pixels = 0;
    for (const Stroke& stroke : strokes)
        for (std::size_t k = 0; stroke.kind == Stroke::Kind::way && k + 1 < stroke.points.size(); k += 2)
            pixels += (stroke.points[k + 1] - stroke.points[k]).norm();
    return pixels / per_metre;
}

} // namespace

TEST_CASE("a trail breaks where a frame is missing of a known pace, or its body was away or is another now") {
    const auto layout = spheres({0.01});
    // 10 mm to the right each 10 ms.
    const auto frame_at = [&](int k, std::int64_t id = 3) {
        observe::Frame frame = empty_frame(layout);
        frame.time = 0.01 * k;
        add_body(frame, 0, {0, 0, 0.01 * k - 0.4});
        frame.id[0] = id;
        return frame;
    };
    const auto length_with = [&](std::optional<double> pace, const std::vector<observe::Frame>& frames) {
        Follower follower({layout->shapes[0].name});
        if (pace)
            follower.maker.expect_pace(*pace);
        for (const observe::Frame& frame : frames)
            follower.take_in(frame);
        return length_of(follower.strokes(frames.back()));
    };
    CHECK(length_with(0.01, {frame_at(0), frame_at(1), frame_at(2), frame_at(3)}) == about(0.03));
    const std::vector<observe::Frame> one_missing{frame_at(0), frame_at(1), frame_at(3), frame_at(4)};
    CHECK(length_with(0.01, one_missing) == about(0.02));
    CHECK(length_with({}, one_missing) == about(0.04)); // as somebody looks who was a little late
    CHECK(length_with(0.01, {frame_at(0), frame_at(2)}) == 0);
    observe::Frame nobody = empty_frame(layout);
    nobody.time = 0.02;
    CHECK(length_with(0.01, {frame_at(0), frame_at(1), nobody, frame_at(3), frame_at(4)}) == about(0.02));
    CHECK(length_with({}, {frame_at(0), frame_at(1), frame_at(2, 4), frame_at(3, 4)}) == about(0.02));
}

TEST_CASE("trails without a colour of their own in the key are of one that no other has, and the key shows it") {
    const auto layout = spheres({0.01});
    observe::Frame frame = empty_frame(layout);
    std::vector<std::string> nine;
    for (int b = 0; b < 9; ++b) {
        add_body(frame, 0, {0, 0.05 * b - 0.2, 0});
        nine.push_back(std::to_string(b));
    }
    Follower follower(nine);
    follower.take_in(frame);
    const MarkKey key = follower.maker.key(*layout, follower.view());
    REQUIRE(key.trails.size() == 4);
    REQUIRE(key.more_color);
    std::vector<Eigen::Vector3d> dots;
    for (const Stroke& stroke : follower.strokes(frame))
        if (stroke.kind == Stroke::Kind::dot)
            dots.push_back(stroke.ink.color);
    REQUIRE(dots.size() == 9);
    for (const MarkKey::Trail& trail : key.trails)
        CHECK(std::count(dots.begin(), dots.end(), trail.color) == 1);
    CHECK(std::count(dots.begin(), dots.end(), *key.more_color) == 5);
    const Follower five({"0", "1", "2", "3", "4"});
    CHECK(!five.maker.key(*layout, five.view()).more_color);
}

TEST_CASE("the key names the trails that there are, and none of nobody") {
    const auto layout = spheres({0.01});
    observe::Frame frame = empty_frame(layout);
    for (int b = 0; b < 6; ++b)
        add_body(frame, 0, {0, 0, 0.05 * b}, {0, 0, 1});
    Follower known({"0", "99999"});
    known.take_in(frame);
    const MarkKey key = known.maker.key(*layout, known.view());
    REQUIRE(key.trails.size() == 1);
    CHECK(key.trails[0].name == "body 0");
    Follower many({"0", "1", "2", "3", "4", "99998", "5", "99999"});
    const int more = many.maker.key(*layout, many.view()).more_trails;
    many.take_in(frame);
    CHECK(many.maker.key(*layout, many.view()).more_trails == more - 2);
    Follower nobody({"99999"});
    nobody.take_in(frame);
    CHECK(nobody.maker.key(*layout, nobody.view()).rows() == 0);
}

} // namespace test_trails
