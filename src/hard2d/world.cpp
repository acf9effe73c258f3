#include "hard2d/world.h"

#include "hard2d/step.h"
#include "solver/sanity.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::hard2d {

namespace {

using solver::stop;

constexpr double nearly = 0.999; // Box2D cuts velocities down to its limit

std::string name_of(const World& world, std::size_t id) {
    return fmt::format("body {} ({})", id, world.shape_of(id).name);
}

} // namespace

double time_of(const World& world) {
    return world.time();
}

std::int64_t steps_of(const World& world) {
    return world.step;
}

Books books_of(const World& world) {
    return world.books;
}

const std::vector<BodyShape>& shapes_of(const World& world) {
    return world.plain_shapes;
}

std::vector<BodyState> bodies_of(const World& world) {
    std::vector<BodyState> states;
    states.reserve(world.bodies.size());
    for (std::size_t id = 0; id < world.bodies.size(); ++id) {
        const b2Body& body = *world.bodies[id];
        states.push_back({static_cast<std::int64_t>(id), world.shape[id], world.units.place(body.GetPosition()),
                          static_cast<double>(body.GetAngle()), world.units.rate(body.GetLinearVelocity()),
                          static_cast<double>(body.GetAngularVelocity())});
    }
    return states;
}

std::vector<scene::WallPose> walls_of(const World& world) {
    std::vector<scene::WallPose> poses;
    for (const Wall& wall : world.walls)
        poses.push_back(scene::pose_at(wall.motion(), world.time()));
    return poses;
}

std::vector<std::string> unfilled(const World& world) {
    return discs::owed_by(world.fills, world.shapes);
}

std::vector<PhaseTime> phase_times(const World& world) {
    std::vector<PhaseTime> phases;
    for (std::size_t k = 0; k < phase_names.size(); ++k)
        phases.push_back({phase_names[k], world.seconds[k]});
    return phases;
}

scene::TimeStepReport time_step_report(const scene::Scene& scene) {
    scene::TimeStepReport report;
    report.step = scene.box2d.time_step;
    report.hertz_speed = scene::impact_speed(scene);
    report.limit = std::numeric_limits<double>::infinity();
    return report;
}

std::optional<Problem> insanity(const World& world) {
    const Books& books = world.books;
    const double way = books.speed_max * world.dt * world.units.length;
    if (!std::isfinite(way) || !std::isfinite(books.angular_speed_max))
        return stop(world, "a body has a velocity that is not a finite number", "look at the frames just before");
    if (way > nearly * b2_maxTranslation)
        return stop(world,
                    fmt::format("a body moves at {:.4g} m/s, and Box2D moves none further than twice the smallest "
                                "radius in a step",
                                books.speed_max),
                    "shorten box2d.time_step_s");
    if (books.angular_speed_max * world.dt > nearly * b2_maxRotation)
        return stop(world,
                    fmt::format("a body turns at {:.4g} rad/s, and Box2D turns none by more than a quarter in a step",
                                books.angular_speed_max),
                    "shorten box2d.time_step_s");
    if (books.overlap_ratio_max > solver::deepest_overlap_ratio)
        return stop(world,
                    fmt::format("two bodies overlap by {:.3g} of the smaller disc's radius", books.overlap_ratio_max),
                    "shorten box2d.time_step_s, or raise box2d.velocity_iterations and position_iterations");
    for (std::size_t id = 0; id < world.bodies.size(); ++id) {
        const Eigen::Vector2d place = world.units.place(world.bodies[id]->GetPosition());
        const double at[] = {place.x(), place.y()};
        if (const auto axis = solver::axis_outside(world.scene.domain, at))
            return stop(world,
                        fmt::format("{} left the domain at {} = {:.4g} m", name_of(world, id), "xy"[*axis], at[*axis]),
                        "enlarge the domain, close the walls, or shorten box2d.time_step_s");
    }
    return std::nullopt;
}

} // namespace tumble::hard2d
