#pragma once

#include "render/area.h"
#include "render/color_map.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tumble::render {

enum class Lettering { small, normal, large };
enum class Align { left, middle, right };

/// Words that found no room, and the share of their width that there was.
struct Crowded {
    std::string words;
    double share = 0;
};

/// Draws lines and text in pixels, onto whatever its kind draws onto. Colours are sRGB 0 to 1.
class Pen {
public:
    virtual ~Pen() = default;

    [[nodiscard]] double unit() const { return unit_; }
    /// Of the letters from their lowest to their highest reach, pixels.
    [[nodiscard]] virtual double height(Lettering lettering) const = 0;
    [[nodiscard]] virtual double width(const std::string& text, Lettering lettering) const = 0;
    /// The thinnest line that is seen well, pixels.
    [[nodiscard]] virtual double hair() const = 0;

    /// The text, or its beginning and three dots where it is wider than `room` pixels.
    [[nodiscard]] std::string shortened(const std::string& text, Lettering lettering, double room) const;

    /// Its beginning, three dots and its end: of names that differ at their ends.
    [[nodiscard]] std::string shortened_inside(const std::string& text, Lettering lettering, double room) const;
    /// As shortened(), of numbers and units, which must not be cut: the pen remembers where it had to be.
    std::string entire(const std::string& text, Lettering lettering, double room);
    void note_crowded(const std::string& words, double share) { crowded_.push_back({words, share}); }
    [[nodiscard]] const std::vector<Crowded>& crowded() const { return crowded_; }

    /// Top of the letters at y; x is the text's left, middle or right.
    virtual void text(double x, double y, const std::string& words, Lettering lettering, Align align,
                      const Eigen::Vector3d& color) = 0;
    virtual void rectangle(const Area& area, const Eigen::Vector3d& color, double opacity) = 0;
    /// All colours of a map, from the left to the right or from below.
    virtual void ramp(const Area& area, const ColorMap& map, bool upright) = 0;
    virtual void triangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                          const Eigen::Vector3d& color) = 0;
    virtual void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double thickness,
                      const Eigen::Vector3d& color, double opacity = 1) = 0;
    virtual void curve(const std::vector<Eigen::Vector2d>& points, double thickness, const Eigen::Vector3d& color) = 0;
    virtual void dot(const Eigen::Vector2d& at, double radius, const Eigen::Vector3d& color) = 0;

protected:
    explicit Pen(double unit) : unit_(unit) {}
    Pen(const Pen&) = default;
    Pen& operator=(const Pen&) = default;

private:
    double unit_ = 1;
    std::vector<Crowded> crowded_;
};

} // namespace tumble::render
