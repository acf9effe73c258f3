#include "sim2d/step.h"

#include <algorithm>
#include <limits>

namespace tumble::sim2d {

namespace {

void find_near_discs(const World& world, Chunk& chunk) {
    chunk.found.resize(chunk.pairs.size() + 1);
    // What touched a step ago must stay listed until it is seen apart, however fast it left.
    const double skin = std::max(world.near_skin, world.last_rush);
    const int count =
        world.kernels->near_discs(world.rows.data(), chunk.pairs.data(), static_cast<int>(chunk.pairs.size()),
                                  world.images.data(), skin, chunk.found.data());
    solver::list_near(chunk.near_discs, chunk.pairs, {chunk.found.data(), static_cast<std::size_t>(count)},
                      world.remembers_more);
    chunk.near_until = world.rush + skin;
}

/// Looks how far the disc is from the wall: it need not be asked again before both odometers have advanced that far.
void look(const World& world, const Chunk& chunk, WallNear& near, double travelled) {
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const Row& row = world.row(near.row);
    const Eigen::Vector2d centre = wall.frame.to_wall({row.x, row.y});
    double gap = std::numeric_limits<double>::infinity();
    for (int k = near.pieces_begin; k < near.pieces_begin + near.pieces_count; ++k)
        gap = std::min(gap, wall.line.distance(chunk.wall_pieces[static_cast<std::size_t>(k)], centre) - row.radius);
    near.awake = gap < world.near_skin || near.touches > 0;
    near.expires = travelled + (near.awake ? world.near_skin : gap);
}

} // namespace

void find_candidates(World& world, Chunk& chunk) {
    if (world.rush >= chunk.near_until && !chunk.pairs.empty())
        find_near_discs(world, chunk);
    for (WallNear& near : chunk.wall_nears) {
        const double travelled =
            world.travel[static_cast<std::size_t>(near.row)] + world.walls[static_cast<std::size_t>(near.wall)].travel;
        if (travelled >= near.expires)
            look(world, chunk, near, travelled);
    }
}

} // namespace tumble::sim2d
