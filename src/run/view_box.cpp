#include "run/view_box.h"

#include "scene/motion.h"

namespace tumble::run {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Enough to meet each corner of a swinging wall's way to a percent; what is missed lies in the picture's margin.
constexpr int looks = 200;

void add_wall(const scene::WallMotion& motion, const observe::FrameWall& wall, double duration, AlignedBox3d& box) {
    AlignedBox3d own;
    for (const Vector3d& vertex : wall.vertices)
        own.extend(vertex);
    if (own.isEmpty())
        return;
    const int times = motion.at_rest() ? 0 : looks;
    for (int i = 0; i <= times; ++i) {
        const scene::WallPose pose = scene::pose_at(motion, duration * i / std::max(times, 1));
        for (int corner = 0; corner < 8; ++corner)
            box.extend(pose.rotation * own.corner(static_cast<AlignedBox3d::CornerType>(corner)) + pose.translation);
    }
}

double reach_of(const observe::FrameShape& shape) {
    double reach = 0;
    for (std::size_t s = 0; s < shape.centres.size(); ++s)
        reach = std::max(reach, shape.centres[s].norm() + shape.radii[s]);
    return reach;
}

} // namespace

AlignedBox3d view_box(const scene::Scene& scene, const observe::FrameLayout& layout) {
    AlignedBox3d box;
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
        add_wall(scene.walls[w].motion, layout.walls[w], scene.duration, box);
    for (const scene::Fill& fill : scene.fills) {
        const double reach = reach_of(layout.shapes[static_cast<std::size_t>(fill.body)]);
        if (fill.position)
            box.extend(AlignedBox3d(fill.position->array() - reach, fill.position->array() + reach));
        else
            box.extend(AlignedBox3d(fill.region.lo, fill.region.hi));
    }
    return box;
}

} // namespace tumble::run
