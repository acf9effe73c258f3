#include "about.h"
#include "render/color_map.h"
#include "render/quantity.h"
#include "render/theme.h"
#include "scene/keys.h"

#include <bit>
#include <cmath>
#include <doctest/doctest.h>

namespace test_color_map {

using namespace tumble;
using namespace tumble::render;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

std::vector<std::string> words_of(const char* key) {
    return scene::find_key(*scene::find_table("render"), key)->words;
}

/// CIELAB of an sRGB colour (0 to 1), white D65; IEC 61966-2-1 and CIE 15.
Vector3d lab(const Vector3d& srgb) {
    Vector3d linear;
    for (int i = 0; i < 3; ++i) {
        linear[i] = srgb[i] > 0.04045 ? std::pow((srgb[i] + 0.055) / 1.055, 2.4) : srgb[i] / 12.92;
    }
    Eigen::Matrix3d to_xyz;
    to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vector3d xyz = to_xyz * linear;
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double fx = f(xyz.x() / 0.9505);
    const double fy = f(xyz.y());
    const double fz = f(xyz.z() / 1.089);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

ColorMap map_named(const std::string& name) {
    auto map = find_color_map(name, false);
    REQUIRE(map.ok());
    return *map;
}

} // namespace

TEST_CASE("viridis, cividis and inferno grow lighter at every step and by even amounts") {
    for (const char* name : {"viridis", "cividis", "inferno"}) {
        CAPTURE(name);
        const ColorMap map = map_named(name);
        const double first = lab(map.at(0)).x();
        const double rise = lab(map.at(1)).x() - first;
        CHECK(rise > 70);
        double before = first;
        for (int i = 1; i <= 100; ++i) {
            const double lightness = lab(map.at(i / 100.0)).x();
            CHECK(lightness > before);
            // Their steps are even in CAM02-UCS; CIELAB, another model of the eye, sees them within 7 % of the rise.
            CHECK(std::abs(lightness - first - rise * i / 100.0) < 0.07 * rise);
            before = lightness;
        }
    }
}

TEST_CASE("no scale begins or ends in a colour of the dark background, and none is darker than it") {
    const Vector3d background = lab(find_theme("dark")->background);
    for (const char* name : {"viridis", "cividis", "inferno", "coolwarm"}) {
        CAPTURE(name);
        const ColorMap map = map_named(name);
        for (const double end : {0.0, 1.0}) {
            CHECK(lab(map.at(end)).x() > background.x() + 5);
            CHECK((lab(map.at(end)) - background).norm() > 25); // of the 2 or so that eyes tell apart
        }
    }
}

TEST_CASE("coolwarm is lightest and without hue in its middle, and its arms are alike in lightness") {
    const ColorMap map = map_named("coolwarm");
    const Vector3d middle = lab(map.at(0.5));
    CHECK(middle.x() == about(88, 0.01)); // Moreland's white point, Msh (88, 0, 0)
    CHECK(std::hypot(middle.y(), middle.z()) < 1);
    double before = middle.x();
    for (int i = 1; i <= 16; ++i) {
        const double cool = lab(map.at(0.5 - i / 32.0)).x();
        const double warm = lab(map.at(0.5 + i / 32.0)).x();
        CHECK(std::abs(cool - warm) < 1.5);
        CHECK(cool < before);
        before = cool;
    }
    // The published ends.
    CHECK((255 * map.at(0) - Vector3d(59, 76, 192)).cwiseAbs().maxCoeff() < 2);
    CHECK((255 * map.at(1) - Vector3d(180, 4, 38)).cwiseAbs().maxCoeff() < 2);
}

TEST_CASE("published colours of the tables are met") {
    // Entries 0, 128 and 255 of the published viridis: (68,1,84), (33,145,140), (253,231,37).
    const ColorMap map = map_named("viridis");
    CHECK((255 * map.at(0) - Vector3d(68, 1, 84)).cwiseAbs().maxCoeff() < 1);
    CHECK((255 * map.at(128 / 255.0) - Vector3d(33, 145, 140)).cwiseAbs().maxCoeff() < 2);
    CHECK((255 * map.at(1) - Vector3d(253, 231, 37)).cwiseAbs().maxCoeff() < 1);
}

TEST_CASE("values beyond the ends keep the end's colour and a missing value is magenta") {
    const ColorMap map = map_named("inferno");
    CHECK(map.at(-3) == map.at(0));
    CHECK(map.at(7) == map.at(1));
    CHECK(map.at(std::nan("")) == Vector3d(1, 0, 1));
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(map.bytes_at(1));
    CHECK(static_cast<int>(bytes[0]) == 0xfc);
    CHECK(static_cast<int>(bytes[2]) == 0xa4);
    CHECK(static_cast<int>(bytes[3]) == 255);
}

TEST_CASE("auto takes a scale with a middle for quantities with a sign") {
    CHECK(find_color_map("auto", true)->name == "coolwarm");
    CHECK(find_color_map("auto", false)->name == "viridis");
}

TEST_CASE("an unknown colour scale is answered with the nearest one") {
    const auto map = find_color_map("virdis", false);
    REQUIRE(!map.ok());
    CHECK(map.problems().front().key == "render.colormap");
    CHECK(map.problems().front().fix.find("did you mean 'viridis'?") == 0);
}

TEST_CASE("a scene may name exactly the colour scales and quantities that there are") {
    CHECK(words_of("colormap") == color_map_names());
    std::vector<std::string> names;
    for (const Quantity& quantity : quantities())
        names.push_back(quantity.name);
    CHECK(words_of("color") == names);
}

} // namespace test_color_map
