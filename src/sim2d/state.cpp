#include "sim2d/state.h"

#include "sim2d/state_flaw.h"
#include "sim2d/state_members.h"
#include "solver/state.h"

namespace tumble::sim2d {

namespace {

void adapt(World& world) {
    const auto follow = [&](std::vector<FurtherMemory>& further, std::size_t size) {
        world.ledger.lost_history += solver::adapt_further(further, size, world.remembers_more);
    };
    for (Chunk& chunk : world.chunks) {
        for (NearDiscs& near : chunk.near_discs)
            follow(near.further, near.pairs.size());
        follow(chunk.wall_further, max_wall_touches * chunk.wall_nears.size());
    }
}

/// What does not follow from the members that were read one by one.
void complete(World& world) {
    std::vector<int> slot_of(world.id.size());
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        slot_of[static_cast<std::size_t>(world.id[slot])] = static_cast<int>(slot);
    for (const int slot : slot_of) {
        world.first_tag.push_back(world.tags);
        world.tags += world.shape_at(slot).exposed_count;
    }
    for (Chunk& chunk : world.chunks) {
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

} // namespace tumble::sim2d
