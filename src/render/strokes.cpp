#include "render/strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

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

static void add_bare_line(std::vector<Patch>& patches, const Vector2d& from, const Vector2d& to, double thickness,
                          const Vector3d& color) {
    const double length = (to - from).norm();
    if (!(length > 0)) {
        return;
    }
    const double drawn = std::max(thickness, thinnest_line);
    const Vector2d side = 0.5 * drawn / length * across(to - from);
    patches.push_back({{from - side, from + side, to + side, to - side}, color, thickness / drawn});
}

double halo_of(const Stroke& stroke) {
    const double full = halo_width * stroke.ink.unit;
    return stroke.kind == Stroke::Kind::line ? std::min(full, 0.5 * stroke.thickness) : full;
}

/// Under its halo, which hairs are too thin for.
static void add_line(std::vector<Patch>& patches, const Stroke& line) {
    if (line.thickness > thinnest_line) {
        add_bare_line(patches, line.points[0], line.points[1], line.thickness + 2 * halo_of(line), line.ink.halo);
    }
    add_bare_line(patches, line.points[0], line.points[1], line.thickness, line.ink.color);
}

static void add_way(std::vector<Patch>& patches, const Stroke& way) {
    for (const bool halo : {true, false}) {
        for (std::size_t k = 0; k + 1 < way.points.size(); k += 2) {
            add_bare_line(patches, way.points[k], way.points[k + 1],
                          halo ? way.thickness + 2 * halo_of(way) : way.thickness, halo ? way.ink.halo : way.ink.color);
        }
    }
}

namespace {

/// What an arrow measures, pixels.
struct ArrowSizes {
    Vector2d along, tail, neck, tip;
    double shaft = 0, wing = 0; // half of what they measure across
    double halo = 0;
};

/// Nothing of an arrow that is too short to be seen.
std::optional<ArrowSizes> sizes_of(const Stroke& arrow) {
    const Vector2d way = arrow.points[1] - arrow.points[0];
    const double length = way.norm();
    if (!(length > shortest_arrow) || !std::isfinite(length)) {
        return std::nullopt;
    }
    const double unit = arrow.ink.unit;
    const Vector2d along = way / length;
    const double head = std::min(arrow_head * unit, 0.5 * length);
    const double size = head / (arrow_head * unit); // of thin arrows everything is thinner
    return ArrowSizes{along,
                      arrow.points[0],
                      arrow.points[1] - head * along,
                      arrow.points[1],
                      0.5 * arrow_shaft * unit * std::max(size, 0.5),
                      0.5 * arrow_head_width * unit * size,
                      halo_width * unit * std::max(size, 0.5)};
}

} // namespace

ArrowShape arrow_shape(const Stroke& arrow) {
    const auto sizes = sizes_of(arrow);
    if (!sizes) {
        return {};
    }
    const Vector2d shaft = sizes->shaft * across(sizes->along);
    const Vector2d wing = sizes->wing * across(sizes->along);
    return {{sizes->tail - shaft, sizes->neck - shaft, sizes->neck - wing, sizes->tip, sizes->neck + wing,
             sizes->neck + shaft, sizes->tail + shaft},
            sizes->halo};
}

static void add_arrow(std::vector<Patch>& patches, const Stroke& arrow) {
    const auto sizes = sizes_of(arrow);
    if (!sizes) {
        return;
    }
    const auto& [along, tail, neck, tip, half_shaft, half_wing, full_halo] = *sizes;
    for (const bool halo : {true, false}) {
        const double more = halo ? full_halo : 0;
        const Vector3d& color = halo ? arrow.ink.halo : arrow.ink.color;
        const Vector2d shaft = (half_shaft + more) * across(along);
        const Vector2d wing = (half_wing + 1.5 * more) * across(along);
        const Vector2d start = tail - more * along;
        const Vector2d back = neck - more * along;
        const Vector2d end = tip + 1.8 * more * along;
        patches.push_back({{start - shaft, start + shaft, neck + shaft, neck - shaft}, color, 1});
        patches.push_back({{back - wing, back + wing, end, end}, color, 1});
    }
}

static void add_dot(std::vector<Patch>& patches, const Stroke& dot) {
    constexpr int slices = 12; // pairs of triangles
    const Vector2d& middle = dot.points[0];
    for (const bool halo : {true, false}) {
        const double reach = dot.thickness + (halo ? halo_of(dot) : 0);
        const auto at = [&](int half_slice) {
            const double angle = std::numbers::pi * half_slice / slices;
            return Vector2d(middle + reach * Vector2d(std::cos(angle), std::sin(angle)));
        };
        for (int k = 0; k < slices; ++k) {
            patches.push_back(
                {{middle, at(2 * k), at(2 * k + 1), at(2 * k + 2)}, halo ? dot.ink.halo : dot.ink.color, 1});
        }
    }
}

void add_patches(const Stroke& stroke, std::vector<Patch>& patches) {
    switch (stroke.kind) {
    case Stroke::Kind::line:
        return add_line(patches, stroke);
    case Stroke::Kind::arrow:
        return add_arrow(patches, stroke);
    case Stroke::Kind::way:
        return add_way(patches, stroke);
    case Stroke::Kind::dot:
        return add_dot(patches, stroke);
    }
}

} // namespace tumble::render
