#pragma once

#include "base/phases.h"
#include "base/problem.h"
#include "observe/frame.h"
#include "render/area.h"
#include "render/camera.h"
#include "render/layout.h"
#include "render/marks.h"
#include "render/painter_options.h"
#include "render/picture.h"
#include "render/plot_line.h"
#include "render/ticks.h"
#include "scene/scene.h"

#include <memory>
#include <optional>

namespace tumble::render {

/// Draws frames of one run. The view and, with an automatic range, the meaning of the colours stay the same from
/// picture to picture, so that pictures make a video; for that, frames are drawn in the order of their time. One thread
/// at a time may use a painter, not always the same one. Where memory runs out while it draws, std::bad_alloc is
/// thrown: there is no picture without its bodies or letters.
class Painter {
public:
    /// Problems: an unknown camera, projection, quantity, colour map or background, a size that cannot be drawn, a
    /// system without OpenGL.
    static Result<Painter> open(const scene::Render& settings, std::shared_ptr<const observe::FrameLayout> layout,
                                const PainterOptions& options = {});
    Painter(Painter&&) noexcept;
    Painter& operator=(Painter&&) noexcept;
    ~Painter();

    /// Makes sure that a box (m) is in the picture, besides those fitted before; bounds_of() makes one of a frame. Has
    /// no effect when the settings say what must be in the picture. draw() fits its first frame when nothing was fitted
    /// before.
    void fit(const Eigen::AlignedBox3d& box);

    /// Before the first picture: a frame that the mean field of arrows is to hold, which then stays the same in all
    /// pictures. Without it the field is the mean of the frames up to the one drawn.
    void foresee(const observe::Frame& frame);

    /// Before the first picture: frames come every so many seconds (MarkMaker::expect_pace).
    void expect_pace(double every);

    /// frame.layout must be the painter's. With an empty label the plot's place stays free. A frame without bodies
    /// shows its walls.
    Picture draw(const observe::Frame& frame, const PlotLine& plot = {});

    /// In place of draw() for a frame whose picture is there already: those after it are drawn as if draw() had been.
    void pass_over(const observe::Frame& frame);

    /// From the next picture on, camera, clip and colours are those of other settings; size, background and plot stay,
    /// and so does the arrangement of the panels. Quick enough for a camera that a hand turns. Problems: those of
    /// open() about camera and colours; nothing has changed then.
    Result<Done> restyle(const scene::Render& settings);

    /// While a hand holds the camera a narrow picture shows what the hand chose, and no more; without a value none
    /// holds it. Takes effect with the next restyle() or arrangement.
    void hold_camera(const std::optional<Held>& held);

    /// From the next picture on, pictures are of that size (pixels); what counts on from the frames so far, trails and
    /// scales, stays. Problems: those of open() about the size; nothing has changed then.
    Result<Done> resize(int width, int height);

    /// From the next picture on one sample a pixel in place of four, and no shade in crevices: the same picture with
    /// rough edges, in a fifth of the time. Problems: the graphics library has no more memory.
    Result<Done> set_sketching(bool on);

    /// How the last picture was made: its camera, arrangement, colour bar (pixels) and the colours' range (SI unit).
    [[nodiscard]] const Camera& camera() const;
    [[nodiscard]] const Layout& layout() const;
    [[nodiscard]] const Area& legend_bar() const;
    [[nodiscard]] const Span& range() const;
    /// What its lines over the bodies mean (scene::Render::marks); for callers with a legend of their own.
    [[nodiscard]] MarkKey mark_key() const;
    /// Of all pictures so far, when phases are timed; wall time.
    [[nodiscard]] const std::vector<PhaseTime>& phase_times() const;

private:
    struct Inside;
    explicit Painter(std::unique_ptr<Inside> inside);
    std::unique_ptr<Inside> inside_;
};

} // namespace tumble::render
