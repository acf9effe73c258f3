#include "sim3d/step.h"

#include "sim3d/phase.h"

namespace tumble::sim3d {

void step(World& world) {
    timed(world, "find_candidates", find_candidates);
    timed(world, "touch_candidates", touch_candidates);
    timed(world, "push_gravity", push_gravity);
    timed(world, "push_contacts", push_contacts);
    timed(world, "integrate", integrate);
    timed(world, "book_energy", book_energy);
}

} // namespace tumble::sim3d
