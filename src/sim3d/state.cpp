#include "sim3d/state.h"

#include "sim3d/state_flaw.h"
#include "sim3d/state_members.h"
#include "solver/state.h"

namespace tumble::sim3d {

namespace {

void adapt(World& world) {
    const auto follow = [&](std::vector<FurtherLanes>& further, std::size_t size) {
        world.ledger.lost_history += solver::adapt_further(further, size, world.remembers_more);
    };
    for (Chunk& chunk : world.chunks) {
        for (NearSpheres& near : chunk.near_spheres)
            follow(near.further, near.pairs.size());
        follow(chunk.candidates.further, chunk.candidates.spheres.size());
        follow(chunk.wall_further, max_wall_touches * chunk.wall_candidates.size());
    }
}

/// What does not follow from the members that were read one by one.
void complete(World& world) {
    world.slot_of.resize(world.id.size());
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        world.slot_of[static_cast<std::size_t>(world.id[slot])] = static_cast<int>(slot);
    for (Chunk& chunk : world.chunks) {
        chunk.body_contacts.resize(world.pairs.size());
        chunk.wall_contacts.resize(world.pairs.size());
    }
}

} // namespace

std::string state_of(const World& world) {
    return solver::state_of(world);
}

std::optional<Problem> restore(World& world, std::string_view state) {
    if (auto problem = solver::read_state(world, state, adapt, flaw_of))
        return problem;
    complete(world);
    return std::nullopt;
}

} // namespace tumble::sim3d
