#include "about.h"
#include "fixtures.h"
#include "render/color_map.h"
#include "render/sphere_list.h"
#include "render/theme.h"

#include <bit>
#include <numbers>
#include <random>

namespace test_spheres {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using tumble::test::about;

namespace {

Vector3d viridis(double where) {
    return 255 * find_color_map("viridis", false)->at(where);
}

Vector3d dark() {
    return (255 * find_theme("dark")->background).array().round();
}

double color_distance(const Vector3d& a, const Vector3d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

} // namespace

TEST_CASE("a sphere covers pi r^2 times the scale squared pixels and has the colour of its speed") {
    auto layout = spheres({0.5});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0.2, 0.1, -0.15}, {1, 0, 0});
    Painter painter = painter_for(square_view(1), layout, bare);
    const Picture picture = painter.draw(frame);
    const double scale = 0.94 * 400 / 2; // 2 m in 400 pixels less 3 % on each side
    CHECK(painter.camera().scale == about(scale));
    const double expected = std::numbers::pi * 0.25 * scale * scale;
    CHECK(covered_pixels(picture, viridis(1), dark()) == about(expected, 0.002));
    // Front view: z to the right, y up.
    const int x = static_cast<int>(200 - 0.15 * scale);
    const int y = static_cast<int>(200 - 0.1 * scale);
    CHECK(color_distance(pixel(picture, x, y), viridis(1)) <= 1);
    CHECK(color_distance(pixel(picture, x + static_cast<int>(0.52 * scale), y), dark()) <= 1);
}

TEST_CASE("edges are smooth: a sphere's rim holds pixels at several steps between body and background") {
    auto layout = spheres({0.5});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, Vector3d::Zero(), {1, 0, 0});
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    std::array<int, 5> share{}; // of 4 samples
    for (int y = 0; y < 400; ++y) {
        for (int x = 0; x < 400; ++x) {
            const double part = (pixel(picture, x, y).y() - dark().y()) / (viridis(1).y() - dark().y());
            ++share[static_cast<std::size_t>(std::lround(4 * part))];
        }
    }
    // About 4 sqrt(2) r pixels are cut by the circle; three inner steps share them.
    const double cut = 4 * std::numbers::sqrt2 * 0.5 * 188;
    for (const int i : {1, 2, 3}) {
        CHECK(share[static_cast<std::size_t>(i)] > 0.1 * cut);
    }
}

TEST_CASE("a body with its centre outside the clip is not drawn, and what it hid is seen") {
    auto layout = spheres({0.5, 0.25});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 1, {-0.8, 0, 0}, {1, 0, 0});
    add_body(frame, 0, {0.3, 0, 0}, {0.5, 0, 0});
    scene::Render cut = square_view(1);
    cut.clip = scene::Box{{0, -1, -1}, {1, 1, 1}};
    const Picture picture = painter_for(cut, layout, bare).draw(frame);
    CHECK(color_distance(pixel(picture, 200, 200), viridis(0.5)) <= 1);
}

TEST_CASE("a clip that cuts bodies open leaves the disc of theory, flat and 0.8 as bright, of a body centred outside") {
    // The face x = 0.3 cuts the ball of 0.5 m about the origin in a circle of sqrt(0.5^2 - 0.3^2) = 0.4 m across the
    // axis, which the eye at x = -4 sees from 4.3 m; what is left of the ball lies behind it.
    for (const bool perspective : {false, true}) {
        CAPTURE(perspective);
        auto layout = spheres({0.5});
        observe::Frame frame = empty_frame(layout);
        add_body(frame, 0, Vector3d::Zero(), {1, 0, 0});
        scene::Render cut = square_view(1);
        cut.camera = "free";
        cut.projection = perspective ? "perspective" : "orthographic";
        cut.eye = {-4, 0, 0};
        cut.clip = scene::Box{{0.3, -1, -1}, {1, 1, 1}};
        cut.clip_cuts = true;
        Painter painter = painter_for(cut, layout, bare);
        const Picture picture = painter.draw(frame);
        const double scale = perspective ? painter.camera().scale / 4.3 : painter.camera().scale;
        CHECK(covered_pixels(picture, viridis(1), pixel(picture, 3, 3)) ==
              about(std::numbers::pi * 0.16 * scale * scale, 0.003));
        const Picture lit = painter_for(cut, layout, {.lettering = false}).draw(frame);
        for (const int off : {0, static_cast<int>(0.3 * scale)})
            CHECK(color_distance(pixel(lit, 200 + off, 200), 0.8 * viridis(1)) <= 2);
    }
}

TEST_CASE("a face between two bodies of a clump cuts both, and a clip about everything changes no pixel") {
    auto layout = spheres({0.3});
    layout->shapes[0].centres.push_back({0, 0, 0.4});
    layout->shapes[0].radii.push_back(0.3);
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, -0.2}, {1, 0, 0});
    scene::Render settings = square_view(1);
    const Picture whole = painter_for(settings, layout, {.lettering = false}).draw(frame);
    settings.clip = scene::Box{{-1, -1, -1}, {1, 1, 1}};
    settings.clip_cuts = true;
    CHECK(painter_for(settings, layout, {.lettering = false}).draw(frame).rgba == whole.rgba);
    // Seen from -x, the upper half is left: half of two discs whose centres are 0.4 m apart, less half their lens.
    settings.clip->lo.y() = 0;
    Painter painter = painter_for(settings, layout, bare);
    const Picture half = painter.draw(frame);
    const double r = 0.3, d = 0.4, scale = painter.camera().scale;
    const double lens = 2 * r * r * std::acos(d / (2 * r)) - d / 2 * std::sqrt(4 * r * r - d * d);
    CHECK(covered_pixels(half, viridis(1), pixel(half, 3, 3)) ==
          about((std::numbers::pi * r * r - lens / 2) * scale * scale, 0.003));
}

TEST_CASE("the nearer sphere hides the farther, whichever is drawn first") {
    auto layout = spheres({0.5, 0.25});
    for (const bool near_first : {false, true}) {
        observe::Frame frame = empty_frame(layout);
        const auto add_near = [&] { add_body(frame, 1, {-0.8, 0, 0}, {1, 0, 0}); };
        const auto add_far = [&] { add_body(frame, 0, {0.3, 0, 0}, {0.5, 0, 0}); };
        near_first ? add_near() : add_far();
        near_first ? add_far() : add_near();
        // The front camera stands at -x.
        const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
        CHECK(color_distance(pixel(picture, 200, 200), viridis(1)) <= 1);
        CHECK(color_distance(pixel(picture, 200 + 70, 200), viridis(0.5)) <= 1);
    }
}

TEST_CASE("spheres that cut each other meet in the plane that theory gives") {
    // Unequal spheres about (0, 0, -d/2) and (0, 0, d/2), seen from -x: the cut circle lies in the plane
    // z = (r1^2 - r2^2) / (2 d), which the front camera sees as an upright straight line.
    constexpr double r1 = 0.6;
    constexpr double r2 = 0.5;
    constexpr double d = 0.7;
    auto layout = spheres({r1, r2});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, -0.5 * d}, {1, 0, 0});
    add_body(frame, 1, {0, 0, 0.5 * d}, {0.25, 0, 0});
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    const double scale = 188;
    const double line = 200 + scale * (r1 * r1 - r2 * r2) / (2 * d);
    for (const int y : {150, 175, 200, 225, 250}) {
        const int left = static_cast<int>(std::floor(line)) - 2;
        const int right = static_cast<int>(std::ceil(line)) + 1;
        CHECK(color_distance(pixel(picture, left, y), viridis(1)) <= 1);
        CHECK(color_distance(pixel(picture, right, y), viridis(0.25)) <= 1);
    }
}

TEST_CASE("in perspective a sphere covers the ellipse that its cone of sight cuts from the picture") {
    // A round cone of half-angle a (sin a = r / D) whose axis leans by t from the normal of a plane at distance f cuts
    // it in an ellipse with half axes f sin a cos a / K and f sin a / sqrt(K), K = cos^2 t - sin^2 a.
    auto layout = spheres({0.5});
    scene::Render settings = square_view(1);
    settings.camera = "free";
    settings.projection = "perspective";
    settings.eye = {0, 0, 4};
    settings.field_of_view_deg = 60;
    const double f = 200 / std::tan(30 * std::numbers::pi / 180);
    for (const double z_off : {0.0, 1.2}) {
        observe::Frame frame = empty_frame(layout);
        add_body(frame, 0, {z_off, 0, 0}, {1, 0, 0});
        const double distance = std::hypot(4.0, z_off);
        const double sin_a = 0.5 / distance;
        const double cos_a = std::sqrt(1 - sin_a * sin_a);
        const double cos_t = 4 / distance;
        const double k = cos_t * cos_t - sin_a * sin_a;
        const double area = std::numbers::pi * f * f * sin_a * sin_a * cos_a / std::pow(k, 1.5);
        const Picture picture = painter_for(settings, layout, bare).draw(frame);
        CHECK(covered_pixels(picture, viridis(1), dark()) == about(area, 0.002));
    }
}

TEST_CASE("bodies are drawn where their orientation turns them") {
    auto layout = std::make_shared<observe::FrameLayout>();
    observe::FrameShape dumbbell;
    dumbbell.centres = {{0, 0, 0.5}, {0, 0, -0.5}};
    dumbbell.radii = {0.1, 0.1};
    layout->shapes.push_back(dumbbell);
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, Vector3d::Zero(), {1, 0, 0});
    frame.orientation[0] = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()); // z axis to -y
    const Picture picture = painter_for(square_view(1), layout, bare).draw(frame);
    CHECK(color_distance(pixel(picture, 200, 200 + 94), viridis(1)) <= 1);
    CHECK(color_distance(pixel(picture, 200, 200 - 94), viridis(1)) <= 1);
    CHECK(color_distance(pixel(picture, 200 + 94, 200), dark()) <= 1);
}

TEST_CASE("a sphere wholly inside its neighbours is not drawn, one that looks out a little is") {
    auto layout = std::make_shared<observe::FrameLayout>();
    observe::FrameShape shape;
    shape.centres = {{0, 0, 0}, {0.1, 0, 0}, {0.5, 0, 0}};
    shape.radii = {0.5, 0.2, 0.1};
    layout->shapes.push_back(shape);
    CHECK(showing_spheres(*layout).front() == std::vector<int>{0, 2});
}

TEST_CASE("leaving hidden spheres out does not change the picture") {
    auto layout = spheres({0.04, 0.06});
    observe::Frame frame = empty_frame(layout);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-0.8, 0.8);
    std::uniform_real_distribution<double> speed(0, 1);
    for (int i = 0; i < 12000; ++i) {
        add_body(frame, i % 2, {place(random), place(random), place(random)}, {speed(random), 0, 0});
    }
    for (const char* projection : {"orthographic", "perspective"}) {
        scene::Render settings = square_view(1);
        settings.projection = projection;
        PainterOptions all = bare;
        all.skip_hidden = false;
        const Picture whole = painter_for(settings, layout, all).draw(frame);
        const Picture quick = painter_for(settings, layout, bare).draw(frame);
        CHECK(whole.rgba == quick.rgba);
    }
}

TEST_CASE("the view stands still while bodies move, and a body that left is still drawn if it is in view") {
    auto layout = spheres({0.1});
    observe::Frame frame = empty_frame(layout);
    add_body(frame, 0, {0, 0, -1});
    add_body(frame, 0, {0, 1, 1});
    scene::Render settings = square_view(1);
    settings.view.reset();
    Painter painter = painter_for(settings, layout, bare);
    painter.draw(frame);
    const double scale = painter.camera().scale;
    frame.position[1] = {50, 0.5, 0.5};
    const Picture picture = painter.draw(frame);
    CHECK(painter.camera().scale == scale);
    const auto at = painter.camera().to_picture(frame.position[1]);
    CHECK(color_distance(pixel(picture, static_cast<int>(at.x()), static_cast<int>(at.y())), viridis(0)) <= 1);
}

TEST_CASE("frames without bodies and bodies without a place are drawn without harm") {
    auto layout = spheres({0.5});
    layout->domain_lo = Vector3d::Constant(-1);
    layout->domain_hi = Vector3d::Constant(1);
    observe::Frame frame = empty_frame(layout);
    scene::Render settings = square_view(1);
    settings.view.reset();
    Painter painter = painter_for(settings, layout, {});
    CHECK(painter.draw(frame).rgba.size() == 4U * 400 * 400);
    add_body(frame, 0, Vector3d::Constant(std::nan("")), Vector3d::Constant(std::nan("")));
    add_body(frame, 0, Vector3d::Zero(), {1, 0, 0});
    CHECK(painter.draw(frame).rgba.size() == 4U * 400 * 400);
}

TEST_CASE("every wrong setting of a picture is reported at once with its key") {
    scene::Render settings;
    settings.color = "sped";
    settings.colormap = "jet";
    settings.background = "black";
    settings.camera = "left";
    settings.range = {2.0, 1.0};
    const auto painter = Painter::open(settings, spheres({1}));
    REQUIRE(!painter.ok());
    const std::string words = to_string(painter.problems());
    for (const char* part : {"did you mean 'speed'?", "colour scale 'jet'", "background 'black'", "camera 'left'",
                             "from 2.000000 to 1.000000"}) {
        CHECK(words.find(part) != std::string::npos);
    }
    settings = {};
    settings.width = 1 << 20;
    const auto huge = Painter::open(settings, spheres({1}));
    REQUIRE(!huge.ok());
    CHECK(huge.problems().front().key == "render.width_px");
}

} // namespace test_spheres
