#include "render/color_map.h"

#include "base/text.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <numbers>
#include <span>

namespace tumble::render {

using Eigen::Vector3d;
using Points = std::array<std::uint32_t, 33>;

// Every eighth of the 256 published values, 0xRRGGBB; linear in between they are met within 6 of 255 (cividis' kink)
// and 2 of 255 elsewhere. viridis and inferno: S. van der Walt, N. Smith 2015, published under CC0.
constexpr Points viridis{0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086, 0x3f4989, 0x3b528b,
                         0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e, 0x26818e, 0x23898e, 0x21908c, 0x1f988b,
                         0x1f9f88, 0x21a685, 0x28ae80, 0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c,
                         0x96d83f, 0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725};
constexpr Points inferno{0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965, 0x4a0c6b, 0x57106d,
                         0x63146e, 0x70196e, 0x7d1e6d, 0x89226a, 0x962766, 0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d,
                         0xd14644, 0xdb4f3b, 0xe35932, 0xeb6528, 0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f,
                         0xfbba1f, 0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4};
// Below this point inferno is hardly lighter than the dark background (CIELAB L* 8), and bodies at rest would vanish in
// it; here L* is 16, about as much as where viridis begins.
constexpr std::size_t inferno_begins = 6;
// cividis: J. Nunez, C. Anderton, R. Renslow 2018, PLOS ONE 13(7) e0199239; looks alike with and without red-green
// colour blindness.
constexpr Points cividis{0x00224e, 0x00285b, 0x002e6a, 0x043371, 0x1a386f, 0x273e6e, 0x32436d, 0x3b496c, 0x434e6c,
                         0x4b546c, 0x52596d, 0x5a5f6e, 0x61656f, 0x686a71, 0x6f7073, 0x757676, 0x7c7b78, 0x848179,
                         0x8b8778, 0x938d78, 0x9b9376, 0xa39a75, 0xaba072, 0xb3a670, 0xbbad6c, 0xc3b469, 0xccba64,
                         0xd4c15f, 0xddc958, 0xe6d051, 0xefd748, 0xf8df3c, 0xfee838};

static ColorMap from_points(const char* name, std::span<const std::uint32_t> points) {
    ColorMap map{name, {}};
    for (const std::uint32_t p : points) {
        map.points.push_back({static_cast<std::uint8_t>(p >> 16), static_cast<std::uint8_t>(p >> 8 & 0xff),
                              static_cast<std::uint8_t>(p & 0xff)});
    }
    return map;
}

/// Msh (lightness and chroma as length, chroma as angle, hue as angle) to sRGB over CIELAB with white D65.
static std::array<std::uint8_t, 3> from_msh(double length, double chroma_angle, double hue) {
    const double l = length * std::cos(chroma_angle);
    const double a = length * std::sin(chroma_angle) * std::cos(hue);
    const double b = length * std::sin(chroma_angle) * std::sin(hue);
    const auto cubed = [](double t) { return t > 6.0 / 29 ? t * t * t : 3 * 36.0 / 841 * (t - 4.0 / 29); };
    const double fy = (l + 16) / 116;
    const Vector3d xyz{0.9505 * cubed(fy + a / 500), cubed(fy), 1.089 * cubed(fy - b / 200)};
    Eigen::Matrix3d to_rgb; // IEC 61966-2-1
    to_rgb << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
    const Vector3d linear = to_rgb * xyz;
    std::array<std::uint8_t, 3> bytes{};
    for (int i = 0; i < 3; ++i) {
        const double v = std::clamp(linear[i], 0.0, 1.0);
        const double coded = v > 0.0031308 ? 1.055 * std::pow(v, 1 / 2.4) - 0.055 : 12.92 * v;
        bytes[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * coded));
    }
    return bytes;
}

/// Blue over light grey to red: K. Moreland 2009, "Diverging Color Maps for Scientific Visualization", whose ends
/// (59, 76, 192) and (180, 4, 38) stand in Msh coordinates; towards the middle the hue turns by his AdjustHue.
static ColorMap coolwarm() {
    constexpr double end_length = 80.0;
    constexpr double end_chroma = 1.08;
    constexpr double middle_length = 88.0;
    const auto half = [&](double share, double hue, double turn) {
        const double to_end = std::abs(2 * share - 1);
        return from_msh(middle_length + to_end * (end_length - middle_length), to_end * end_chroma,
                        hue + (1 - to_end) * turn);
    };
    const double spin = end_chroma * std::sqrt(middle_length * middle_length - end_length * end_length) /
                        (end_length * std::sin(end_chroma));
    ColorMap map{"coolwarm", {}};
    for (int i = 0; i < 33; ++i) {
        const double share = i / 32.0;
        map.points.push_back(share < 0.5 ? half(share, -1.1, -spin) : half(share, 0.5, spin));
    }
    return map;
}

Vector3d ColorMap::at(double where) const {
    if (std::isnan(where)) {
        return {1, 0, 1};
    }
    const double place = std::clamp(where, 0.0, 1.0) * static_cast<double>(points.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double part = place - static_cast<double>(i);
    Vector3d color;
    for (std::size_t k = 0; k < 3; ++k) {
        color[static_cast<Eigen::Index>(k)] = ((1 - part) * points[i][k] + part * points[i + 1][k]) / 255;
    }
    return color;
}

std::uint32_t ColorMap::bytes_at(double where) const {
    const Vector3d color = at(where);
    std::array<std::uint8_t, 4> bytes{0, 0, 0, 255};
    for (std::size_t k = 0; k < 3; ++k) {
        bytes[k] = static_cast<std::uint8_t>(std::lround(255 * color[static_cast<Eigen::Index>(k)]));
    }
    return std::bit_cast<std::uint32_t>(bytes);
}

std::vector<std::string> color_map_names() {
    return {"auto", "viridis", "cividis", "inferno", "coolwarm"};
}

ColorMap plain_color_map(const Eigen::Vector3d& color) {
    std::array<std::uint8_t, 3> bytes{};
    for (int k = 0; k < 3; ++k) {
        bytes[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255 * color[k]));
    }
    return {"plain", {bytes, bytes}};
}

Result<ColorMap> find_color_map(const std::string& name, bool has_sign) {
    if (name == "coolwarm" || (name == "auto" && has_sign)) {
        return coolwarm();
    }
    if (name == "viridis" || name == "auto") {
        return from_points("viridis", viridis);
    }
    if (name == "cividis") {
        return from_points("cividis", cividis);
    }
    if (name == "inferno") {
        return from_points("inferno", std::span(inferno).subspan(inferno_begins));
    }
    const auto names = color_map_names();
    const std::string guess = did_you_mean(name, names);
    return Problem{.key = "render.colormap",
                   .what = fmt::format("there is no colour scale '{}'", name),
                   .fix = (guess.empty() ? "" : guess + "  ") + fmt::format("known: {}", fmt::join(names, ", "))};
}

} // namespace tumble::render
