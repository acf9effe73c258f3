#pragma once

#include "base/problem.h"
#include "observe/frame.h"
#include "render/area.h"
#include "scene/scene.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

namespace tumble::render {

/// A pinhole or a parallel projection onto a picture whose pixels are square.
struct Camera {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); // rows: right, up, and towards the eye; unit vectors
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();      // m; for a parallel projection any point of the axis
    Eigen::Vector3d target = Eigen::Vector3d::Zero();   // m, on the axis
    bool perspective = false;
    double scale = 1;                                 // pixels a metre; perspective: pixels a unit of the tangent
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); // pixels, where the axis meets the picture
    double nearest = 0;                               // m, distance along the axis in front of the eye
    double farthest = 1;                              // m

    /// World (m) to right, up and towards the eye (m), the eye at the origin.
    [[nodiscard]] Eigen::Vector3d to_view(const Eigen::Vector3d& world) const { return axes * (world - eye); }

    /// Where a world point (m) lies in the picture, pixels from its left and top. The point must lie before the eye.
    [[nodiscard]] Eigen::Vector2d to_picture(const Eigen::Vector3d& world) const;

    /// Pixels that a metre across the axis takes at a world point (m).
    [[nodiscard]] double pixels_per_metre(const Eigen::Vector3d& world) const;

    /// View space to OpenGL's clip space for a picture of that size (pixels).
    [[nodiscard]] Eigen::Matrix4f clip_matrix(int width, int height) const;

    /// Draws nearest and farthest around a box (m) that holds everything to be drawn.
    void enclose(const Eigen::AlignedBox3d& everything);
};

/// The box about all bodies and walls of the frames of one layout, m; of a frame that has neither its domain. Bodies
/// whose reach lies within what was seen before are not looked at more closely: in a run nearly all.
class BoundsOver {
public:
    explicit BoundsOver(std::shared_ptr<const observe::FrameLayout> layout);
    void take_in(const observe::Frame& frame);
    [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }

private:
    void take_in_body(const observe::Frame& frame, std::size_t body);
    void take_in_wall(const observe::Frame& frame, std::size_t wall);

    std::shared_ptr<const observe::FrameLayout> layout_;
    std::vector<double> reach_;             // m, per shape: of a ball about its centre of mass that holds it
    std::vector<observe::WallPlace> walls_; // as last seen
    Eigen::AlignedBox3d box_;
};

/// The same of a single frame.
Eigen::AlignedBox3d bounds_of(const observe::Frame& frame);

/// Free room between what a camera fits and the edge of its area, as a share of the area.
constexpr double camera_margin = 0.03;

/// A hand chose what is seen, in an area of that shape: all that could be seen there stays in sight.
struct Held {
    double shape = 0; // width over height; 0: that of the area itself
};

/// Pixels of an area that the field of view of a free camera spans upright: the area's height, or as much of it as
/// keeps in sight what a hand chose.
double view_height(const Area& area, const std::optional<Held>& held);

/// The camera that settings ask for. front looks along +x (y up, z to the right), side along -z (y up, x to the right),
/// top along -y (x to the right, z downwards); they fit `box` (m) into `area` with a small margin. free takes eye,
/// target and field of view (of the area's height), target in the area's middle; without eye and target it looks at the
/// box from the front, right and above. In an area narrower than 6:5 a free camera with an eye opens wider, as far as
/// the box needs it and one of 6:5 would show of it, unless it is `held` by a hand. Where settings have it turn, it is
/// the one of that time (s), and what it fits fits from all around, at one scale. Problems name an unknown camera or
/// projection and a free camera without direction.
Result<Camera> make_camera(const scene::Render& settings, const Eigen::AlignedBox3d& box, const Area& area,
                           double time = 0, const std::optional<Held>& held = {});

} // namespace tumble::render
