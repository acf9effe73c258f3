#pragma once

#include "render/patch.h"

#include <vector>

/// Lines, arrows and dots, each with a halo that sets it off from whatever is behind it.
namespace tumble::render {

struct Ink {
    double unit = 1; // pixels, render/layout.h
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    Eigen::Vector3d halo = Eigen::Vector3d::Zero();
};

/// Units, how far a halo reaches beyond what it surrounds.
constexpr double halo_width = 1.2;

/// One mark of a drawing, whoever draws it. Lengths in pixels.
struct Stroke {
    enum class Kind {
        line,  // from the first point to the second
        arrow, // from its tail to its tip
        way,   // a line a pair of points, under one halo
        dot,   // about its one point
    };
    Kind kind = Kind::line;
    std::vector<Eigen::Vector2d> points;
    double thickness = 0; // of lines; the radius of a dot; arrows have their own
    Ink ink;
};

/// How far the halo of a line or a dot reaches beyond it, pixels. Around a hair a full halo would be all that is seen.
double halo_of(const Stroke& stroke);

/// The outline of an arrow, pixels; nothing of one that is shorter than 1.5 pixels. Short arrows are thinner.
struct ArrowShape {
    std::vector<Eigen::Vector2d> outline; // shaft and head, the tip in the middle
    double halo = 0;
};
ArrowShape arrow_shape(const Stroke& arrow);

/// The stroke in flat pieces, in the order to draw. A line thinner than 0.75 pixels is drawn so thick and paler, so
/// that as much ink is seen; an arrow shorter than 1.5 pixels is left out.
void add_patches(const Stroke& stroke, std::vector<Patch>& patches);

} // namespace tumble::render
