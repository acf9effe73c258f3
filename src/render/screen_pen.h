#pragma once

#include "render/pen.h"

struct ImDrawList;
struct ImFont;

namespace tumble::render {

/// Draws onto one of Dear ImGui's lists.
class ScreenPen final : public Pen {
public:
    struct Fonts {
        ImFont* small = nullptr;
        ImFont* normal = nullptr;
        ImFont* large = nullptr;
        bool complete = false; // has the minus sign and raised digits
    };
    ScreenPen(ImDrawList& list, const Fonts& fonts, double unit) : Pen(unit), list_(list), fonts_(fonts) {}

    [[nodiscard]] double height(Lettering lettering) const override;
    [[nodiscard]] double width(const std::string& text, Lettering lettering) const override;
    [[nodiscard]] double hair() const override { return 1; }

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
    [[nodiscard]] ImFont* font(Lettering lettering) const;
    [[nodiscard]] std::string writable(const std::string& text) const;

    ImDrawList& list_;
    Fonts fonts_;
};

} // namespace tumble::render
