#pragma once

#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/theme.h"
#include "render/veil.h"
#include "render/wall_surface.h"

#include <optional>
#include <vector>

namespace tumble::render {

/// Draws walls as surfaces seen from both sides, and their edges as lines.
class WallDrawer {
public:
    static Result<WallDrawer> open(const observe::FrameLayout& layout, const Theme& theme, const Canvas& canvas);

    /// From now on only what lies within that box is drawn, and the lines along which its faces cut walls; m.
    void cut_to(const std::optional<Eigen::AlignedBox3d>& box) { cut_ = box; }

    /// Walls of opacity 1 into the canvas' samples: like bodies they hide what is behind them.
    void draw_opaque(const observe::Frame& frame, const Camera& camera, const Canvas& canvas);

    /// The others over the background, bodies and opaque walls keep their colours; and all edges. Seen face-on a wall
    /// covers its opacity, seen aslant more of it, as a plate would. `line` is the edges' thickness in pixels.
    void draw_translucent(const observe::Frame& frame, const Camera& camera, const Canvas& canvas, double line);

private:
    struct Corner;
    struct Stroke;
    [[nodiscard]] std::vector<Corner> collect(const observe::Frame& frame, const Camera& camera, bool opaque) const;
    [[nodiscard]] std::vector<Stroke> collect_edges(const observe::Frame& frame, const Camera& camera) const;
    void add_cut_lines(const observe::Frame& frame, const Camera& camera, std::vector<Stroke>& strokes) const;
    void draw_surfaces(const std::vector<Corner>& corners, const Camera& camera, const Canvas& canvas);

    std::vector<WallSurface> surfaces_;
    std::vector<double> opacities_;
    std::optional<Eigen::AlignedBox3d> cut_;
    Theme theme_;
    Veil veil_;
    GlObject surface_program_;
    GlObject edge_program_;
    GlObject buffer_;
    GlObject surface_array_;
    GlObject edge_buffer_;
    GlObject edge_array_;
};

} // namespace tumble::render
