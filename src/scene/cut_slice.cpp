#include "scene/reductions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

/// Draws everything along one axis together about a middle.
struct Squeeze {
    int axis = 0;
    double middle = 0; // m
    double share = 1;

    template <class Point> void operator()(Point& point) const {
        point[axis] = middle + share * (point[axis] - middle);
    }
    void operator()(Box& box) const {
        (*this)(box.lo);
        (*this)(box.hi);
    }
    [[nodiscard]] bool open_along(const BoxShape& box) const {
        const auto side = static_cast<std::size_t>(2 * axis);
        return box.open[side] && box.open[side + 1];
    }
};

/// Whether the wall is the same all along the axis; if so it is shortened.
struct ShortenShape {
    const Squeeze& squeeze;

    bool operator()(PlaneShape& plane) const { return plane.normal[squeeze.axis] == 0; }
    bool operator()(BoxShape& box) const {
        squeeze(box.box);
        return squeeze.open_along(box);
    }
    bool operator()(CylinderShape& cylinder) const {
        squeeze(cylinder.base);
        cylinder.length *= squeeze.share;
        return std::abs(cylinder.axis[squeeze.axis]) == 1;
    }
    bool operator()(TroughShape& trough) const {
        Eigen::Vector3d lo(trough.x_lo, 0, 0), hi(trough.x_hi, 0, 0);
        squeeze(lo);
        squeeze(hi);
        trough.x_lo = lo.x();
        trough.x_hi = hi.x();
        return squeeze.axis == 0;
    }
    bool operator()(DiscShape& /*disc*/) const { return false; }
    bool operator()(MeshShape& /*mesh*/) const { return false; }
    bool operator()(BowlShape& /*bowl*/) const { return false; }
    bool operator()(BowlDiscShape& /*disc*/) const { return false; }
    bool operator()(SpecimenShape& /*specimen*/) const { return false; }
};

struct ShortenOutline {
    const Squeeze& squeeze;

    bool operator()(SegmentShape& line) const {
        squeeze(line.from);
        squeeze(line.to);
        return line.from[1 - squeeze.axis] == line.to[1 - squeeze.axis];
    }
    bool operator()(PolylineShape& line) const {
        for (Eigen::Vector2d& point : line.points)
            squeeze(point);
        const double height = line.points.front()[1 - squeeze.axis];
        return std::all_of(line.points.begin(), line.points.end(),
                           [&](const Eigen::Vector2d& point) { return point[1 - squeeze.axis] == height; });
    }
    bool operator()(BoxShape& box) const {
        squeeze(box.box);
        return squeeze.open_along(box);
    }
    bool operator()(ArcShape& /*arc*/) const { return false; }
    bool operator()(TroughShape& /*trough*/) const { return false; }
};

bool shorten(Wall& wall, int dimension, const Squeeze& squeeze) {
    return dimension == 2 ? std::visit(ShortenOutline{squeeze}, wall.outline)
                          : std::visit(ShortenShape{squeeze}, wall.shape);
}

} // namespace

Result<Done> cut_slice(Scene& scene, double share) {
    const auto& periodic = scene.domain.periodic;
    if (const auto count = std::count(periodic.begin(), periodic.end(), true); count != 1)
        return Problem{.what = fmt::format("a slice is cut along the one periodic direction, and the domain has {}",
                                           count == 0 ? "none" : "several"),
                       .fix = "leave it at 1"};
    Squeeze squeeze;
    squeeze.axis = static_cast<int>(std::find(periodic.begin(), periodic.end(), true) - periodic.begin());
    const Box& box = scene.domain.box;
    squeeze.middle = (box.lo[squeeze.axis] + box.hi[squeeze.axis]) / 2;
    squeeze.share = share;
    Problems problems;
    for (Wall& wall : scene.walls)
        if (!shorten(wall, scene.dimension, squeeze))
            problems.push_back({.what = fmt::format("wall '{}' is not the same all along {}, so a shorter piece of it "
                                                    "is another wall",
                                                    wall.name, "xyz"[squeeze.axis]),
                                .fix = "leave it at 1"});
    if (!problems.empty())
        return problems;
    squeeze(scene.domain.box);
    for (Fill& fill : scene.fills) {
        if (fill.position)
            squeeze(*fill.position);
        else
            squeeze(fill.region);
        if (fill.count && *fill.count > 1)
            fill.count = std::max<std::int64_t>(1, std::llround(static_cast<double>(*fill.count) * share));
        if (fill.mass)
            *fill.mass *= share;
    }
    if (scene.render.view)
        squeeze(*scene.render.view);
    if (scene.render.clip)
        squeeze(*scene.render.clip);
    return Done{};
}

} // namespace tumble::scene
