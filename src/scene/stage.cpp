#include "scene/stage.h"

#include <cmath>
#include <numbers>

namespace tumble::scene {

namespace {

constexpr double room = 100; // m, from the origin to every side of the domain

Scene stage(const contact::Material& material, const contact::PairProperties& pair, double time_step) {
    Scene scene;
    scene.title = "stage";
    scene.gravity = Eigen::Vector3d::Zero();
    scene.time_step = time_step;
    scene.duration = 1;
    scene.allow_large_step = true; // a lesson about too long a step needs it
    scene.domain.box = {Eigen::Vector3d::Constant(-room), Eigen::Vector3d::Constant(room)};
    scene.materials = {material};
    scene.pairs = {pair};
    return scene;
}

} // namespace

Scene plane_stage(const contact::PairProperties& pair, double time_step) {
    Scene scene = stage({"stone", 1000, 0, 0}, pair, time_step);
    scene.dimension = 2;
    scene.depth = 1;
    scene.domain.box.lo.z() = -0.5;
    scene.domain.box.hi.z() = 0.5;
    scene.contact.normal = NormalLaw::linear;
    scene.contact.tangential = TangentialLaw::linear;
    return scene;
}

Scene space_stage(const contact::Material& material, const contact::PairProperties& pair, double time_step) {
    return stage(material, pair, time_step);
}

int add_body(Scene& scene, const std::vector<Sphere>& parts) {
    BodyTemplate body;
    body.name = "body" + std::to_string(scene.bodies.size());
    body.spheres = parts;
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
}

int add_round(Scene& scene, double radius) {
    return add_body(scene, {{Eigen::Vector3d::Zero(), radius}});
}

int add_round(Scene& scene, double radius, double mass) {
    const int body = add_round(scene, radius);
    scene.bodies.back().mass = mass;
    return body;
}

Wall& add_wall(Scene& scene, const Outline& outline) {
    scene.walls.emplace_back();
    scene.walls.back().name = "wall" + std::to_string(scene.walls.size());
    scene.walls.back().outline = outline;
    return scene.walls.back();
}

Wall& add_wall(Scene& scene, const WallShape& shape) {
    scene.walls.emplace_back();
    scene.walls.back().name = "wall" + std::to_string(scene.walls.size());
    scene.walls.back().shape = shape;
    return scene.walls.back();
}

Fill& place(Scene& scene, int body, const Vector3d& position, const Vector3d& velocity,
            const Vector3d& angular_velocity) {
    Fill fill;
    fill.body = body;
    fill.count = 1;
    fill.position = position;
    fill.orientation = Orientation::as_written;
    fill.velocity = velocity;
    fill.angular_velocity = angular_velocity;
    scene.fills.push_back(fill);
    return scene.fills.back();
}

PolylineShape toothed_floor(double half, double radius) {
    PolylineShape floor;
    const auto teeth = static_cast<int>(half / radius);
    for (int k = -teeth; k <= teeth; ++k)
        floor.points.emplace_back(k * radius, k % 2 == 0 ? -radius : 0.0);
    return floor;
}

std::vector<Sphere> disc_triangle(double radius) {
    const double r = 0.62 * radius; // m, and so far are the centres from the middle
    std::vector<Sphere> discs;
    for (const double turn : {90.0, 210.0, 330.0}) {
        const double angle = turn / 180 * std::numbers::pi;
        discs.push_back({{r * std::cos(angle), r * std::sin(angle), 0}, r});
    }
    return discs;
}

contact::PairProperties linear_pair(double stiffness, double ratio, double restitution, double friction) {
    contact::PairProperties pair;
    pair.normal_stiffness = stiffness;
    pair.stiffness_ratio = ratio;
    pair.restitution = restitution;
    pair.friction = friction;
    return pair;
}

} // namespace tumble::scene
