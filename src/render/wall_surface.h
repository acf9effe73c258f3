#pragma once

#include "observe/frame.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace tumble::render {

/// A wall made ready for drawing, in its own frame, metres.
struct WallSurface {
    struct Triangle {
        std::array<Eigen::Vector3d, 3> corners;
        std::array<Eigen::Vector3d, 3> normals; // unit, at the corners; smooth over bends of less than 30 degrees
    };
    /// Two triangles meet, or one ends. Sharp ones are always drawn; others where the surface bends out of sight.
    struct Edge {
        std::array<Eigen::Vector3d, 2> ends;
        std::array<Eigen::Vector3d, 2> normals; // unit, of the two triangles
        bool sharp = false;                     // a rim, or a bend of more than 30 degrees
        // How far a line of some thickness goes on beyond the ends, of half its thickness, so that corners close.
        std::array<double, 2> beyond{0.5, 0.5};
    };
    std::vector<Triangle> triangles;
    std::vector<Edge> edges;
};

/// Corners closer than 1e-7 of the wall's size count as one, so that a soup of triangles gets smooth normals too.
/// Triangles without area and indices out of range are left out. The lines of a wall in two dimensions become sharp
/// edges, which go on just as far as the bend to the next needs: where lines lie over each other they would be darker.
WallSurface make_wall_surface(const observe::FrameWall& wall);

} // namespace tumble::render
