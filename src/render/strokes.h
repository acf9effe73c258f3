#pragma once

#include "render/patch.h"

#include <vector>

/// Lines, arrows and dots as patches, each with a halo that sets it off from whatever is behind it.
namespace tumble::render {

struct Ink {
    double unit = 1; // pixels, render/layout.h
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    Eigen::Vector3d halo = Eigen::Vector3d::Zero();
};

/// Units, how far a halo reaches beyond what it surrounds.
constexpr double halo_width = 1.2;

/// Lengths in pixels. A line thinner than 0.75 pixels is drawn so thick and paler, so that as much ink is seen.
void add_line(std::vector<Patch>& patches, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thickness,
              const Ink& ink);
void add_bare_line(std::vector<Patch>& patches, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                   double thickness, const Eigen::Vector3d& color);

/// From tail to tail + way, its tip included. One shorter than 1.5 pixels is left out.
void add_arrow(std::vector<Patch>& patches, const Eigen::Vector2d& tail, const Eigen::Vector2d& way, const Ink& ink);

void add_dot(std::vector<Patch>& patches, const Eigen::Vector2d& middle, double radius, const Ink& ink);

} // namespace tumble::render
