#include "run/snapshot.h"

#include "run/wall_triangles.h"

namespace tumble::run {

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

observe::Frame snapshot(const sim3d::World& world, const std::shared_ptr<const observe::FrameLayout>& layout) {
    observe::Frame frame;
    frame.layout = layout;
    frame.time = sim3d::time_of(world);
    frame.step = sim3d::steps_of(world);
    for (const sim3d::BodyState& body : sim3d::bodies_of(world)) {
        frame.id.push_back(body.id);
        frame.shape.push_back(body.shape);
        frame.position.push_back(body.position);
        frame.orientation.push_back(body.orientation);
        frame.velocity.push_back(body.velocity);
        frame.angular_velocity.push_back(body.angular_velocity);
    }
    for (const scene::WallPose& pose : sim3d::walls_of(world))
        frame.walls.push_back({pose.rotation, pose.translation, pose.velocity, pose.angular_velocity});
    return frame;
}

} // namespace tumble::run
