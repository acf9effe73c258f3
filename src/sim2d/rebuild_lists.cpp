#include "sim2d/rebuild_lists.h"

#include "scene/period.h"
#include "solver/arrays.h"
#include "solver/leashes.h"

#include <algorithm>
#include <cmath>

namespace tumble::sim2d {

namespace {

using Eigen::Vector2d;

// Sorting moves every body in memory; neighbours drift apart slowly, so it pays only now and then.
constexpr std::int64_t rebuilds_per_sort = 4;

bool touches(const World& world, int row) {
    return world.row(row).radius > 0;
}

/// Radius and leash of a disc, m: discs whose reaches do not meet cannot touch yet.
double reach_of(const World& world, int row) {
    return world.row(row).radius - world.travel[static_cast<std::size_t>(row)];
}

void wrap(World& world) {
    const scene::Domain& domain = world.scene.domain;
    for (int slot = 0; slot < world.bodies(); ++slot) {
        Row& row = world.row(slot);
        for (const auto& [axis, x] : {std::pair{0, &row.x}, std::pair{1, &row.y}}) {
            const double moved = (domain.box.lo[axis] - domain.box.hi[axis]) * scene::periods_past(domain, axis, *x);
            *x += moved;
            // Where gravity has a part along the period, a body that comes in again brings the height that it lost.
            world.ledger.inserted -= row.mass * world.scene.gravity[axis] * moved;
        }
    }
}

void sort_slots(World& world) {
    std::vector<Vector2d>& centres = world.centres;
    centres.clear();
    for (int slot = 0; slot < world.bodies(); ++slot)
        centres.emplace_back(world.row(slot).x, world.row(slot).y);
    world.cells.sort(world.scene.domain, centres, 2 * world.largest_radius + world.skin);
    const std::vector<int>& order = world.cells.order();
    world.rows.resize(world.id.size());
    world.loads.resize(world.id.size());
    solver::reorder(world.id, order);
    solver::reorder(world.shape, order);
    solver::reorder(world.angle, order);
    solver::reorder(world.rows, order);
    solver::reorder(world.loads, order);
}

/// Rows for the discs of all clumps, behind those of the bodies.
void lay_out_discs(World& world) {
    const auto bodies = world.id.size();
    world.first_disc.resize(bodies);
    world.body_of.resize(bodies);
    auto row = bodies;
    for (std::size_t slot = 0; slot < bodies; ++slot) {
        const ShapeConstants& shape = world.shape_at(static_cast<int>(slot));
        world.body_of[slot] = static_cast<int>(slot);
        world.first_disc[slot] = static_cast<int>(row);
        row += shape.single ? 0 : static_cast<std::size_t>(shape.exposed_count);
        world.body_of.resize(row, static_cast<int>(slot));
    }
    world.rows.resize(row);
    world.loads.resize(row);
    world.travel.resize(row);
    for (std::size_t slot = 0; slot < bodies; ++slot)
        if (const ShapeConstants& shape = world.shape_at(static_cast<int>(slot)); !shape.single)
            place_discs(shape, world.rows[slot], world.angle[slot], &world.row(world.first_disc[slot]));
}

void cut_chunks(World& world) {
    const int bodies = world.bodies();
    const int count = solver::chunks_for(bodies);
    const auto disc_from = [&](int slot) {
        return slot < bodies ? world.first_disc[static_cast<std::size_t>(slot)] : static_cast<int>(world.rows.size());
    };
    world.chunks.resize(static_cast<std::size_t>(count));
    world.chunk_of.resize(world.rows.size());
    const auto kinds = static_cast<std::size_t>(world.materials * world.materials);
    for (int k = 0; k < count; ++k) {
        Chunk& chunk = world.chunks[static_cast<std::size_t>(k)];
        const auto [begin, end] = solver::range_of(k, count, bodies);
        chunk.owned = {begin, end, disc_from(begin), disc_from(end)};
        chunk.near_discs.resize(kinds);
        chunk.wall_contacts.resize(kinds);
        std::fill(world.chunk_of.begin() + begin, world.chunk_of.begin() + end, k);
        std::fill(world.chunk_of.begin() + chunk.owned.disc_begin, world.chunk_of.begin() + chunk.owned.disc_end, k);
    }
}

void clear(Chunk& chunk) {
    chunk.foreign_count = 0; // the letters of the last step are addressed to rows that may be others' now
    chunk.partners_after = 0;
    chunk.partners_before = 0;
    chunk.pairs.clear();
    for (NearDiscs& near : chunk.near_discs)
        near.clear();
    chunk.near_until = 0;
    chunk.wall_nears.clear();
    chunk.wall_further.clear();
    chunk.wall_pieces.clear();
}

// What touched a step ago has moved by no more than the fastest discs since; looking up the rest would take long.
bool may_remember(const World& world, double apart_squared, int a, int b) {
    const double reach = world.row(a).radius + world.row(b).radius + world.last_rush + 1e-3 * world.smallest_radius;
    return apart_squared < reach * reach;
}

// What the pair remembers stands in the near list, which find_candidates completes.
void add_pair(const World& world, Chunk& chunk, int a, int b, int image, double apart_squared) {
    const int kind = world.kind_of(a, world.shape_at(world.slot_of(b)).material);
    if (may_remember(world, apart_squared, a, b))
        if (const KeptPair* old = world.kept.of_pair(world.tag_of(a), world.tag_of(b))) {
            const FurtherMemory further = world.kept.further(old->further);
            chunk.near_discs[static_cast<std::size_t>(kind)].add({a, b, image, static_cast<int>(chunk.pairs.size())}, 1,
                                                                 old->memory,
                                                                 world.remembers_more ? &further : nullptr);
        }
    chunk.pairs.push_back({a, b, static_cast<std::int16_t>(image), static_cast<std::int16_t>(kind)});
}

void list_pairs_of(const World& world, Chunk& chunk, int a) {
    std::array<Cells::Seen, 9> seen{};
    const Vector2d& centre = world.centres[static_cast<std::size_t>(a)];
    const double own_reach = reach_of(world, a);
    const int own_periods = world.periods[static_cast<std::size_t>(a)];
    const int own_body = world.slot_of(a);
    const int count = world.cells.around(centre, seen);
    for (int k = 0; k < count; ++k) {
        const Cells::Seen& cell = seen[static_cast<std::size_t>(k)];
        const auto& shift = world.images[static_cast<std::size_t>(cell.image)].along;
        const Vector2d from = centre - Vector2d(shift[0], shift[1]);
        for (const int* b = cell.begin; b != cell.end; ++b) {
            if (*b <= a || !touches(world, *b) || world.slot_of(*b) == own_body)
                continue;
            const double reach = own_reach + reach_of(world, *b);
            const double apart_squared = (from - world.centres[static_cast<std::size_t>(*b)]).squaredNorm();
            if (apart_squared >= reach * reach)
                continue;
            chunk.partners_after |= solver::chunk_bit(world.chunk_of[static_cast<std::size_t>(*b)]);
            // build.cpp asks for periods so long that no digit of the sum runs over.
            const int image = cell.image + own_periods - world.periods[static_cast<std::size_t>(*b)];
            add_pair(world, chunk, a, *b, image, apart_squared);
        }
    }
}

void list_walls_of(const World& world, Chunk& chunk, int row, std::vector<int>& pieces) {
    for (std::size_t w = 0; w < world.walls.size(); ++w) {
        const WallState& wall = world.walls[w];
        wall.line.pieces_near(wall.frame.to_wall({world.row(row).x, world.row(row).y}),
                              reach_of(world, row) + world.wall_skin, pieces);
        if (pieces.empty())
            continue;
        WallNear near;
        near.row = row;
        near.wall = static_cast<int>(w);
        near.expires = solver::expired;
        near.pieces_begin = static_cast<int>(chunk.wall_pieces.size());
        near.pieces_count = static_cast<int>(pieces.size());
        chunk.wall_pieces.insert(chunk.wall_pieces.end(), pieces.begin(), pieces.end());
        std::array<FurtherMemory, max_wall_touches> further{};
        for (const KeptWall& old : world.kept.of_wall(world.tag_of(row)))
            if (old.wall == near.wall && near.touches < max_wall_touches) {
                further[static_cast<std::size_t>(near.touches)] = world.kept.further(old.further);
                near.memory[static_cast<std::size_t>(near.touches++)] = old.memory;
            }
        if (world.remembers_more)
            chunk.wall_further.insert(chunk.wall_further.end(), further.begin(), further.end());
        chunk.wall_nears.push_back(near);
    }
}

template <class Each> void for_touching_rows(const World& world, const Chunk& chunk, Each&& each) {
    for (int row = chunk.owned.body_begin; row < chunk.owned.body_end; ++row)
        if (touches(world, row))
            each(row);
    for (int row = chunk.owned.disc_begin; row < chunk.owned.disc_end; ++row)
        each(row);
}

void give_leashes(World& world) {
    for (std::size_t row = 0; row < world.rows.size(); ++row) {
        const Row& at = world.rows[row];
        world.travel[row] = (Vector2d(at.vx, at.vy) - world.flow.at(Vector2d(at.x, at.y))).norm();
    }
    solver::start_odometers(world.travel, world.skin);
}

/// Where the rows stand inside the periodic box. Of a clump whose centre of mass is inside, discs may stand past it.
void find_centres(World& world) {
    const scene::Box& box = world.scene.domain.box;
    world.centres.clear();
    world.periods.clear();
    for (const Row& row : world.rows) {
        Vector2d centre(row.x, row.y), past;
        for (int axis = 0; axis < 2; ++axis) {
            past[axis] = scene::periods_past(world.scene.domain, axis, centre[axis]);
            centre[axis] -= past[axis] * (box.hi[axis] - box.lo[axis]);
        }
        world.centres.push_back(centre);
        world.periods.push_back(image_index(static_cast<int>(past.x()), static_cast<int>(past.y())) -
                                image_index(0, 0));
    }
}

} // namespace

void rebuild_lists(World& world) {
    // Insertion has taken it before it added rows.
    if (!world.stale)
        world.kept.take(world);
    wrap(world);
    if (world.stale || world.rebuilds % rebuilds_per_sort == 0)
        sort_slots(world);
    lay_out_discs(world);
    give_leashes(world);
    find_centres(world);
    const double longest = world.travel.empty() ? 0 : -*std::min_element(world.travel.begin(), world.travel.end());
    world.cells.sort(world.scene.domain, world.centres, 2 * (world.largest_radius + longest));
    cut_chunks(world);
    for (WallState& wall : world.walls)
        wall.travel = 0;
    for_chunks(world, [&](Chunk& chunk) {
        clear(chunk);
        std::vector<int> pieces;
        for_touching_rows(world, chunk, [&](int row) {
            list_pairs_of(world, chunk, row);
            list_walls_of(world, chunk, row, pieces);
        });
    });
    solver::find_partners(world.chunks);
    world.kept.forget();
    world.stale = false;
    ++world.rebuilds;
}

} // namespace tumble::sim2d
