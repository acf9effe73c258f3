#include "sim2d/state_flaw.h"

#include "solver/state.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim2d {

namespace {

using solver::below;
using solver::range_in;

std::string flaw_of_bodies(const World& world) {
    const std::size_t bodies = world.id.size();
    if (world.shape.size() != bodies || world.angle.size() != bodies || world.rows.size() < bodies ||
        world.loads.size() != world.rows.size())
        return "its arrays have different lengths";
    if (std::string flaw = solver::flaw_of_bodies(world.id, world.shape, world.shape_constants.size()); !flaw.empty())
        return flaw;
    for (const Row& row : world.rows)
        if (!std::isfinite(row.x) || !std::isfinite(row.y) || !std::isfinite(row.vx) || !std::isfinite(row.vy) ||
            !std::isfinite(row.spin) || !(row.mass > 0))
            return "a body has a position, speed or mass that is none";
    return "";
}

/// Rows of discs, and who owns which row.
bool rows_fit(const World& world) {
    const std::size_t rows = world.rows.size();
    if (world.body_of.size() != rows || world.chunk_of.size() != rows || world.travel.size() != rows ||
        world.first_disc.size() != world.id.size())
        return false;
    for (int slot = 0; slot < world.bodies(); ++slot)
        if (!world.shape_at(slot).single &&
            !range_in(world.first_disc[static_cast<std::size_t>(slot)], world.shape_at(slot).exposed_count, rows))
            return false;
    for (std::size_t row = 0; row < rows; ++row)
        if (!below(world.body_of[row], world.id.size()) || !below(world.chunk_of[row], world.chunks.size()) ||
            (row >= world.id.size() && world.shape_at(world.body_of[row]).single))
            return false;
    return true;
}

/// Whether the row is a disc's, or a body's that is one: with a place among the tags.
bool is_disc(const World& world, int row) {
    if (!below(row, world.rows.size()))
        return false;
    const int slot = world.slot_of(row);
    const int disc = row - world.first_disc[static_cast<std::size_t>(slot)];
    return row < world.bodies() ? row == slot && world.shape_at(slot).single
                                : disc >= 0 && disc < world.shape_at(slot).exposed_count;
}

bool fits(const World& world, const Chunk& chunk, const NearDiscs& near) {
    if (near.further.size() != (world.remembers_more ? near.pairs.size() : 0))
        return false;
    return std::all_of(near.pairs.begin(), near.pairs.end(), [&](const NearPair& pair) {
        return is_disc(world, pair.a) && is_disc(world, pair.b) && below(pair.image, world.images.size()) &&
               below(pair.listed, chunk.pairs.size());
    });
}

bool fits(const World& world, const DiscPair& pair) {
    return is_disc(world, pair.a) && is_disc(world, pair.b) && below(pair.image, world.images.size()) &&
           below(pair.kind, world.pairs.size());
}

bool fits(const World& world, const Chunk& chunk, const WallNear& near) {
    if (!is_disc(world, near.row) || !below(near.wall, world.walls.size()) || near.touches < 0 ||
        near.touches > max_wall_touches || !range_in(near.pieces_begin, near.pieces_count, chunk.wall_pieces.size()))
        return false;
    const auto pieces = static_cast<std::size_t>(world.walls[static_cast<std::size_t>(near.wall)].line.pieces());
    const auto first = chunk.wall_pieces.begin() + near.pieces_begin;
    return std::all_of(first, first + near.pieces_count, [&](int piece) { return below(piece, pieces); });
}

bool fits(const World& world, const Chunk& chunk) {
    const auto all = [](const auto& list, auto&& fit) { return std::all_of(list.begin(), list.end(), fit); };
    return chunk.near_discs.size() == world.pairs.size() &&
           chunk.wall_further.size() == (world.remembers_more ? max_wall_touches * chunk.wall_nears.size() : 0) &&
           all(chunk.pairs, [&](const DiscPair& pair) { return fits(world, pair); }) &&
           all(chunk.near_discs, [&](const NearDiscs& near) { return fits(world, chunk, near); }) &&
           all(chunk.wall_nears, [&](const WallNear& near) { return fits(world, chunk, near); });
}

bool chunks_fit(const World& world) {
    int body = 0, disc = world.bodies();
    for (const Chunk& chunk : world.chunks) {
        const Owned& owned = chunk.owned;
        if (owned.body_begin != body || owned.body_end < body || owned.disc_begin != disc || owned.disc_end < disc ||
            !fits(world, chunk))
            return false;
        body = owned.body_end;
        disc = owned.disc_end;
    }
    return body == world.bodies() && disc == static_cast<int>(world.rows.size());
}

} // namespace

std::string flaw_of(const World& world) {
    if (const std::string flaw = flaw_of_bodies(world); !flaw.empty())
        return flaw;
    if (world.chunks.size() > static_cast<std::size_t>(solver::most_chunks))
        return "its chunks are too many";
    if (!world.kept.sound())
        return "what contacts remember leads nowhere";
    // Lists that the next step makes anew are not read before.
    if (!world.stale && (!rows_fit(world) || !chunks_fit(world)))
        return "a list of neighbours leads nowhere";
    return "";
}

} // namespace tumble::sim2d
