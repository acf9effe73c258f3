// 32,000 spheres in dense sheared flow down a plane tilted by 26 degrees, from the peers' start state.
#include "support/arguments.h"
#include "support/media.h"
#include "support/report.h"
#include "support/sphere_file.h"

using namespace tumble;

namespace {

scene::Scene tilted_layer(double radius) {
    scene::Scene scene = bench::media_scene();
    scene.turn_spheres = false; // as in gran/hertz/history, which does not turn spheres either
    scene.gravity = 9.81 * Eigen::Vector3d(0.438371, -0.898794, 0);
    scene.domain.box = {{0, -0.01, 0}, {0.16, 0.5, 0.08}};
    scene.domain.periodic = {true, false, true};
    scene::BodyTemplate sphere;
    sphere.name = "sphere";
    sphere.spheres = {{Eigen::Vector3d::Zero(), radius}};
    scene.bodies = {sphere};
    scene::Wall floor;
    floor.name = "floor";
    floor.shape = scene::PlaneShape{};
    floor.material = 1;
    scene.walls = {floor};
    return scene;
}

std::vector<sim3d::BodyState> as_bodies(const std::vector<bench::WrittenSphere>& spheres) {
    std::vector<sim3d::BodyState> bodies;
    for (const auto& sphere : spheres) {
        sim3d::BodyState body;
        body.position = sphere.position;
        body.velocity = sphere.velocity;
        body.angular_velocity = sphere.angular_velocity;
        bodies.push_back(body);
    }
    return bodies;
}

} // namespace

/// state=FILE threads=1 dt=5e-6 skin=0 pre=1000 blocks=1 steps=3000 out=FILE
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    const auto spheres = bench::read_data_file(arguments.text("state", "state.data"));
    scene::Scene scene = tilted_layer(spheres.front().radius);
    scene.time_step = arguments.number("dt", 5e-6);
    scene.skin = arguments.number("skin", 0);
    const auto threads = static_cast<int>(arguments.whole("threads", 1));
    const auto pre = arguments.whole("pre", 1000), blocks = arguments.whole("blocks", 1);
    const auto steps = arguments.whole("steps", 3000);
    const std::string out = arguments.text("out", "");
    arguments.finish();

    const sim3d::WorldPtr world = bench::value_or_refuse(sim3d::build_world(scene, threads));
    if (const auto problem = sim3d::insert(*world, as_bodies(spheres)))
        bench::refuse(to_string(*problem));
    bench::advance_or_refuse(*world, pre);
    bench::timed_blocks(*world, "flow", blocks, steps);
    bench::print_summary(*world);
    if (!out.empty())
        bench::write_dump(out, *world);
}
