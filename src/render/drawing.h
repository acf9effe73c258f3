#pragma once

#include "render/area.h"
#include "render/bare.h"
#include "render/color_map.h"
#include "render/pen.h"

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tumble::render {

/// How a shape looks: filled, outlined or both. Colours are sRGB 0 to 1, lengths pixels.
struct Look {
    std::optional<Eigen::Vector3d> fill{};
    std::optional<Eigen::Vector3d> ink{}; // of the line
    double line = 0;
    double opacity = 1;
    bool long_ends = false; // open lines go on for half their thickness
};

struct Circle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0;
    Look look;
};

/// Straight from point to point, and back to the first where it is closed. Corners are round.
struct Polygon {
    std::vector<Eigen::Vector2d> points;
    bool closed = true;
    Look look;
};

/// A part of a circle; angles grow from right to down as seen on the picture.
struct Arc {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0;
    double from = 0;  // rad
    double sweep = 0; // rad

    [[nodiscard]] Eigen::Vector2d at(double angle) const {
        return centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
};

/// Closed loops of arcs, each of which begins where the one before ends; loops inside others are holes.
struct ArcLoops {
    std::vector<std::vector<Arc>> loops;
    Look look;
};

/// All colours of a map, from the left to the right or from below.
struct Ramp {
    Area area;
    ColorMap map;
    bool upright = false;
};

/// Text that stays text. `at` is on the line the letters stand on.
struct Words {
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    std::string text;
    double size = 0; // pixels, as typographers measure it
    Align align = Align::left;
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
};

/// From here to its end all places count from `at`, and only what lies in the window is seen.
struct GroupBegin {
    std::string name; // what it holds, in one word
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    std::optional<Area> window{};
};
struct GroupEnd {};

using Shape = std::variant<Circle, Polygon, ArcLoops, Ramp, Words, GroupBegin, GroupEnd>;

/// A picture made of lines, areas and letters, in the order to draw: what Picture is to pixels. A pixel is here only a
/// measure of length, as in Area and Layout.
struct Drawing {
    double width_mm = 0;
    double height_mm = 0;
    double mm_per_pixel = 1;
    Eigen::Vector3d background = Eigen::Vector3d::Ones();
    std::vector<Shape> shapes;
    std::vector<Crowded> crowded{}; // as in Picture
    Bare bare = Bare::no;
};

} // namespace tumble::render
