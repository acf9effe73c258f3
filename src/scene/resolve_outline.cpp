#include "scene/extent.h"
#include "scene/keys.h"
#include "scene/outline.h"
#include "scene/resolve.h"

#include <fmt/format.h>

namespace tumble::scene {
namespace {

using Eigen::Vector2d;

SegmentShape segment(const View& view, const Resolving& to) {
    const SegmentShape shape{view.vector("from_m").head<2>(), view.vector("to_m").head<2>()};
    if (view.given("from_m") && view.given("to_m") && shape.from == shape.to)
        to.refuse(view, "to_m", "the segment ends where it begins", "give two different points");
    return shape;
}

PolylineShape polyline(const View& view, const Resolving& to) {
    PolylineShape shape;
    const std::vector<double> numbers = view.numbers("points_m");
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        shape.points.emplace_back(numbers[i], numbers[i + 1]);
    shape.closed = view.flag("closed");
    if (!view.given("points_m"))
        return shape;
    if (shape.points.size() < (shape.closed ? 3U : 2U))
        to.refuse(view, "points_m", fmt::format("{} points make no line", shape.points.size()),
                  shape.closed ? "give three or more" : "give two or more");
    for (std::size_t i = 1; i < shape.points.size() + (shape.closed ? 1 : 0); ++i)
        if (shape.points[i - 1] == shape.points[i % shape.points.size()])
            to.refuse(view, "points_m", fmt::format("points {} and {} are the same", i, i % shape.points.size() + 1),
                      "leave one of them out");
    return shape;
}

BoxShape sides(const View& view, const Resolving& to) {
    BoxShape shape;
    shape.box = box_of(view, "lo_m", "hi_m", to);
    if (view.given("lo_m") && view.given("hi_m") && !has_volume(shape.box))
        to.refuse(
            view, "hi_m",
            fmt::format("the box from {} to {} has no area", in_words(shape.box.lo, to), in_words(shape.box.hi, to)),
            "each value of hi_m must be above that of lo_m");
    for (const std::string& face : view.words("open"))
        shape.open[static_cast<std::size_t>(2 * (face[1] - 'x') + (face[0] == '+'))] = true;
    return shape;
}

TroughShape profile(const View& view, const Resolving& to) {
    TroughShape shape;
    shape.radius = view.number("radius_m");
    shape.floor = view.number("floor_m");
    shape.rim = view.number("rim_m");
    shape.flare = view.number("flare_deg");
    if (view.given("floor_m") && view.given("rim_m") && shape.rim <= shape.floor)
        to.refuse(view, "rim_m",
                  fmt::format("the rim at {} m is not above the floor at {} m", plain(shape.rim), plain(shape.floor)),
                  "raise the rim");
    return shape;
}

} // namespace

Outline resolve_outline(const View& view, const Resolving& to) {
    const std::string kind = view.kind();
    if (kind == "arc")
        return ArcShape{view.vector("centre_m").head<2>(), view.number("radius_m"), view.number("from_deg"),
                        view.number("sweep_deg")};
    if (kind == "polyline")
        return polyline(view, to);
    if (kind == "box")
        return sides(view, to);
    if (kind == "trough")
        return profile(view, to);
    return segment(view, to);
}

void check_outline(const View& view, const Wall& wall, const Resolving& to) {
    const Box& domain = to.scene.domain.box;
    const auto pieces = pieces_of(wall.outline);
    if (!has_volume(domain) || !view.whole())
        return; // a wall or a domain that is already wrong is in no place
    if (pieces.empty()) {
        if (!std::holds_alternative<BoxShape>(wall.outline))
            return; // a line without points was refused before
        to.refuse(view, "open", fmt::format("nothing is left of wall '{}'", view.text("name")), "close a side of it");
        return;
    }
    const Rectangle extent = bounds_of(pieces);
    const Box reached = reached_domain(wall, to.scene);
    for (int axis = 0; axis < 2; ++axis)
        if (extent.lo[axis] > reached.hi[axis] || extent.hi[axis] < reached.lo[axis]) {
            to.report.add(view.place(), view.path(),
                          fmt::format("wall '{}' lies outside the domain", view.text("name")),
                          fmt::format("no body can ever touch it: move it into {} to {}, or enlarge the domain",
                                      in_words(domain.lo, to), in_words(domain.hi, to)));
            return;
        }
}

} // namespace tumble::scene
