#pragma once

#include "fixtures.h"
#include "render/drafter.h"
#include "render/drawing_file.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>
#include <sstream>

/// Drawings of discs, and what their SVG says.
namespace tumble::render::testing {

using Eigen::Vector2d;
namespace pt = boost::property_tree;

/// The box |x|, |y| <= 0.5 m on a page; speeds 0 to 1 m/s.
inline scene::Render page_of(double width_mm, double height_mm, double font_pt = 8) {
    scene::Render settings = square_view(0.5);
    settings.camera = "side";
    settings.paper = scene::Paper{width_mm, height_mm, 300, font_pt};
    settings.plot = false;
    return settings;
}

inline std::shared_ptr<observe::FrameLayout> discs(const std::vector<double>& radii) {
    auto layout = spheres(radii);
    layout->dimension = 2;
    layout->title = "Discs & <others>";
    return layout;
}

inline Drafter drafter_for(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                           const PainterOptions& options = {}) {
    auto drafter = Drafter::open(in_fine_pixels(settings), std::move(layout), options);
    REQUIRE_MESSAGE(drafter.ok(), to_string(drafter.problems()));
    return std::move(*drafter);
}

inline pt::ptree xml_of(const Drawing& drawing) {
    std::istringstream text(encode_svg(drawing));
    pt::ptree tree;
    pt::read_xml(text, tree);
    return tree.get_child("svg");
}

/// All elements of that name, those in groups included, in their order.
inline void find_all(const pt::ptree& tree, const std::string& name, std::vector<const pt::ptree*>& found) {
    for (const auto& [key, child] : tree) {
        if (key == name)
            found.push_back(&child);
        find_all(child, name, found);
    }
}
inline std::vector<const pt::ptree*> all(const pt::ptree& tree, const std::string& name) {
    std::vector<const pt::ptree*> found;
    find_all(tree, name, found);
    return found;
}

/// The group that holds the bodies, walls, ...
inline const pt::ptree& group(const pt::ptree& tree, const std::string& name) {
    for (const pt::ptree* one : all(tree, "g"))
        if (one->get<std::string>("<xmlattr>.class") == name)
            return *one;
    FAIL("no group " << name);
    return tree;
}

inline double number(const pt::ptree& element, const std::string& attribute) {
    return element.get<double>("<xmlattr>." + attribute);
}
inline std::string word(const pt::ptree& element, const std::string& attribute) {
    return element.get<std::string>("<xmlattr>." + attribute);
}

inline std::vector<Vector2d> points_of(const pt::ptree& element) {
    std::istringstream text(word(element, "points"));
    std::vector<Vector2d> points;
    for (double x = 0, y = 0; text >> x && text.ignore() && text >> y;)
        points.emplace_back(x, y);
    return points;
}

/// As a colour is written: bytes red, green, blue.
inline std::string hex_of(const Vector3d& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(255 * color.x()), std::lround(255 * color.y()),
                       std::lround(255 * color.z()));
}

/// All text of a drawing, a line each.
inline std::string words_of(const pt::ptree& svg) {
    std::string words;
    for (const pt::ptree* text : all(svg, "text"))
        words += text->get_value<std::string>() + '\n';
    return words;
}
inline bool says(const pt::ptree& svg, const std::string& words) {
    return words_of(svg).find(words + '\n') != std::string::npos;
}

} // namespace tumble::render::testing
