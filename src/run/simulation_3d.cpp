#include "run/seen_contacts.h"
#include "run/simulation.h"
#include "run/wall_triangles.h"
#include "sim3d/solver.h"
#include "sim3d/time_step.h"

namespace tumble::run {

namespace {

std::shared_ptr<const observe::FrameLayout> layout_of(const scene::Scene& scene,
                                                      const std::vector<sim3d::BodyShape>& shapes) {
    auto layout = std::make_shared<observe::FrameLayout>();
    layout->title = scene.title;
    layout->domain_lo = scene.domain.box.lo;
    layout->domain_hi = scene.domain.box.hi;
    layout->periodic = scene.domain.periodic;
    for (const sim3d::BodyShape& shape : shapes) {
        observe::FrameShape seen{
            .name = shape.name, .mass = shape.mass, .inertia = shape.inertia, .centres = {}, .radii = {}};
        for (const scene::Sphere& sphere : shape.spheres) {
            seen.centres.push_back(sphere.centre);
            seen.radii.push_back(sphere.radius);
        }
        layout->shapes.push_back(std::move(seen));
    }
    for (const scene::Wall& wall : scene.walls)
        layout->walls.push_back(wall_triangles(wall, scene.domain));
    return layout;
}

class Simulation3d final : public Simulation {
public:
    Simulation3d(const scene::Scene& scene, sim3d::WorldPtr world)
        : scene_(scene), world_(std::move(world)), layout_(layout_of(scene, sim3d::shapes_of(*world_))) {}

    std::optional<Problem> advance(std::int64_t steps) override { return sim3d::advance(*world_, steps); }
    [[nodiscard]] double time() const override { return sim3d::time_of(*world_); }
    [[nodiscard]] std::int64_t steps() const override { return sim3d::steps_of(*world_); }
    [[nodiscard]] Books books() const override { return sim3d::books_of(*world_); }
    [[nodiscard]] std::shared_ptr<const observe::FrameLayout> layout() const override { return layout_; }
    [[nodiscard]] std::vector<std::string> unfilled() const override { return sim3d::unfilled(*world_); }
    [[nodiscard]] std::vector<PhaseTime> phase_times() const override { return sim3d::phase_times(*world_); }
    [[nodiscard]] std::string state() const override { return sim3d::state_of(*world_); }
    [[nodiscard]] scene::TimeStepReport time_step() const override {
        return sim3d::time_step_report(scene_, sim3d::shapes_of(*world_));
    }

    [[nodiscard]] observe::Frame frame() const override {
        observe::Frame frame;
        frame.layout = layout_;
        frame.time = time();
        frame.step = steps();
        for (const sim3d::BodyState& body : sim3d::bodies_of(*world_)) {
            frame.id.push_back(body.id);
            frame.shape.push_back(body.shape);
            frame.position.push_back(body.position);
            frame.orientation.push_back(body.orientation);
            frame.velocity.push_back(body.velocity);
            frame.angular_velocity.push_back(body.angular_velocity);
        }
        for (const scene::WallPose& pose : sim3d::walls_of(*world_))
            frame.walls.push_back({pose.rotation, pose.translation, pose.velocity, pose.angular_velocity});
        return frame;
    }

    [[nodiscard]] std::vector<observe::FrameContact> contacts() const override {
        return seen_contacts(sim3d::contacts_of(*world_));
    }

    [[nodiscard]] std::vector<observe::WallPush> wall_pushes(int wall) const override {
        std::vector<observe::WallPush> pushes;
        for (const sim3d::WallPush& push : sim3d::wall_pushes_of(*world_, wall))
            pushes.push_back({push.body, push.triangle, push.foot, push.normal, push.force, push.velocity, push.patch});
        return pushes;
    }

    [[nodiscard]] std::vector<SimulatedBody> bodies() const override {
        std::vector<SimulatedBody> bodies;
        for (const sim3d::BodyShape& shape : sim3d::shapes_of(*world_))
            bodies.push_back({shape.name, shape.spheres.size(), shape.volume, shape.mass, shape.inertia,
                              shape.bounding_radius, shape.written_centre, shape.written_from_principal});
        return bodies;
    }

private:
    scene::Scene scene_;
    sim3d::WorldPtr world_;
    std::shared_ptr<const observe::FrameLayout> layout_;
};

} // namespace

Result<SimulationPtr> simulate_in_3d(const scene::Scene& scene, int threads, StopFlag stop, const std::string* state,
                                     const Tally& tally) {
    Result<sim3d::WorldPtr> world =
        state ? sim3d::restore_world(scene, threads, *state, stop) : sim3d::build_world(scene, threads, stop, tally);
    if (!world)
        return world.problems();
    return SimulationPtr(std::make_unique<Simulation3d>(scene, std::move(*world)));
}

} // namespace tumble::run
