#pragma once

#include "render/area.h"

#include <Eigen/Core>
#include <string>
#include <vector>

struct ImDrawList;
struct ImFont;

namespace tumble::render {

enum class Lettering { small, normal, large };
enum class Align { left, middle, right };

/// Draws lines and text in pixels onto one of Dear ImGui's lists. Colours are sRGB 0 to 1.
class Pen {
public:
    struct Fonts {
        ImFont* small = nullptr;
        ImFont* normal = nullptr;
        ImFont* large = nullptr;
        bool complete = false; // has the minus sign and raised digits
    };
    Pen(ImDrawList& list, const Fonts& fonts, double unit) : list_(list), fonts_(fonts), unit_(unit) {}

    [[nodiscard]] double unit() const { return unit_; }
    [[nodiscard]] double height(Lettering lettering) const;
    [[nodiscard]] double width(const std::string& text, Lettering lettering) const;

    /// The text, or its beginning and three dots where it is wider than `room` pixels.
    [[nodiscard]] std::string shortened(const std::string& text, Lettering lettering, double room) const;

    /// Top of the letters at y; x is the text's left, middle or right.
    void text(double x, double y, const std::string& words, Lettering lettering, Align align,
              const Eigen::Vector3d& color);
    void rectangle(const Area& area, const Eigen::Vector3d& color, double opacity);
    void shade(const Area& area, const Eigen::Vector3d& left_top, const Eigen::Vector3d& right_bottom, bool upright);
    void triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector3d& color);
    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thickness, const Eigen::Vector3d& color,
              double opacity = 1);
    void curve(const std::vector<Eigen::Vector2d>& points, double thickness, const Eigen::Vector3d& color);
    void dot(const Eigen::Vector2d& at, double radius, const Eigen::Vector3d& color);

private:
    [[nodiscard]] ImFont* font(Lettering lettering) const;
    [[nodiscard]] std::string writable(const std::string& text) const;

    ImDrawList& list_;
    Fonts fonts_;
    double unit_ = 1;
};

} // namespace tumble::render
