#include "sim2d/time_step.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::sim2d {

namespace {

/// 1/m + (arm)^2 / I: the arm of a push through a disc's centre is at most the centre's distance from the centre of
/// mass, that of a force in any direction on its rim at most a radius more.
scene::ContactSide side_of(const BodyShape& shape, int material) {
    scene::ContactSide side;
    side.name = "body " + shape.name;
    side.material = material;
    side.mass = shape.mass;
    side.radius = 0;
    double push = 0, full = 0;
    for (const Disc& disc : shape.discs) {
        const double arm = disc.centre.norm();
        push = std::max(push, arm);
        full = std::max(full, arm + disc.radius);
        side.radius = std::max(side.radius, disc.radius);
    }
    side.push_mobility = 1 / shape.mass + push * push / shape.inertia;
    side.full_mobility = 1 / shape.mass + full * full / shape.inertia;
    return side;
}

} // namespace

scene::TimeStepReport time_step_report(const scene::Scene& scene, const std::vector<BodyShape>& shapes) {
    std::vector<scene::ContactSide> bodies;
    std::vector<scene::NamedRadius> parts;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const int material = scene.bodies[i].material;
        bodies.push_back(side_of(shapes[i], material));
        for (std::size_t d = 0; d < shapes[i].discs.size(); ++d)
            parts.push_back(
                {fmt::format("body {}, disc {}", shapes[i].name, d + 1), shapes[i].discs[d].radius, material});
    }
    return scene::time_step_report(scene, bodies, parts);
}

} // namespace tumble::sim2d
