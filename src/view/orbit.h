#pragma once

#include "render/camera.h"
#include "scene/scene.h"

#include <Eigen/Core>

namespace tumble::view {

/// A camera that hands turn, push and zoom; y stays up. It is written into a scene's [render] as a free camera, so that
/// what is seen can be drawn again by `tumble render`.
class Orbit {
public:
    /// From the picture that is seen: the place and zoom of its camera. `flat`: two dimensions, which do not turn.
    Orbit(const render::Camera& camera, double area_height, double field_of_view_deg, bool flat);

    /// By so many pixels of dragging: half a turn takes 600 pixels. Never quite from above or below, where up is
    /// undefined.
    void turn(double right, double down);
    /// What lies under the pointer goes with it; pixels.
    void push(double right, double down);
    /// Nearer by a factor above 1, so that what lies under the place (pixels from the area's middle) stays there.
    void zoom(double factor, double right, double down);
    /// What the field of view spans upright changed (render::view_height), pixels.
    void resize(double area_height) { height_ = area_height; }

    void write(scene::Render& settings) const;

private:
    [[nodiscard]] Eigen::Vector3d away() const; // unit, from the target to the eye
    [[nodiscard]] Eigen::Vector3d right() const;
    [[nodiscard]] Eigen::Vector3d up() const;
    [[nodiscard]] double metres_per_pixel() const;

    bool flat_ = false;
    double height_ = 1;      // pixels
    double tangent_ = 1;     // of half the field of view
    Eigen::Vector3d target_; // m
    double distance_ = 1;    // m, from target to eye
    double heading_ = 0;     // rad, about y; 0: from +z
    double elevation_ = 0;   // rad, above the horizon
    double nearest_ = 0;     // m, the least distance
    double farthest_ = 1;    // m, the largest
};

} // namespace tumble::view
