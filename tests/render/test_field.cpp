#include "fixtures.h"
#include "render/color_map.h"
#include "render/field_painter.h"

#include <limits>

namespace test_field {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;

namespace {

/// A square of 1 m across z at z = 0, whose values go from 0 at x = -0.5 m to 1 at x = 0.5 m.
Field ramp() {
    Field field;
    field.points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    field.triangles = {{0, 1, 2}, {0, 2, 3}};
    field.values = {0, 1, 1, 0};
    field.label = "share";
    return field;
}

/// Along -z, in parallel; too small for letters, so that all of the picture is the square's.
scene::Render settings_of(int width, int height) {
    scene::Render settings;
    settings.camera = "side";
    settings.colormap = "viridis";
    settings.background = "white";
    settings.width = width;
    settings.height = height;
    return settings;
}

FieldPicture painted(const scene::Render& settings, const Field& field, const FieldLook& look,
                     const observe::Frame* around = nullptr) {
    auto picture = paint_field(settings, field, look, around);
    REQUIRE_MESSAGE(picture, to_string(picture.problems()));
    return std::move(*picture);
}

/// sRGB, 0 to 255, where a point of the world is seen.
Vector3d seen(const FieldPicture& painted, const Vector3d& world) {
    const Eigen::Vector2d at = painted.camera.to_picture(world);
    const auto pixel = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(painted.picture.width) +
                       static_cast<std::size_t>(at.x());
    const std::uint8_t* bytes = &painted.picture.rgba[4 * pixel];
    return {static_cast<double>(bytes[0]), static_cast<double>(bytes[1]), static_cast<double>(bytes[2])};
}

double off(const Vector3d& color, const Vector3d& meant) {
    return (color - meant).cwiseAbs().maxCoeff();
}

const FieldLook bare{.title = "", .note = "", .span = Span{0, 1}, .lit = false};

} // namespace

TEST_CASE("a field's pixel has the scale's colour at the value there, beyond the ends that of the end") {
    const scene::Render settings = settings_of(200, 150);
    const ColorMap map = find_color_map("viridis", false).value();
    const FieldPicture whole = painted(settings, ramp(), bare);
    FieldLook narrow = bare;
    narrow.span = Span{0.25, 0.5};
    const FieldPicture part = painted(settings, ramp(), narrow);
    for (const double x : {-0.45, -0.2, 0.0, 0.13, 0.42}) {
        CAPTURE(x);
        // A pixel is 7 mm wide here: values within one belong to colours that differ by a few of 255.
        CHECK(off(seen(whole, {x, 0.1, 0}), 255 * map.at(x + 0.5)) < 6);
        CHECK(off(seen(part, {x, -0.1, 0}), 255 * map.at((x + 0.25) / 0.25)) < 12);
    }
    CHECK(off(seen(whole, {0.6, 0, 0}), {255, 255, 255}) == 0);
}

TEST_CASE("without a range colours reach to the largest values, from 0 or to both sides of it") {
    const scene::Render settings = settings_of(200, 150);
    FieldLook look = bare;
    look.span.reset();
    CHECK(painted(settings, ramp(), look).span == Span{0, 1});
    Field signs = ramp();
    signs.has_sign = true;
    signs.values = {-2, 1, 1, -2};
    CHECK(painted(settings, signs, look).span == Span{-2, 2});
}

TEST_CASE("bodies behind a field are hidden, those before it are a veil, and the part itself is not drawn twice") {
    auto layout = spheres({0.1});
    layout->walls.push_back(pane(0.5, 0.5, 1));
    observe::Frame frame = empty_frame(layout);
    // The camera looks along -z; the pane, across x, is the part's wall.
    add_body(frame, 0, {0.2, 0, -0.3});
    add_body(frame, 0, {-0.2, 0, 0.3});
    add_body(frame, 0, {0.2, 0.7, 0.3});
    scene::Render settings = settings_of(240, 180);
    settings.view = scene::Box{{-0.9, -0.9, -0.6}, {0.9, 0.9, 0.6}};
    FieldLook look = bare;
    look.part = 0;
    look.veil = 0;
    const FieldPicture without = painted(settings, ramp(), bare);
    const FieldPicture none = painted(settings, ramp(), look, &frame);
    look.veil = 1;
    const FieldPicture full = painted(settings, ramp(), look, &frame);
    look.veil = 0.25;
    const FieldPicture quarter = painted(settings, ramp(), look, &frame);
    const Vector3d behind(0.2, 0, 0), before(-0.2, 0, 0), beside(0.2, 0.7, 0);
    for (const FieldPicture* picture : {&none, &full, &quarter}) {
        CHECK(off(seen(*picture, behind), seen(without, behind)) < 2);
        CHECK(off(seen(*picture, beside), seen(none, beside)) < 2);
    }
    CHECK(off(seen(none, before), seen(without, before)) < 2);
    const Vector3d body = seen(full, before);
    CHECK(body.maxCoeff() - body.minCoeff() < 12); // grey
    CHECK(off(body, seen(without, before)) > 40);
    CHECK(off(seen(quarter, before), 0.25 * body + 0.75 * seen(without, before)) < 2);
    CHECK(off(seen(none, beside), {255, 255, 255}) > 40);
}

TEST_CASE("a picture large enough says what its colours mean, and the bar holds the scale's colours") {
    const scene::Render settings = settings_of(640, 400);
    FieldLook look = bare;
    look.title = "a ramp";
    const FieldPicture picture = painted(settings, ramp(), look);
    REQUIRE(picture.layout.lettered);
    const Area& bar = picture.legend_bar;
    REQUIRE(bar.height() > 50);
    const ColorMap map = find_color_map("viridis", false).value();
    const auto color_at = [&](double share) {
        const auto x = static_cast<std::size_t>(0.5 * (bar.left + bar.right));
        const auto y = static_cast<std::size_t>(bar.bottom - share * bar.height());
        const std::uint8_t* bytes = &picture.picture.rgba[4 * (y * 640 + x)];
        return Vector3d(bytes[0], bytes[1], bytes[2]);
    };
    for (const double share : {0.2, 0.5, 0.8})
        CHECK(off(color_at(share), 255 * map.at(share)) < 8);
}

TEST_CASE("a field that cannot be drawn is refused") {
    const scene::Render settings = settings_of(200, 150);
    const auto refused = [&](const Field& field) { return paint_field(settings, field, bare).problems().at(0).what; };
    CHECK(refused({}).starts_with("a field without points"));
    Field wrong = ramp();
    wrong.triangles.push_back({0, 1, 4});
    CHECK(refused(wrong).starts_with("a field without points, values or corners"));
    Field odd = ramp();
    odd.values[2] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(odd) == "a field has a point or value that is not finite");
    scene::Render blind = settings;
    blind.camera = "sideways";
    CHECK(paint_field(blind, ramp(), bare).problems().at(0).key == "render.camera");
}

} // namespace test_field
