#include "render/wall_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tumble::render {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::optional<std::array<double, 2>> shares_within(const AlignedBox3d& box, const Segment& way) {
    const Vector3d along = way[1] - way[0];
    double enters = 0;
    double leaves = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0) {
            if (way[0][axis] < box.min()[axis] || way[0][axis] > box.max()[axis]) {
                return std::nullopt;
            }
            continue;
        }
        double first = (box.min()[axis] - way[0][axis]) / along[axis];
        double last = (box.max()[axis] - way[0][axis]) / along[axis];
        if (first > last) {
            std::swap(first, last);
        }
        enters = std::max(enters, first);
        leaves = std::min(leaves, last);
    }
    if (!(enters < leaves)) {
        return std::nullopt;
    }
    return std::array{enters, leaves};
}

/// Where a triangle crosses the plane; nothing where it lies on one side, or in it.
static std::optional<Segment> crossing(const std::array<Vector3d, 3>& corners, int axis, double place) {
    std::array<Vector3d, 2> ends;
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector3d& a = corners[k];
        const Vector3d& b = corners[(k + 1) % 3];
        const double from = a[axis] - place;
        const double to = b[axis] - place;
        if ((from < 0) != (to < 0) && found < 2) {
            ends[found] = a + from / (from - to) * (b - a);
            ends[found][axis] = place;
            ++found;
        }
    }
    return found == 2 ? std::optional(ends) : std::nullopt;
}

std::vector<Segment> cut_lines(const WallSurface& surface, const observe::WallPlace& place, const AlignedBox3d& box) {
    std::vector<Segment> lines;
    for (const WallSurface::Triangle& triangle : surface.triangles) {
        std::array<Vector3d, 3> corners;
        AlignedBox3d reach;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = place.rotation * triangle.corners[k] + place.translation;
            reach.extend(corners[k]);
        }
        const bool inside =
            (reach.min().array() > box.min().array()).all() && (reach.max().array() < box.max().array()).all();
        if (inside || !box.intersects(reach)) {
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) {
            for (const double face : {box.min()[axis], box.max()[axis]}) {
                const auto line = crossing(corners, axis, face);
                const auto shown = line ? shares_within(box, *line) : std::nullopt;
                if (shown) {
                    const Vector3d along = (*line)[1] - (*line)[0];
                    lines.push_back({(*line)[0] + (*shown)[0] * along, (*line)[0] + (*shown)[1] * along});
                }
            }
        }
    }
    return lines;
}

} // namespace tumble::render
