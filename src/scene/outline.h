#pragma once

#include "scene/scene.h"

#include <Eigen/Core>
#include <vector>

/// A wall of a scene in two dimensions, as the simple curves it is made of.
namespace tumble::scene {

/// A straight line, or a part of a circle run through counter-clockwise.
struct OutlinePiece {
    bool round = false;
    Eigen::Vector2d from = Eigen::Vector2d::Zero();   // m
    Eigen::Vector2d to = Eigen::Vector2d::Zero();     // m
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); // m, of the circle
    double radius = 0;                                // m
    double start = 0;                                 // rad, counter-clockwise from x
    double sweep = 0;                                 // rad, 2 pi: the whole circle
};

OutlinePiece straight(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
OutlinePiece arc(const Eigen::Vector2d& centre, double radius, double start, double sweep);

/// In the wall's own, unmoved frame. Pieces that meet share their end up to rounding.
std::vector<OutlinePiece> pieces_of(const Outline& outline);

/// The smallest box around the pieces, m.
struct Rectangle {
    Eigen::Vector2d lo = Eigen::Vector2d::Zero();
    Eigen::Vector2d hi = Eigen::Vector2d::Zero();
};
Rectangle bounds_of(const std::vector<OutlinePiece>& pieces);

/// Points along the piece, both ends included, no further than `step` (rad) of its circle from one to the next.
std::vector<Eigen::Vector2d> points_along(const OutlinePiece& piece, double step);

} // namespace tumble::scene
