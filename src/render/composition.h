#pragma once

#include "base/problem.h"
#include "observe/frame.h"
#include "render/bare.h"
#include "render/camera.h"
#include "render/layout.h"
#include "render/marks.h"
#include "render/overlay.h"
#include "render/painter_options.h"
#include "render/style.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tumble::render {

/// The pictures of one run but for the paint: what is shown where, in which colours, under which words. Whoever paints
/// pixels and whoever draws lines build on it, so that both make the same picture.
struct Composition {
    scene::Render settings;
    PainterOptions options;
    std::shared_ptr<const observe::FrameLayout> layout;
    Style style;
    MarkMaker mark_maker;
    std::vector<double> reach;  // per shape, m: radius about the centre of mass that holds it
    std::vector<double> spokes; // per shape, m, in two dimensions

    Eigen::AlignedBox3d fitted;
    bool arranged = false;
    std::optional<Held> held; // the camera, by a hand
    Layout arrangement;
    Camera camera;
    Span span; // of the colours, SI

    Composition(const scene::Render& wanted, const PainterOptions& chosen,
                std::shared_ptr<const observe::FrameLayout> scenery, Style shown);

    /// As in Painter.
    void fit(const Eigen::AlignedBox3d& more);
    Result<Done> restyle(const scene::Render& shown);

    /// Fits the frame where nothing was fitted before, and settles panels and camera where they are open.
    void settle_for(const observe::Frame& frame);

    /// What a frame changes for those after it: the depth that the camera sees, the marks, the range of the colours.
    /// Returns the colours of its bodies, and what the legend says of them.
    std::vector<std::uint32_t> take_in(const observe::Frame& frame, Legend& legend);

    /// What is written on the picture of that frame, taken in last. `plot` must outlive it.
    [[nodiscard]] OverlayContent content(const observe::Frame& frame, const PlotLine& plot, const Legend& legend) const;

    /// Whether bodies of the frame taken in last are to be seen.
    [[nodiscard]] Bare bareness(const observe::Frame& frame) const;

    [[nodiscard]] MarkView mark_view() const;
    /// Pixels, of the outlines of discs and of walls in two dimensions.
    [[nodiscard]] double disc_line() const;
    [[nodiscard]] double wall_line() const;

private:
    /// What must be in the picture.
    [[nodiscard]] Eigen::AlignedBox3d box() const;
    void arrange();
    [[nodiscard]] OverlayContent expected_content(const Camera& seen) const;
    void enclose(const observe::Frame& frame);
    std::vector<std::uint32_t> colors_of(const observe::Frame& frame, Legend& legend);
};

} // namespace tumble::render
