#include "hard2d/solver.h"
#include "run/seen_contacts.h"
#include "run/simulation.h"
#include "scene/outline.h"
#include "sim2d/solver.h"
#include "sim2d/time_step.h"

#include <Eigen/Geometry>
#include <numbers>

namespace tumble::run {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Round walls are drawn as so many straight lines a turn: they leave the circle by 1e-5 of its radius at most, on paper
// by less than 0.02 mm up to a radius of 2 m.
constexpr int lines_per_turn = 720;

Vector3d in_space(const Vector2d& point) {
    return {point.x(), point.y(), 0};
}

observe::FrameWall wall_lines(const scene::Wall& wall) {
    observe::FrameWall lines;
    lines.name = wall.name;
    lines.opacity = 1;
    for (const scene::OutlinePiece& piece : scene::pieces_of(wall.outline)) {
        const auto first = static_cast<int>(lines.vertices.size());
        for (const Vector2d& point : scene::points_along(piece, 2 * std::numbers::pi / lines_per_turn))
            lines.vertices.push_back(in_space(point));
        for (int k = first + 1; k < static_cast<int>(lines.vertices.size()); ++k)
            lines.lines.push_back({k - 1, k});
    }
    return lines;
}

std::shared_ptr<const observe::FrameLayout> layout_of(const scene::Scene& scene,
                                                      const std::vector<sim2d::BodyShape>& shapes) {
    auto layout = std::make_shared<observe::FrameLayout>();
    layout->title = scene.title;
    layout->dimension = 2;
    layout->domain_lo = scene.domain.box.lo;
    layout->domain_hi = scene.domain.box.hi;
    layout->periodic = scene.domain.periodic;
    for (const sim2d::BodyShape& shape : shapes) {
        observe::FrameShape seen{.name = shape.name,
                                 .mass = shape.mass,
                                 .inertia = shape.inertia * Vector3d::UnitZ(),
                                 .centres = {},
                                 .radii = {}};
        for (const sim2d::Disc& disc : shape.discs) {
            seen.centres.push_back(in_space(disc.centre));
            seen.radii.push_back(disc.radius);
        }
        layout->shapes.push_back(std::move(seen));
    }
    for (const scene::Wall& wall : scene.walls)
        layout->walls.push_back(wall_lines(wall));
    return layout;
}

scene::TimeStepReport report_of(const sim2d::World& world, const scene::Scene& scene) {
    return sim2d::time_step_report(scene, shapes_of(world));
}

scene::TimeStepReport report_of(const hard2d::World& /*world*/, const scene::Scene& scene) {
    return hard2d::time_step_report(scene);
}

std::string whole_state(const sim2d::World& world) {
    return sim2d::state_of(world);
}

/// What Box2D remembers of its contacts is its own.
std::string whole_state(const hard2d::World& /*world*/) {
    return "";
}

/// A world of discs; its functions are found by its type, in sim2d or in hard2d.
template <class WorldPtr> class Simulation2d final : public Simulation {
public:
    Simulation2d(const scene::Scene& scene, WorldPtr world)
        : scene_(scene), world_(std::move(world)), layout_(layout_of(scene, shapes_of(*world_))) {}

    std::optional<Problem> advance(std::int64_t steps) override {
        using hard2d::advance, sim2d::advance;
        return advance(*world_, steps);
    }
    [[nodiscard]] double time() const override { return time_of(*world_); }
    [[nodiscard]] std::int64_t steps() const override { return steps_of(*world_); }
    [[nodiscard]] Books books() const override { return books_of(*world_); }
    [[nodiscard]] std::shared_ptr<const observe::FrameLayout> layout() const override { return layout_; }
    [[nodiscard]] std::vector<std::string> unfilled() const override {
        using hard2d::unfilled, sim2d::unfilled;
        return unfilled(*world_);
    }
    [[nodiscard]] std::vector<PhaseTime> phase_times() const override {
        using hard2d::phase_times, sim2d::phase_times;
        return phase_times(*world_);
    }
    [[nodiscard]] std::string state() const override { return whole_state(*world_); }
    [[nodiscard]] scene::TimeStepReport time_step() const override { return report_of(*world_, scene_); }

    [[nodiscard]] observe::Frame frame() const override {
        observe::Frame frame;
        frame.layout = layout_;
        frame.time = time();
        frame.step = steps();
        for (const sim2d::BodyState& body : bodies_of(*world_)) {
            frame.id.push_back(body.id);
            frame.shape.push_back(body.shape);
            frame.position.push_back(in_space(body.position));
            frame.orientation.emplace_back(Eigen::AngleAxisd(body.angle, Vector3d::UnitZ()));
            frame.velocity.push_back(in_space(body.velocity));
            frame.angular_velocity.emplace_back(0, 0, body.angular_velocity);
        }
        for (const scene::WallPose& pose : walls_of(*world_))
            frame.walls.push_back({pose.rotation, pose.translation, pose.velocity, pose.angular_velocity});
        return frame;
    }

    [[nodiscard]] std::vector<observe::FrameContact> contacts() const override {
        return seen_contacts(contacts_of(*world_));
    }

    [[nodiscard]] std::vector<SimulatedBody> bodies() const override {
        std::vector<SimulatedBody> bodies;
        for (const sim2d::BodyShape& shape : shapes_of(*world_))
            bodies.push_back({shape.name, shape.discs.size(), shape.area * scene_.depth, shape.mass,
                              shape.inertia * Vector3d::UnitZ(), shape.bounding_radius});
        return bodies;
    }

private:
    scene::Scene scene_;
    WorldPtr world_;
    std::shared_ptr<const observe::FrameLayout> layout_;
};

template <class WorldPtr> Result<SimulationPtr> simulation_of(const scene::Scene& scene, Result<WorldPtr> world) {
    if (!world)
        return world.problems();
    return SimulationPtr(std::make_unique<Simulation2d<WorldPtr>>(scene, std::move(*world)));
}

} // namespace

Result<SimulationPtr> simulate_in_2d(const scene::Scene& scene, int threads, StopFlag stop, const std::string* state,
                                     const Tally& tally) {
    return simulation_of(scene, state ? sim2d::restore_world(scene, threads, *state, stop)
                                      : sim2d::build_world(scene, threads, stop, tally));
}

Result<SimulationPtr> simulate_hard(const scene::Scene& scene, StopFlag stop, const Tally& tally) {
    return simulation_of(scene, hard2d::build_world(scene, stop, tally));
}

} // namespace tumble::run
