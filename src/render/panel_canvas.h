#pragma once

#include "base/problem.h"
#include "render/picture.h"
#include "render/screen_pen.h"

#include <functional>
#include <memory>

namespace tumble::render {

/// A picture of its own with widgets of Dear ImGui, for those who have hands to send (a viewer).
class PanelCanvas {
public:
    /// Sizes in pixels; `unit` as in render/layout.h. Problems: a size that cannot be drawn, a system without OpenGL.
    static Result<PanelCanvas> open(int width, int height, double unit);
    PanelCanvas(PanelCanvas&&) noexcept;
    PanelCanvas& operator=(PanelCanvas&&) noexcept;
    ~PanelCanvas();

    /// Another size, pixels, with the widgets as they are. Problems: one that cannot be drawn; the size is as before
    /// then.
    Result<Done> resize(int width, int height);

    /// Letters for another unit, with the widgets as they are. Problems: the graphics library has no more memory.
    Result<Done> rescale(double unit);

    using Step = std::function<void()>;

    /// One frame of Dear ImGui: `feed` tells its IO what hands did, `build` makes the widgets. Nothing is painted.
    void pass(const Step& feed, const Step& build);
    /// Paints what the last pass left.
    Picture paint();

    /// For drawing with a Pen among the widgets.
    [[nodiscard]] const ScreenPen::Fonts& fonts() const;
    [[nodiscard]] double unit() const;

private:
    struct Inside;
    explicit PanelCanvas(std::unique_ptr<Inside> inside);
    std::unique_ptr<Inside> inside_;
};

} // namespace tumble::render
