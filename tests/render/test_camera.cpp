#include "about.h"
#include "fixtures.h"
#include "render/camera.h"
#include "scene/load.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <variant>

namespace test_camera {

using namespace tumble;
using namespace tumble::render;
using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

const AlignedBox3d box{Vector3d(-1, -2, -3), Vector3d(1, 2, 3)};
const Area area{100, 50, 700, 450};

Camera camera_for(const std::string& name, const std::string& projection) {
    scene::Render settings;
    settings.camera = name;
    settings.projection = projection;
    auto camera = make_camera(settings, box, area);
    REQUIRE(camera.ok());
    return *camera;
}

void check_at(const Vector2d& found, double x, double y) {
    CHECK(found.x() == about(x, 1e-9));
    CHECK(found.y() == about(y, 1e-9));
}

} // namespace

TEST_CASE("the front camera shows y upwards and z to the right, fitted into the area") {
    const Camera camera = camera_for("front", "orthographic");
    // 4 m of height and 6 m of width in 400 x 600 pixels less 3 % on each side: both give 94 pixels a metre.
    CHECK(camera.scale == about(94));
    check_at(camera.to_picture({0, 0, 0}), 400, 250);
    check_at(camera.to_picture({0.7, 2, 3}), 400 + 3 * 94, 250 - 2 * 94);
    check_at(camera.to_picture({-0.7, -2, -3}), 400 - 3 * 94, 250 + 2 * 94);
}

TEST_CASE("the side camera shows x to the right and y upwards") {
    const Camera camera = camera_for("side", "orthographic");
    CHECK(camera.scale == about(94));
    check_at(camera.to_picture({1, 2, 3}), 400 + 94, 250 - 2 * 94);
}

TEST_CASE("the top camera shows x to the right and z downwards") {
    const Camera camera = camera_for("top", "orthographic");
    // 6 m of z in 400 pixels.
    const double scale = 0.94 * 400 / 6;
    CHECK(camera.scale == about(scale));
    check_at(camera.to_picture({1, 0, 3}), 400 + scale, 250 + 3 * scale);
}

TEST_CASE("a perspective camera keeps the whole box within the margin and touches it") {
    const Camera camera = camera_for("front", "perspective");
    double widest = 0;
    double highest = 0;
    for (int i = 0; i < 8; ++i) {
        const Vector2d p = camera.to_picture(box.corner(static_cast<AlignedBox3d::CornerType>(i)));
        widest = std::max(widest, std::abs(p.x() - 400));
        highest = std::max(highest, std::abs(p.y() - 250));
    }
    CHECK(widest <= 0.94 * 300 * (1 + 1e-9));
    CHECK(highest <= 0.94 * 200 * (1 + 1e-9));
    CHECK(std::max(widest / 300, highest / 200) == about(0.94));
    // The field of view of 35 degrees is that of the area's height.
    CHECK(camera.scale == about(200 / std::tan(17.5 * std::numbers::pi / 180)));
}

TEST_CASE("a free camera that turns goes around its target by the scene's time, anticlockwise from above") {
    // 90 degrees a second: from x = 4 it has come to z = -4 after one second, with the world's -x on its right. Its
    // height and its distance stay.
    scene::Render settings;
    settings.camera = "free";
    settings.eye = {4, 1, 0};
    settings.turn_deg_s = 90;
    scene::Render there = settings;
    there.eye = {0, 1, -4};
    there.turn_deg_s = 0;
    const Camera camera = *make_camera(settings, box, area, 1), fixed = *make_camera(there, box, area);
    CHECK((camera.eye - there.eye).norm() < 1e-12);
    for (const Vector3d& place : {Vector3d(0.3, 0.2, 0.1), Vector3d(-1, -2, 3)})
        CHECK((camera.to_picture(place) - fixed.to_picture(place)).norm() < 1e-9);
    CHECK(camera.to_picture({-1, 0, 0}).x() > camera.to_picture({1, 0, 0}).x());
    CHECK((make_camera(settings, box, area, 4)->eye - settings.eye).norm() < 1e-12);
}

TEST_CASE("what a turning camera fits stays in the picture all around, and one size") {
    for (const char* projection : {"orthographic", "perspective"}) {
        scene::Render settings;
        settings.camera = "free";
        settings.projection = projection;
        settings.turn_deg_s = 10;
        const Camera first = *make_camera(settings, box, area);
        double widest = 0; // share of the half area
        for (int time = 0; time < 36; ++time) {
            const Camera camera = *make_camera(settings, box, area, time);
            CHECK(camera.pixels_per_metre(box.center()) == about(first.pixels_per_metre(box.center()), 1e-12));
            for (int i = 0; i < 8; ++i) {
                const Vector2d p = camera.to_picture(box.corner(static_cast<AlignedBox3d::CornerType>(i)));
                widest = std::max({widest, std::abs(p.x() - 400) / 300, std::abs(p.y() - 250) / 200});
            }
        }
        CHECK(widest <= 0.94 * 1.002);
        CHECK(widest > 0.9); // and it is no smaller than it must be
    }
}

TEST_CASE("a free perspective camera divides by the distance from its eye") {
    scene::Render settings;
    settings.camera = "free";
    settings.projection = "perspective";
    settings.eye = {0, 0, 10};
    settings.target = {0, 0, 0};
    settings.field_of_view_deg = 90; // a tangent of 1 reaches the area's edge 200 pixels from its middle
    const auto camera = make_camera(settings, box, area);
    REQUIRE(camera.ok());
    check_at(camera->to_picture({0, 0, 0}), 400, 250);
    check_at(camera->to_picture({1, 2, 0}), 400 + 200 * 0.1, 250 - 200 * 0.2);
    check_at(camera->to_picture({1, 2, 5}), 400 + 200 * 0.2, 250 - 200 * 0.4);
    CHECK(camera->pixels_per_metre({0, 0, 5}) == about(40));
}

TEST_CASE("a free parallel camera shows at its target what a perspective one with the same opening shows there") {
    scene::Render settings;
    settings.camera = "free";
    settings.eye = {3, 4, 0};
    settings.target = {0, 0, 0};
    settings.field_of_view_deg = 90;
    const auto camera = make_camera(settings, box, area);
    REQUIRE(camera.ok());
    CHECK(camera->scale == about(200.0 / 5));
    CHECK(camera->to_picture({0, 0, 1}).x() == about(400 - 40)); // right of -x looking is -z
}

/// The eye is 10 m before the target and its opening has a tangent of 1: the height's half of 200 pixels is 10 m. What
/// an area of 6:5 would show is 12 m to either side, which 100 pixels have to hold: 8.33 pixels a metre.
TEST_CASE("in a narrow picture a free camera opens wider, as far as the box needs it and no further than one of 6:5") {
    const Area narrow{0, 0, 200, 400};
    scene::Render settings;
    settings.camera = "free";
    settings.eye = {0, 0, 10};
    settings.field_of_view_deg = 90;
    const auto scale_for = [&](double half, const Area& into, bool held = false) {
        const AlignedBox3d wide(Vector3d(-half, -1, -1), Vector3d(half, 1, 1));
        return make_camera(settings, wide, into, 0, held ? std::optional(Held{}) : std::nullopt)->scale;
    };
    const double least = 100.0 / 12;
    CHECK(scale_for(2, narrow) == about(20)); // 40 of the half width of 100 pixels
    CHECK(scale_for(8, narrow) == about(0.94 * 100 / 8));
    CHECK(scale_for(100, narrow) == about(least));
    CHECK(scale_for(100, narrow, true) == about(20)); // whoever holds it chose what is seen
    CHECK(scale_for(100, {0, 0, 480, 400}) == about(20));
    // What it chose in an area of another shape stays in sight: 10 m up and down, and as much more to the sides.
    const auto held_in = [&](double shape, const Area& into) {
        return make_camera(settings, box, into, 0, Held{shape})->scale;
    };
    CHECK(held_in(0.5, narrow) == about(20));
    CHECK(held_in(1.25, narrow) == about(100.0 / 12.5));
    CHECK(held_in(1.25, {0, 0, 1000, 400}) == about(20));
    settings.turn_deg_s = 10;
    CHECK(scale_for(2, narrow) == about(least)); // it must not breathe on its way
    settings.turn_deg_s = 0;
    settings.projection = "perspective"; // pixels a unit of the tangent; the nearest corners are 9 m away
    CHECK(scale_for(2, narrow) == about(200));
    CHECK(scale_for(8, narrow) == about(0.94 * 100 * 9 / 8));
    CHECK(scale_for(100, narrow) == about(10 * least));
}

TEST_CASE("clip space and the picture agree, and the depth range holds the box") {
    for (const char* projection : {"orthographic", "perspective"}) {
        const Camera camera = camera_for("free", projection);
        const Eigen::Matrix4d clip = camera.clip_matrix(800, 500).cast<double>();
        for (int i = 0; i < 8; ++i) {
            const Vector3d corner = box.corner(static_cast<AlignedBox3d::CornerType>(i));
            const Eigen::Vector4d at = clip * camera.to_view(corner).homogeneous();
            const Vector2d expected = camera.to_picture(corner);
            CHECK(400 + 400 * at.x() / at.w() == about(expected.x(), 1e-4));
            CHECK(250 - 250 * at.y() / at.w() == about(expected.y(), 1e-4));
            CHECK(std::abs(at.z() / at.w()) < 1);
        }
    }
}

TEST_CASE("the bowls' cameras see the bowl, its collar and its lid whole, and fill the picture with them") {
    for (const auto& entry : std::filesystem::directory_iterator(TUMBLE_ROOT "/scenes")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".toml" || !(name.starts_with("bowl") || name.starts_with("specimen")))
            continue;
        CAPTURE(name);
        const scene::Scene scene = scene::load_scene(entry.path()).value();
        REQUIRE(scene.render.view);
        const AlignedBox3d seen(scene.render.view->lo, scene.render.view->hi);
        AlignedBox3d picture; // of what is seen, in halves of the area's height about its middle
        const auto add_ring = [&](const Camera& camera, const Vector3d& centre, double radius) {
            for (int k = 0; k < 360; ++k) {
                const double angle = k * std::numbers::pi / 180;
                const Vector3d point = centre + radius * Vector3d(std::cos(angle), 0, std::sin(angle));
                CHECK(seen.contains(point)); // what is not may be cut off in depth
                const Vector2d at = (camera.to_picture(point) - camera.centre) / (0.5 * area.height());
                picture.extend(Vector3d(at.x(), at.y(), 0));
            }
        };
        for (const std::string camera : {"free", "side"}) {
            scene::Render settings = scene.render;
            settings.camera = camera;
            const Camera looking = make_camera(settings, seen, area).value();
            picture.setEmpty();
            for (const scene::Wall& wall : scene.walls)
                if (const auto* bowl = std::get_if<scene::BowlShape>(&wall.shape))
                    add_ring(looking, bowl->base, bowl->radius);
                else if (const auto* collar = std::get_if<scene::CylinderShape>(&wall.shape))
                    add_ring(looking, collar->base + collar->length * collar->axis, collar->radius);
                else if (const auto* lid = std::get_if<scene::DiscShape>(&wall.shape))
                    add_ring(looking, lid->centre, lid->radius);
            REQUIRE_FALSE(picture.isEmpty());
            const double across = picture.max().cwiseMax(-picture.min()).x() * area.height() / area.width();
            const double along = picture.max().cwiseMax(-picture.min()).y();
            CHECK(std::max(across, along) < 0.97); // the margin of cameras that fit themselves is 3 %
            CHECK(std::max(across, along) > 0.85);
        }
    }
}

TEST_CASE("what a camera cannot do is said with the key") {
    const auto key_of = [](auto change) {
        scene::Render settings;
        change(settings);
        const auto camera = make_camera(settings, box, area);
        REQUIRE(!camera.ok());
        return camera.problems().front().key;
    };
    CHECK(key_of([](scene::Render& s) { s.camera = "back"; }) == "render.camera");
    CHECK(key_of([](scene::Render& s) { s.projection = "fisheye"; }) == "render.projection");
    CHECK(key_of([](scene::Render& s) { s.field_of_view_deg = 180; }) == "render.field_of_view_deg");
    CHECK(key_of([](scene::Render& s) {
              s.camera = "free";
              s.eye = s.target = {1, 1, 1};
          }) == "render.eye");
}

TEST_CASE("the bounds of a frame hold every sphere and every moved wall, and the domain when there is nothing") {
    auto layout = testing::spheres({0.5});
    layout->domain_lo = {-9, -9, -9};
    layout->domain_hi = {9, 9, 9};
    observe::Frame frame = testing::empty_frame(layout);
    CHECK(bounds_of(frame).max().x() == 9);
    testing::add_body(frame, 0, {1, 2, 3});
    CHECK((bounds_of(frame).min() - Vector3d(0.5, 1.5, 2.5)).norm() < 1e-12);
    layout->walls.push_back(testing::pane(1, 1, 0.5));
    frame.walls.resize(1);
    frame.walls[0].translation = {-4, 0, 0};
    CHECK(bounds_of(frame).min().x() == -4);
    CHECK(bounds_of(frame).max().z() == 3.5);
}

/// Bodies that are passed over lie within what was seen before: the box is that of each frame merged, to the bit.
TEST_CASE("the bounds over many frames are those of each frame merged") {
    auto layout = testing::spheres({0.5});
    layout->shapes[0].centres = {Vector3d(0.3, 0.1, 0), Vector3d(-0.2, 0, 0.4)};
    layout->shapes[0].radii = {0.2, 0.1};
    layout->walls.push_back(testing::pane(1, 1, 0.5));
    BoundsOver over(layout);
    Eigen::AlignedBox3d merged;
    for (int k = 0; k < 200; ++k) {
        observe::Frame frame = testing::empty_frame(layout);
        for (int b = 0; b < 5; ++b) {
            const double t = 0.37 * k + 1.7 * b; // by irregular steps outwards
            testing::add_body(frame, 0, (1 + 0.01 * k) * Vector3d(std::sin(t), std::sin(2.3 * t), std::cos(1.1 * t)));
            frame.orientation.back() = Eigen::AngleAxisd(t, Vector3d(1, t, 2).normalized());
        }
        frame.walls.assign(1, {});
        frame.walls[0].translation.x() = k % 3 == 0 ? -0.02 * k : 1;
        over.take_in(frame);
        merged.extend(bounds_of(frame));
    }
    CHECK(over.box().min() == merged.min());
    CHECK(over.box().max() == merged.max());
}

} // namespace test_camera
