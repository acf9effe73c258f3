#include "render/drawing_pen.h"

#include "render/layout.h"
#include "render/letters.h"

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Units; half a point where the smallest letters have eight.
constexpr double hair_width = 0.9;

double DrawingPen::height(Lettering lettering) const {
    switch (lettering) {
    case Lettering::small:
        return small_letters * unit();
    case Lettering::large:
        return large_letters * unit();
    case Lettering::normal:
        break;
    }
    return normal_letters * unit();
}

double DrawingPen::size_of(Lettering lettering) const {
    return height(lettering) / reach_of_letters;
}

double DrawingPen::width(const std::string& text, Lettering lettering) const {
    return size_of(lettering) * width_of_letters(text);
}

double DrawingPen::hair() const {
    return hair_width * unit();
}

void DrawingPen::text(double x, double y, const std::string& words, Lettering lettering, Align align,
                      const Vector3d& color) {
    if (words.empty()) {
        return;
    }
    const double size = size_of(lettering);
    drawing_.shapes.emplace_back(Words{{x, y + ascent_of_letters * size}, words, size, align, color});
}

void DrawingPen::rectangle(const Area& area, const Vector3d& color, double opacity) {
    drawing_.shapes.emplace_back(
        Polygon{{{area.left, area.top}, {area.right, area.top}, {area.right, area.bottom}, {area.left, area.bottom}},
                true,
                {.fill = color, .opacity = opacity}});
}

void DrawingPen::ramp(const Area& area, const ColorMap& map, bool upright) {
    drawing_.shapes.emplace_back(Ramp{area, map, upright});
}

void DrawingPen::triangle(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector3d& color) {
    drawing_.shapes.emplace_back(Polygon{{a, b, c}, true, {.fill = color}});
}

void DrawingPen::line(const Vector2d& from, const Vector2d& to, double thickness, const Vector3d& color,
                      double opacity) {
    drawing_.shapes.emplace_back(Polygon{{from, to}, false, {.ink = color, .line = thickness, .opacity = opacity}});
}

void DrawingPen::curve(const std::vector<Vector2d>& points, double thickness, const Vector3d& color) {
    drawing_.shapes.emplace_back(Polygon{points, false, {.ink = color, .line = thickness}});
}

void DrawingPen::dot(const Vector2d& at, double radius, const Vector3d& color) {
    drawing_.shapes.emplace_back(Circle{at, radius, {.fill = color}});
}

} // namespace tumble::render
