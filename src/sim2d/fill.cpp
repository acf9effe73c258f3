#include "sim2d/fill.h"

#include "discs/fill.h"

namespace tumble::sim2d {

namespace {

discs::Site site_of(const World& world, const Tally& tally) {
    discs::Site site{world.scene, world.shapes, {}, {}, world.step, world.dt, world.stop, tally};
    for (const WallState& wall : world.walls)
        site.walls.push_back({&wall.line, wall.frame});
    for (int slot = 0; slot < world.bodies(); ++slot)
        site.bodies.push_back({world.shape[static_cast<std::size_t>(slot)],
                               {world.row(slot).x, world.row(slot).y},
                               world.angle[static_cast<std::size_t>(slot)]});
    return site;
}

} // namespace

Problems prepare_fills(World& world) {
    Result<std::vector<FillState>> fills =
        solver::begin_fills(world.scene, solver::masses_of(world.plain_shapes), world.dt);
    if (!fills)
        return fills.problems();
    world.fills = std::move(*fills);
    world.next_fill_step = solver::next_due(world.fills);
    return {};
}

std::optional<Problem> insert_due_fills(World& world, const Tally& tally) {
    const Result<std::vector<BodyState>> placed = discs::place_due(world.fills, site_of(world, tally));
    if (!placed)
        return placed.problems().front();
    world.next_fill_step = solver::next_due(world.fills);
    return insert(world, *placed);
}

std::vector<std::string> unfilled(const World& world) {
    return discs::owed_by(world.fills, world.shapes);
}

} // namespace tumble::sim2d
