// A few bodies in free flight or against the plane y = 0, every step written down: for comparing single contacts.
#include "base/text.h"
#include "sim3d/solver.h"
#include "support/arguments.h"
#include "support/media.h"
#include "support/report.h"

#include <fmt/core.h>
#include <fstream>
#include <sstream>

using namespace tumble;

namespace {

/// Lines "template ox oy oz qw qx qy qz vx vy vz wx wy wz": index of the template, where its written origin lies (m),
/// how its written frame is turned, velocity of the centre of mass (m/s), angular velocity (rad/s).
std::vector<sim3d::BodyState> read_bodies(const std::string& file, const std::vector<sim3d::BodyShape>& shapes) {
    std::ifstream in(file);
    std::vector<sim3d::BodyState> bodies;
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::size_t shape = 0;
        double x[13];
        words >> shape;
        for (double& value : x)
            words >> value;
        if (!words || shape >= shapes.size())
            bench::refuse(fmt::format("{}: cannot read '{}'", file, line));
        const Eigen::Quaterniond turn(x[3], x[4], x[5], x[6]);
        sim3d::BodyState body;
        body.shape = static_cast<int>(shape);
        body.position = Eigen::Vector3d(x[0], x[1], x[2]) + turn * shapes[shape].written_centre;
        body.orientation = turn * shapes[shape].written_from_principal;
        body.velocity = {x[7], x[8], x[9]};
        body.angular_velocity = {x[10], x[11], x[12]};
        bodies.push_back(body);
    }
    return bodies;
}

scene::Scene two_materials(bench::Arguments& arguments) {
    scene::Scene scene = bench::media_scene();
    scene.materials[0] = {"media", arguments.number("density", 1665.71), arguments.number("E", 4.6e8),
                          arguments.number("nu", 0.2887)};
    scene.materials[1] = {"wall", 1000, arguments.number("Ew", 2.5e7), arguments.number("nuw", 0.25)};
    for (auto& pair : scene.pairs) {
        pair.restitution = arguments.number("e", 0.67);
        pair.friction = arguments.number("mu", 0.58);
    }
    scene.gravity = {0, -arguments.number("g", 0), 0};
    scene.time_step = arguments.number("dt", 1e-6);
    const double half = arguments.number("half_box", 1);
    scene.domain.box = {{-half, -half, -half}, {half, half, half}};
    if (arguments.whole("plane", 1) != 0) {
        scene::Wall plane;
        plane.name = "plane";
        plane.shape = scene::PlaneShape{};
        plane.material = 1;
        scene.walls = {plane};
    }
    return scene;
}

void print_bodies(const sim3d::World& world) {
    for (const auto& b : sim3d::bodies_of(world)) {
        fmt::print("{} {}", sim3d::steps_of(world), b.id);
        for (const Eigen::Vector3d& v : {b.position, b.velocity, b.angular_velocity})
            fmt::print(" {:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
        fmt::print(" {:.17g} {:.17g} {:.17g} {:.17g}\n", b.orientation.w(), b.orientation.x(), b.orientation.y(),
                   b.orientation.z());
    }
}

} // namespace

/// templates=FILE,... bodies=FILE density E nu Ew nuw e mu g dt half_box plane=1|0 nstep every mass inertia=x,y,z
/// Prints "step id x y z vx vy vz wx wy wz qw qx qy qz" of every body, centres of mass, principal frames.
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    scene::Scene scene = two_materials(arguments);
    for (const std::string& file : arguments.words("templates"))
        scene.bodies.push_back(bench::read_template("body", file));
    if (scene.bodies.empty())
        bench::refuse("templates=FILE,... is missing");
    if (const double mass = arguments.number("mass", 0); mass > 0)
        scene.bodies[0].mass = mass;
    if (const auto inertia = arguments.numbers("inertia"); inertia.size() == 3)
        scene.bodies[0].principal_inertia = Eigen::Vector3d(inertia[0], inertia[1], inertia[2]);
    const auto steps = arguments.whole("nstep", 1000), every = arguments.whole("every", 1);
    const std::string bodies = arguments.text("bodies", "bodies.txt");
    arguments.finish();

    const sim3d::WorldPtr world = bench::value_or_refuse(sim3d::build_world(scene, 1));
    if (const auto problem = sim3d::insert(*world, read_bodies(bodies, sim3d::shapes_of(*world))))
        bench::refuse(to_string(*problem));
    print_bodies(*world);
    for (std::int64_t step = 0; step < steps; step += every) {
        bench::advance_or_refuse(*world, every);
        print_bodies(*world);
    }
}
