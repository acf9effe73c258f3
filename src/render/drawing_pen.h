#pragma once

#include "render/drawing.h"
#include "render/pen.h"

namespace tumble::render {

/// Draws onto a drawing, under all that comes later.
class DrawingPen final : public Pen {
public:
    DrawingPen(Drawing& drawing, double unit) : Pen(unit), drawing_(drawing) {}

    [[nodiscard]] double height(Lettering lettering) const override;
    [[nodiscard]] double width(const std::string& text, Lettering lettering) const override;
    [[nodiscard]] double hair() const override;

    void text(double x, double y, const std::string& words, Lettering lettering, Align align,
              const Eigen::Vector3d& color) override;
    void rectangle(const Area& area, const Eigen::Vector3d& color, double opacity) override;
    void ramp(const Area& area, const ColorMap& map, bool upright) override;
    void triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector3d& color) override;
    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thickness, const Eigen::Vector3d& color,
              double opacity = 1) override;
    void curve(const std::vector<Eigen::Vector2d>& points, double thickness, const Eigen::Vector3d& color) override;
    void dot(const Eigen::Vector2d& at, double radius, const Eigen::Vector3d& color) override;

private:
    /// As typographers measure letters, pixels.
    [[nodiscard]] double size_of(Lettering lettering) const;

    Drawing& drawing_;
};

} // namespace tumble::render
