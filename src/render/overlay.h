#pragma once

#include "render/layout.h"
#include "render/marks.h"
#include "render/panels.h"

#include <memory>
#include <string>
#include <vector>

namespace tumble::render {

/// A further title.
struct Heading {
    Area area;
    std::string text;
};

/// Everything that is written over one picture.
struct OverlayContent {
    std::string title;
    std::vector<Heading> headings;
    std::vector<Heading> captions; // in the middle of their areas, in letters of the usual size
    std::string time;
    Legend legend; // without a label there is none
    MarkKey key;
    const PlotLine* plot = nullptr;
    double now = 0;                        // s
    double pixels_per_metre = 0;           // for the scale bar
    std::string scale_note;                // behind the bar's length
    std::array<Eigen::Vector2d, 3> axes{}; // the world's x, y, z on the picture, right and down

    /// The scale bar and the axes are those of that camera.
    void look_with(const Camera& camera);
};

/// The panels with all that is written in them. Returns where the colour bar lies.
Area write_panels(Pen& pen, const OverlayContent& content, const Layout& layout, const Theme& theme);

/// Whether all numbers and units have room in that layout, by the widths of letters in drawings.
bool is_readable(const OverlayContent& content, const Layout& layout, const Theme& theme);

/// Lettering through Dear ImGui without a window. A context must be current from open() to the end.
class Overlay {
public:
    /// Loads DejaVu Sans where the system has it, else the small font inside Dear ImGui, in sizes for the layout.
    static Result<Overlay> open(const Layout& layout, const Theme& theme);

    /// write_panels into the bound framebuffer of that size (pixels).
    Area draw(const OverlayContent& content, const Layout& layout, int width, int height);
    /// What had to be cut in it.
    [[nodiscard]] const std::vector<Crowded>& crowded() const;

private:
    struct Inside;
    std::shared_ptr<Inside> inside_;
};

} // namespace tumble::render
