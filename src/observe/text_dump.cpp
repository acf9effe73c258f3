#include "observe/text_dump.h"

#include <fmt/format.h>
#include <iterator>

namespace tumble::observe {

std::string text_dump(const Frame& frame) {
    std::string lines;
    std::int64_t spheres = 0;
    for (std::size_t i = 0; i < frame.bodies(); ++i) {
        const FrameShape& shape = frame.layout->shapes[static_cast<std::size_t>(frame.shape[i])];
        for (std::size_t k = 0; k < shape.radii.size(); ++k) {
            const Eigen::Vector3d arm = frame.orientation[i] * shape.centres[k];
            const Eigen::Vector3d at = frame.position[i] + arm;
            const Eigen::Vector3d flow = frame.velocity[i] + frame.angular_velocity[i].cross(arm);
            fmt::format_to(std::back_inserter(lines), "{} {} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {}\n",
                           ++spheres, frame.shape[i] + 1, at.x(), at.y(), at.z(), shape.radii[k], flow.x(), flow.y(),
                           flow.z(), frame.id[i] + 1);
        }
    }
    const FrameLayout& layout = *frame.layout;
    std::string sides;
    std::string bounds;
    for (int axis = 0; axis < 3; ++axis) {
        sides += layout.periodic[static_cast<std::size_t>(axis)] ? " pp" : " ff";
        bounds += fmt::format("{} {}\n", layout.domain_lo[axis], layout.domain_hi[axis]);
    }
    return fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS{}\n{}"
                       "ITEM: ATOMS id type x y z radius vx vy vz mol\n{}",
                       frame.step, spheres, sides, bounds, lines);
}

} // namespace tumble::observe
