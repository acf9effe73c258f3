// 65-sphere cones in the U trough slice, from a LIGGGHTS dump: wall at rest (A), then vibrating as in the thesis (B).
#include "scene/read_stl.h"
#include "support/arguments.h"
#include "support/fit_body.h"
#include "support/media.h"
#include "support/report.h"
#include "support/sphere_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/os.h>

using namespace tumble;

namespace {

constexpr double x_lo = -0.05, period = 0.1; // m, as in the peers' deck

scene::Scene slice(const std::string& cone, const std::string& stl) {
    scene::Scene scene = bench::media_scene();
    scene.domain.box = {{x_lo, -0.02, -0.26}, {x_lo + period, 1.32, 0.26}};
    scene.domain.periodic = {true, false, false};
    scene.bodies = {bench::read_template("cone", cone)};
    scene::Wall wall;
    wall.name = "trough";
    wall.shape = scene::MeshShape{stl, bench::value_or_refuse(scene::read_stl(stl))};
    wall.material = 1;
    scene.walls = {wall};
    return scene;
}

/// Thesis' excitation as the peers' deck has it: pure sines at 25 Hz, 1.949234 mm in y and 0.4038371 mm in z.
void vibrate_from(scene::Scene& scene, double start) {
    for (const auto& [axis, amplitude] : {std::pair{1, 1.949234e-3}, std::pair{2, 4.038371e-4}}) {
        scene::Harmonic harmonic;
        harmonic.active.start = start;
        harmonic.axis = axis;
        harmonic.amplitude = amplitude;
        harmonic.frequency = 25;
        scene.walls[0].motion.harmonics.push_back(harmonic);
    }
}

void write_rows(fmt::ostream& out, const sim3d::World& world) {
    for (const auto& body : sim3d::bodies_of(world))
        out.print("{:.9g} {} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", sim3d::time_of(world),
                  body.id, body.position.x(), body.position.y(), body.position.z(), body.velocity.x(),
                  body.velocity.y(), body.velocity.z(), body.angular_velocity.x(), body.angular_velocity.y(),
                  body.angular_velocity.z());
}

/// Advances `steps` steps and writes all bodies to `file` every `every` steps, the first row before the first step:
/// time_s id x y z (m) vx vy vz (m/s) wx wy wz (rad/s).
void recorded_run(sim3d::World& world, const std::string& file, std::int64_t steps, std::int64_t every) {
    auto out = fmt::output_file(file);
    write_rows(out, world);
    for (std::int64_t taken = 0; taken < steps;) {
        const std::int64_t now = std::min(every, steps - taken);
        bench::advance_or_refuse(world, now);
        taken += now;
        write_rows(out, world);
    }
}

} // namespace

/// state=DUMP cone=FILE stl=FILE threads=1 dt=1/350000 skin=0 pre=500 blocks=3 steps=1500 (A)
/// vibrate_blocks=0 vibrate_steps=14000 (B) out=DUMP; gravity=9.81; rows=FILE every=0: also records bodies,
/// `row_steps` of them at rest, then `row_vibrate_steps` vibrating, instead of the timed blocks.
int main(int count, char** words) {
    bench::Arguments arguments(count, words);
    scene::Scene scene = slice(arguments.text("cone", "cone65.txt"), arguments.text("stl", "trough.stl"));
    scene.time_step = arguments.number("dt", 1.0 / 350000);
    scene.skin = arguments.number("skin", 0);
    scene.gravity.y() = -arguments.number("gravity", 9.81);
    const auto spheres = bench::read_dump(arguments.text("state", "settled.dump"));
    const auto threads = static_cast<int>(arguments.whole("threads", 1));
    const auto pre = arguments.whole("pre", 500), blocks = arguments.whole("blocks", 3);
    const auto steps = arguments.whole("steps", 1500), every = arguments.whole("every", 0);
    const auto vibrate_blocks = arguments.whole("vibrate_blocks", 0);
    const auto vibrate_steps = arguments.whole("vibrate_steps", 14000);
    const auto row_steps = arguments.whole("row_steps", 0), row_vibrate_steps = arguments.whole("row_vibrate_steps", 0);
    const std::string rows = arguments.text("rows", ""), out = arguments.text("out", "");
    arguments.finish();

    const auto still = rows.empty() ? pre + blocks * steps : row_steps;
    if (vibrate_blocks + row_vibrate_steps > 0)
        vibrate_from(scene, static_cast<double>(still) * scene.time_step);
    const sim3d::WorldPtr world = bench::value_or_refuse(sim3d::build_world(scene, threads));
    const auto bodies = bench::fit_bodies(*world, spheres, x_lo, period, 2e-6);
    if (const auto problem = sim3d::insert(*world, bodies))
        bench::refuse(to_string(*problem));

    if (!rows.empty()) {
        recorded_run(*world, rows + ".rest", row_steps, every);
        if (!out.empty())
            bench::write_dump(out, *world);
        recorded_run(*world, rows + ".vibrating", row_vibrate_steps, every);
    } else {
        bench::advance_or_refuse(*world, pre);
        bench::timed_blocks(*world, "at rest", blocks, steps);
        if (!out.empty())
            bench::write_dump(out, *world);
        bench::timed_blocks(*world, "vibrating", vibrate_blocks, vibrate_steps);
    }
    bench::print_summary(*world);
}
