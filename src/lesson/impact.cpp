#include "lesson/impact.h"

#include "lesson/stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::lesson {

namespace {

constexpr int longest = 200000; // steps

/// Body 0, moving down at `speed`, touches a plane through y = 0 from height `radius` on.
template <class World> Result<Impact> follow(World& world, double radius, double mass, double speed, double dt) {
    Impact seen;
    double before = -speed, height = bodies_of(world)[0].position.y();
    for (int k = 1; k <= longest; ++k) {
        if (const auto problem = advance(world, 1))
            return *problem;
        const double now = bodies_of(world)[0].position.y();
        const double rate = (now - height) / dt; // of the half step between the two heights
        const double overlap = radius - height, force = mass * (rate - before) / dt;
        seen.time.push_back((k - 1) * dt);
        seen.overlap.push_back(std::max(overlap, 0.0));
        seen.force.push_back(force);
        seen.overlap_max = std::max(seen.overlap_max, overlap);
        seen.force_max = std::max(seen.force_max, force);
        seen.force_min = std::min(seen.force_min, force);
        seen.restitution = rate / speed;
        if (k > 2 && overlap <= 0) {
            // The surface was passed between two steps.
            const double last = radius - (height - before * dt);
            seen.duration = (k - 2) * dt + dt * last / std::max(last - overlap, 1e-300);
            break;
        }
        before = rate;
        height = now;
    }
    return seen;
}

} // namespace

Result<Impact> strike_disc(const contact::PairProperties& pair, double mass, double speed, double dt, bool limit_force,
                           double ahead) {
    const double radius = struck_radius;
    scene::Scene scene = plane_stage(pair, dt);
    scene.contact.limit_force = limit_force;
    add_round(scene, radius, mass);
    add_wall(scene, scene::Outline(scene::SegmentShape{{-1, 0}, {1, 0}}));
    sim2d::BodyState disc;
    disc.position = {0, radius + ahead};
    disc.velocity = {0, -speed};
    const Result<sim2d::WorldPtr> world = start(scene, {disc});
    if (!world)
        return world.problems();
    return follow(**world, radius, mass, speed, dt);
}

Result<Impact> strike_sphere(const contact::Material& material, const contact::PairProperties& pair, double radius,
                             double speed, double dt) {
    scene::Scene scene = space_stage(material, pair, dt);
    add_round(scene, radius);
    add_wall(scene, scene::WallShape(scene::PlaneShape{}));
    sim3d::BodyState sphere;
    sphere.position = {0, radius, 0};
    sphere.velocity = {0, -speed, 0};
    const Result<sim3d::WorldPtr> world = start(scene, {sphere});
    if (!world)
        return world.problems();
    return follow(**world, radius, sim3d::shapes_of(**world)[0].mass, speed, dt);
}

double damping_ratio(double restitution) {
    const double ln_e = std::log(restitution);
    return std::abs(ln_e) / std::hypot(ln_e, std::numbers::pi);
}

HertzImpact hertz_impact(double E_eff, double radius, double mass, double speed) {
    const double overlap = std::pow(15 * mass * speed * speed / (16 * E_eff * std::sqrt(radius)), 0.4);
    return {overlap, 4.0 / 3 * E_eff * std::sqrt(radius) * std::pow(overlap, 1.5), 2.9433 * overlap / speed};
}

} // namespace tumble::lesson
