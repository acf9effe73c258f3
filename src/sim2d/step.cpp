#include "sim2d/step.h"

namespace tumble::sim2d {

void step(World& world) {
    timed(Phase::move_walls, move_walls, world);
    timed(Phase::list_neighbours, list_neighbours, world);
    for_chunks(
        world,
        [&](Chunk& chunk) {
            timed(Phase::find_candidates, find_candidates, world, chunk);
            timed(Phase::push_gravity, push_gravity, world, chunk);
            timed(Phase::push_air, push_air, world, chunk);
            timed(Phase::touch_candidates, touch_candidates, world, chunk);
            timed(Phase::push_contacts, push_contacts, world, chunk);
        },
        [&](Chunk& chunk) {
            timed(Phase::collect_pushes, collect_pushes, world, chunk);
            timed(Phase::integrate, integrate, world, chunk);
        });
    timed(Phase::book_energy, book_energy, world);
}

} // namespace tumble::sim2d
