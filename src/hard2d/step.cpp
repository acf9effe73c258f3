#include "hard2d/step.h"

#include "solver/verbs.h"

namespace tumble::hard2d {

using solver::timed;

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
