#include "scene/keys.h"
#include "scene/resolve.h"
#include "scene/time_step.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::scene {
namespace {

/// The share of the smallest radius that Box2D lets bodies sink into each other: its linear slop, 0.005 of its own unit
/// of length, which the smallest radius is made (src/hard2d/units.h).
constexpr double slop = 0.005;
constexpr double radius_per_impact_step = 0.5;
constexpr double steps_per_period = 40;
constexpr double twice = 2; // gravity's step: what rests on several bodies at once may approach a little faster

double smallest_radius(const Scene& scene) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const BodyTemplate& body : scene.bodies)
        for (const Sphere& part : body.spheres)
            smallest = std::min(smallest, part.radius);
    return smallest;
}

double fastest_frequency(const Scene& scene) {
    double fastest = 0;
    for (const Wall& wall : scene.walls) {
        for (const Harmonic& part : wall.motion.harmonics)
            fastest = std::max(fastest, top_frequency(part));
        for (const Rocking& part : wall.motion.rockings)
            fastest = std::max(fastest, top_frequency(part));
    }
    return fastest;
}

/// 1, 2 or 5 times a power of ten, so that rows and frames fall on steps.
double rounded_down(double time) {
    const double power = std::pow(10, std::floor(std::log10(time)));
    for (const double digit : {5.0, 2.0})
        if (digit * power <= time * (1 + 1e-9))
            return digit * power;
    return power;
}

/// docs/hard-contacts.md says why these three.
double usual_step(const Scene& scene) {
    const double radius = smallest_radius(scene);
    double step = scene.duration;
    if (std::isfinite(radius) && radius > 0) {
        step = std::min(step, radius_per_impact_step * radius / impact_speed(scene));
        if (const double g = scene.gravity.norm(); g > 0)
            step = std::min(step, std::sqrt(2 * slop * radius / g));
    }
    if (const double frequency = fastest_frequency(scene); frequency > 0)
        step = std::min(step, 1 / (steps_per_period * frequency));
    return step > 0 ? rounded_down(step) : 0;
}

} // namespace

void resolve_box2d(const View& root, const Resolving& to) {
    Scene& scene = to.scene;
    if (scene.dimension != 2)
        return;
    const View view = root.child("box2d");
    Box2dSettings& settings = scene.box2d;
    settings.time_step = view.given("time_step_s") ? view.number("time_step_s") : usual_step(scene);
    settings.velocity_iterations = static_cast<int>(view.integer("velocity_iterations"));
    settings.position_iterations = static_cast<int>(view.integer("position_iterations"));
    settings.rebound_above = view.given("rebound_above_m_s") ? view.number("rebound_above_m_s")
                                                             : twice * scene.gravity.norm() * settings.time_step;
    if (scene.solver != Solver::box2d)
        return;
    if (settings.time_step > scene.duration && root.given("duration_s"))
        to.refuse(view, "time_step_s",
                  fmt::format("the step of {} s is longer than the whole run of {} s", plain(settings.time_step),
                              plain(scene.duration)),
                  "shorten time_step_s or lengthen duration_s");
    const View domain = root.child("domain");
    if (!domain.words("periodic").empty())
        to.refuse(domain, "periodic", "solver = \"box2d\" knows no periodic sides",
                  "close the sides with walls, or write solver = \"soft\"");
}

} // namespace tumble::scene
