#pragma once

#include "render/drafter.h"
#include "render/overlay.h"
#include "render/painter.h"

#include <memory>
#include <span>
#include <utility>

/// Several pictures and one lettering, put together on a sheet of their own: of pixels, or of lines.
namespace tumble::render {

class PictureSheet {
public:
    /// As wide as the settings say, `height` pixels high, lettered in that arrangement. Problems: a size that cannot be
    /// drawn, a system without OpenGL.
    static Result<PictureSheet> open(const scene::Render& settings, int height, const Layout& lettering,
                                     const Theme& theme);

    /// Each part with its upper left corner at that of its area, where nothing is written.
    Picture put_together(std::span<const Picture> parts, std::span<const Area> areas, const OverlayContent& content);

private:
    struct Inside;
    explicit PictureSheet(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}
    std::shared_ptr<Inside> inside_;
};

class DrawingSheet {
public:
    static Result<DrawingSheet> open(const scene::Render& settings, int height, const Layout& lettering,
                                     const Theme& theme);
    Drawing put_together(std::span<const Drawing> parts, std::span<const Area> areas, const OverlayContent& content);

private:
    DrawingSheet(Drawing blank, Layout lettering, Theme theme)
        : blank_(std::move(blank)), lettering_(lettering), theme_(std::move(theme)) {}
    Drawing blank_;
    Layout lettering_;
    Theme theme_;
};

/// What goes together: who draws a part, what of, and on which sheet.
struct Pixels {
    using Artist = Painter;
    using Work = Picture;
    using Sheet = PictureSheet;
    static scene::Render settings_for(const scene::Render& settings) { return settings; }
};
struct Lines {
    using Artist = Drafter;
    using Work = Drawing;
    using Sheet = DrawingSheet;
    static scene::Render settings_for(const scene::Render& settings) { return in_fine_pixels(settings); }
};

} // namespace tumble::render
