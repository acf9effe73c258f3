#include "hard2d/step.h"

namespace tumble::hard2d {

namespace {

template <class Verb> void timed(Phase phase, Verb verb, World& world) {
    const Stopwatch watch(world.seconds[static_cast<std::size_t>(phase)]);
    verb(world);
}

} // namespace

void step(World& world) {
    timed(Phase::move_walls, move_walls, world);
    timed(Phase::solve, solve, world);
    timed(Phase::book_energy, book_energy, world);
}

void move_walls(World& world) {
    for (Wall& wall : world.walls)
        wall.send_to(scene::pose_at(wall.motion(), world.time() + world.dt), world.units, world.dt);
}

void solve(World& world) {
    world.box->Step(static_cast<float>(world.dt), world.scene.box2d.velocity_iterations,
                    world.scene.box2d.position_iterations);
}

} // namespace tumble::hard2d
