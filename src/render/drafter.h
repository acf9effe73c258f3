#pragma once

#include "render/composition.h"
#include "render/drawing.h"

namespace tumble::render {

/// Draws frames of one run in two dimensions as lines and areas: what Painter is to pixels, in the same arrangement and
/// colours.
class Drafter {
public:
    /// Problems: a scene in space; unknown words as in Painter::open.
    static Result<Drafter> open(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                                const PainterOptions& options = {});

    /// As those of Painter.
    void fit(const Eigen::AlignedBox3d& box) { page_.fit(box); }
    void foresee(const observe::Frame& frame);
    void expect_pace(double every) { page_.mark_maker.expect_pace(every); }
    void pass_over(const observe::Frame& frame);
    Drawing draw(const observe::Frame& frame, const PlotLine& plot = {});
    Result<Done> restyle(const scene::Render& settings) { return page_.restyle(settings); }

    [[nodiscard]] const Camera& camera() const { return page_.camera; }
    [[nodiscard]] const Layout& layout() const { return page_.arrangement; }
    [[nodiscard]] MarkKey mark_key() const { return page_.mark_maker.key(*page_.layout, page_.mark_view()); }

private:
    explicit Drafter(Composition page) : page_(std::move(page)) {}
    void add_bodies(const observe::Frame& frame, const std::vector<std::uint32_t>& colors, Drawing& drawing) const;
    void add_walls(const observe::Frame& frame, Drawing& drawing) const;
    void add_marks(const observe::Frame& frame, Drawing& drawing) const;

    Composition page_;
};

/// The settings of a drawing on the same paper: dots so fine that lengths which are rounded to whole ones lose nothing.
scene::Render in_fine_pixels(const scene::Render& settings);

/// An empty drawing of the settings' size, `height` pixels high.
Drawing blank_drawing(const scene::Render& settings, double height, const Theme& theme);

} // namespace tumble::render
