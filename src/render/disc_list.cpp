#include "render/disc_list.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Where the x axis leaves a disc, m from the origin; not positive when it does not meet it.
static double exit_of(const Vector3d& centre, double radius) {
    const double chord2 = radius * radius - centre.y() * centre.y();
    return chord2 > 0 ? centre.x() + std::sqrt(chord2) : 0;
}

static double entry_of(const Vector3d& centre, double radius) {
    return 2 * centre.x() - exit_of(centre, radius);
}

double spoke_length(const observe::FrameShape& shape) {
    double reach = 0;
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t d = 0; d < shape.radii.size(); ++d) {
            const double out = exit_of(shape.centres[d], shape.radii[d]);
            if (out > reach && entry_of(shape.centres[d], shape.radii[d]) <= reach) {
                reach = out;
                grows = true;
            }
        }
    }
    return reach;
}

std::vector<DiscMark> collect_discs(const observe::Frame& frame, const std::vector<std::uint32_t>& colors,
                                    const Camera& camera) {
    std::vector<DiscMark> marks;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const observe::FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[b])];
        const Vector3d place = camera.to_view(frame.position[b]);
        const Matrix3d turn = camera.axes * frame.orientation[b].toRotationMatrix();
        if (!place.allFinite() || !turn.allFinite()) {
            continue;
        }
        for (std::size_t d = 0; d < shape.radii.size(); ++d) {
            const Eigen::Vector3f at = (place + turn * shape.centres[d]).cast<float>();
            marks.push_back({at.x(), at.y(), at.z(), static_cast<float>(shape.radii[d]), colors[b]});
        }
    }
    return marks;
}

std::vector<SpokeMark> collect_spokes(const observe::Frame& frame, const std::vector<double>& lengths,
                                      const Camera& camera) {
    std::vector<SpokeMark> marks;
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const Vector3d along = frame.orientation[b] * Vector3d::UnitX();
        const double length = lengths[static_cast<std::size_t>(frame.shape[b])];
        const Vector3d from = camera.to_view(frame.position[b]);
        const Vector3d to = camera.to_view(frame.position[b] + length * along);
        if (!from.allFinite() || !to.allFinite()) {
            continue;
        }
        SpokeMark& mark = marks.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            mark.from[axis] = static_cast<float>(from[axis]);
            mark.to[axis] = static_cast<float>(to[axis]);
        }
    }
    return marks;
}

} // namespace tumble::render
