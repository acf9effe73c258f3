#include "render/strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double thinnest_line = 0.75; // pixels
constexpr double shortest_arrow = 1.5; // pixels
// Units; of arrows that are too short for it the head is half of the length.
constexpr double arrow_shaft = 2.0;
constexpr double arrow_head = 9;
constexpr double arrow_head_width = 7.4;

static Vector2d across(const Vector2d& along) {
    return {-along.y(), along.x()};
}

void add_bare_line(std::vector<Patch>& patches, const Vector2d& from, const Vector2d& to, double thickness,
                   const Vector3d& color) {
    const double length = (to - from).norm();
    if (!(length > 0)) {
        return;
    }
    const double drawn = std::max(thickness, thinnest_line);
    const Vector2d side = 0.5 * drawn / length * across(to - from);
    patches.push_back({{from - side, from + side, to + side, to - side}, color, thickness / drawn});
}

void add_line(std::vector<Patch>& patches, const Vector2d& from, const Vector2d& to, double thickness, const Ink& ink) {
    // Around a hair a full halo would be all that is seen.
    const double halo = std::min(halo_width * ink.unit, 0.5 * thickness);
    if (thickness > thinnest_line) {
        add_bare_line(patches, from, to, thickness + 2 * halo, ink.halo);
    }
    add_bare_line(patches, from, to, thickness, ink.color);
}

void add_arrow(std::vector<Patch>& patches, const Vector2d& tail, const Vector2d& way, const Ink& ink) {
    const double length = way.norm();
    if (!(length > shortest_arrow) || !std::isfinite(length)) {
        return;
    }
    const Vector2d along = way / length;
    const double head = std::min(arrow_head * ink.unit, 0.5 * length);
    const double size = head / (arrow_head * ink.unit); // of thin arrows everything is thinner
    const Vector2d tip = tail + way;
    const Vector2d neck = tip - head * along;
    for (const bool halo : {true, false}) {
        const double more = halo ? halo_width * ink.unit * std::max(size, 0.5) : 0;
        const Vector3d& color = halo ? ink.halo : ink.color;
        const Vector2d shaft = (0.5 * arrow_shaft * ink.unit * std::max(size, 0.5) + more) * across(along);
        const Vector2d wing = (0.5 * arrow_head_width * ink.unit * size + 1.5 * more) * across(along);
        const Vector2d start = tail - more * along;
        const Vector2d back = neck - more * along;
        const Vector2d end = tip + 1.8 * more * along;
        patches.push_back({{start - shaft, start + shaft, neck + shaft, neck - shaft}, color, 1});
        patches.push_back({{back - wing, back + wing, end, end}, color, 1});
    }
}

void add_dot(std::vector<Patch>& patches, const Vector2d& middle, double radius, const Ink& ink) {
    constexpr int slices = 12; // pairs of triangles
    for (const bool halo : {true, false}) {
        const double reach = radius + (halo ? halo_width * ink.unit : 0);
        const auto at = [&](int half_slice) {
            const double angle = std::numbers::pi * half_slice / slices;
            return Vector2d(middle + reach * Vector2d(std::cos(angle), std::sin(angle)));
        };
        for (int k = 0; k < slices; ++k) {
            patches.push_back({{middle, at(2 * k), at(2 * k + 1), at(2 * k + 2)}, halo ? ink.halo : ink.color, 1});
        }
    }
}

} // namespace tumble::render
