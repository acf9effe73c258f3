#include "sim3d/rebuild_lists.h"

#include "scene/period.h"
#include "sim3d/placement.h"
#include "solver/arrays.h"
#include "solver/leashes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

/// Moves bodies back into the periodic box; fills World::wraps with the periods that each was moved, or empties it if
/// none was.
void wrap(World& world) {
    const scene::Domain& domain = world.scene.domain;
    world.wraps.clear();
    for (std::size_t slot = 0; slot < world.motion.size(); ++slot)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double length = domain.box.hi[axis] - domain.box.lo[axis];
            double& x = world.motion[slot].position[k];
            const double periods = scene::periods_past(domain, axis, x);
            if (periods == 0)
                continue;
            x -= length * periods;
            // Where gravity has a part along the period, a body that comes in again brings the height that it lost.
            world.ledger.inserted += world.motion[slot].mass * world.scene.gravity[axis] * length * periods;
            if (world.wraps.empty())
                world.wraps.assign(world.motion.size(), {0, 0, 0});
            world.wraps[slot][k] = static_cast<int>(periods);
        }
}

void sort_slots(World& world, const std::vector<int>& order) {
    solver::reorder(world.id, order);
    solver::reorder(world.shape, order);
    solver::reorder(world.motion, order);
    solver::reorder(world.load, order);
    solver::reorder(world.orientation, order);
    if (world.has_clumps)
        solver::reorder(world.turn, order);
    solver::reorder(world.travel, order);
    solver::reorder(world.bounds, order);
    for (std::size_t slot = 0; slot < world.id.size(); ++slot)
        world.slot_of[static_cast<std::size_t>(world.id[slot])] = static_cast<int>(slot);
}

void cut_chunks(World& world) {
    const int bodies = world.bodies();
    const int count = solver::chunks_for(bodies);
    world.chunks.resize(static_cast<std::size_t>(count));
    world.chunk_of.resize(static_cast<std::size_t>(bodies));
    const auto kinds = static_cast<std::size_t>(world.materials * world.materials);
    for (int k = 0; k < count; ++k) {
        Chunk& chunk = world.chunks[static_cast<std::size_t>(k)];
        std::tie(chunk.begin, chunk.end) = solver::range_of(k, count, bodies);
        chunk.near_spheres.resize(kinds);
        chunk.body_contacts.resize(kinds);
        chunk.wall_contacts.resize(kinds);
        std::fill(world.chunk_of.begin() + chunk.begin, world.chunk_of.begin() + chunk.end, k);
    }
}

void clear(Chunk& chunk) {
    chunk.foreign_count = 0; // the letters of the last step are addressed to slots that may be others' now
    chunk.partners_after = 0;
    chunk.partners_before = 0;
    chunk.sphere_pairs.clear();
    for (NearSpheres& near : chunk.near_spheres)
        near.clear();
    chunk.near_until = 0;
    chunk.body_pairs.clear();
    chunk.candidates.resize(0, true);
    chunk.body_walls.clear();
    chunk.wall_primitives.clear();
    chunk.wall_candidates.clear();
    chunk.wall_further.clear();
    chunk.sphere_primitives.clear();
}

// What touched a step ago has moved by no more than the fastest bodies since; looking up the rest would take long.
bool may_remember(const World& world, int a, int b, int image) {
    const BodyMotion& body_a = world.motion[static_cast<std::size_t>(a)];
    const BodyMotion& body_b = world.motion[static_cast<std::size_t>(b)];
    const Vector3d d = Vector3d(body_a.position) - Vector3d(body_b.position) -
                       Vector3d(world.images[static_cast<std::size_t>(image)].along);
    const double reach = body_a.radius + body_b.radius + 2.001 * world.books.speed_max * world.dt + world.longest_neck;
    return d.squaredNorm() < reach * reach;
}

FurtherLanes further_of(const World& world, const KeptPair& old, bool straight) {
    return straight ? world.kept.further(old.further) : mirrored(world.kept.further(old.further));
}

// What the pair remembers stands in the near list, which find_candidates completes.
void add_sphere_pair(const World& world, Chunk& chunk, int a, int b, int image) {
    const auto id_a = world.id[static_cast<std::size_t>(a)];
    const auto id_b = world.id[static_cast<std::size_t>(b)];
    const int kind = world.kind_of(a, world.shape_at(b).material);
    if (may_remember(world, a, b, image))
        world.kept.of_pair(id_a, id_b, image, [&](const KeptPair& old, bool straight) {
            const FurtherLanes further = further_of(world, old, straight);
            chunk.near_spheres[static_cast<std::size_t>(kind)].add(
                {a, b, image, static_cast<int>(chunk.sphere_pairs.size())}, 1,
                straight ? old.memory : mirrored(old.memory), world.remembers_more ? &further : nullptr);
        });
    chunk.sphere_pairs.push_back({a, b, static_cast<std::int16_t>(image), static_cast<std::int16_t>(kind)});
}

// The pair starts expired, with only what it remembers; the first refresh completes it.
void add_body_pair(const World& world, Chunk& chunk, int a, int b, int image) {
    const auto id_a = world.id[static_cast<std::size_t>(a)];
    const auto id_b = world.id[static_cast<std::size_t>(b)];
    ClumpCandidates& candidates = chunk.candidates;
    BodyPair pair{a, b, solver::expired, candidates.size(), 0, 0, static_cast<std::int16_t>(image)};
    world.kept.of_pair(id_a, id_b, image, [&](const KeptPair& old, bool straight) {
        const int sphere_a = straight ? old.sphere_of_first : old.sphere_of_second;
        const int sphere_b = straight ? old.sphere_of_second : old.sphere_of_first;
        const FurtherLanes further = further_of(world, old, straight);
        candidates.resize(candidates.size() + 1, world.remembers_more);
        candidates.set(candidates.size() - 1,
                       {static_cast<std::int16_t>(sphere_a), static_cast<std::int16_t>(sphere_b)}, true,
                       straight ? old.memory : mirrored(old.memory), world.remembers_more ? &further : nullptr);
        ++pair.count;
    });
    pair.capacity = pair.count;
    chunk.body_pairs.push_back(pair);
}

void add_pair(const World& world, Chunk& chunk, int a, int b, int image) {
    chunk.partners_after |= solver::chunk_bit(world.chunk_of[static_cast<std::size_t>(b)]);
    if (world.shape_at(a).single && world.shape_at(b).single)
        add_sphere_pair(world, chunk, a, b, image);
    else
        add_body_pair(world, chunk, a, b, image);
}

/// A pair belongs to the chunk of the body with the lower slot. Slots are in the cells' order.
void list_pairs(const World& world, Chunk& chunk) {
    std::array<Cells::Seen, 27> seen{};
    int cell = -1;
    int rows = 0;
    for (int a = chunk.begin; a < chunk.end; ++a) {
        const Bounds& own = world.bounds[static_cast<std::size_t>(a)];
        if (const int here = world.cells.cell_of(own.centre); here != cell) {
            cell = here;
            rows = world.cells.around(own.centre, seen);
        }
        for (int row = 0; row < rows; ++row) {
            const Cells::Seen& cells = seen[static_cast<std::size_t>(row)];
            const int begin = std::max(cells.begin, a + 1);
            if (begin >= cells.end)
                continue;
            Bounds from = own;
            for (int k = 0; k < 3; ++k)
                from.centre[k] -= world.images[static_cast<std::size_t>(cells.image)].along[k];
            chunk.found.resize(std::max(chunk.found.size(), static_cast<std::size_t>(cells.end - begin) + 8));
            const int count =
                world.kernels->near_bodies(world.bounds.data(), begin, cells.end, from, chunk.found.data());
            for (int k = 0; k < count; ++k)
                add_pair(world, chunk, a, chunk.found[static_cast<std::size_t>(k)], cells.image);
        }
    }
}

void add_body_wall(const World& world, Chunk& chunk, BodyWall near) {
    for (const KeptWall& old : world.kept.of_wall(world.id[static_cast<std::size_t>(near.body)])) {
        if (old.wall != near.wall)
            continue;
        WallCandidate candidate;
        candidate.sphere = static_cast<std::int16_t>(old.sphere);
        candidate.touches = 1;
        candidate.memory[0] = old.memory;
        chunk.wall_candidates.push_back(candidate);
        if (world.remembers_more) {
            chunk.wall_further.resize(max_wall_touches * chunk.wall_candidates.size());
            chunk.wall_further[chunk.wall_further.size() - max_wall_touches] = world.kept.further(old.further);
        }
        ++near.count;
    }
    near.capacity = near.count;
    chunk.body_walls.push_back(near);
}

void list_walls(const World& world, Chunk& chunk) {
    std::vector<int> primitives;
    for (int body = chunk.begin; body < chunk.end; ++body)
        for (std::size_t w = 0; w < world.walls.size(); ++w) {
            const WallState& wall = world.walls[w];
            const Bounds& bounds = world.bounds[static_cast<std::size_t>(body)];
            const Vector3d centre = Vector3d(bounds.centre) - wall.pose.translation;
            wall.surface.primitives_near(wall.pose.rotation.transpose() * centre, bounds.reach + world.wall_skin,
                                         primitives);
            if (primitives.empty())
                continue;
            BodyWall near;
            near.body = body;
            near.wall = static_cast<int>(w);
            near.expires = solver::expired;
            near.primitives_begin = static_cast<int>(chunk.wall_primitives.size());
            near.primitives_count = static_cast<int>(primitives.size());
            near.begin = static_cast<int>(chunk.wall_candidates.size());
            chunk.wall_primitives.insert(chunk.wall_primitives.end(), primitives.begin(), primitives.end());
            add_body_wall(world, chunk, near);
        }
}

void give_leashes(World& world) {
    const auto bodies = static_cast<std::size_t>(world.bodies());
    world.travel.resize(bodies);
    for (std::size_t slot = 0; slot < bodies; ++slot) {
        const BodyMotion& body = world.motion[slot];
        const ShapeConstants& shape = world.shape_at(static_cast<int>(slot));
        world.travel[slot] = (Vector3d(body.velocity) - world.flow.at(Vector3d(body.position))).norm() +
                             (shape.single ? 0 : Vector3d(body.spin).norm() * shape.reach);
    }
    solver::start_odometers(world.travel, world.skin);
}

void find_bounds(World& world) {
    world.bounds.resize(world.id.size());
    for (int slot = 0; slot < world.bodies(); ++slot) {
        Bounds& bounds = world.bounds[static_cast<std::size_t>(slot)];
        Eigen::Map<Vector3d>{bounds.centre} = bounding_centre(world, placement_of(world, slot));
        bounds.reach = world.shape_at(slot).bounding_radius - world.travel[static_cast<std::size_t>(slot)];
    }
}

/// Cells in which two bodies whose bounds meet are neighbours.
double cell_width(const World& world) {
    double reach = 0;
    double offset = 0;
    for (const Bounds& bounds : world.bounds)
        reach = std::max(reach, bounds.reach);
    for (const ShapeConstants& shape : world.shape_constants)
        offset = std::max(offset, Vector3d(shape.bounding_centre).norm());
    // A body is wrapped by its mass centre, so its bounding sphere may stand this far outside the periodic box.
    return 2 * reach + offset;
}

} // namespace

void rebuild_lists(World& world) {
    wrap(world);
    world.kept.take(world, world.wraps);
    give_leashes(world);
    find_bounds(world);
    world.cells.sort(world.scene.domain, world.bounds, cell_width(world));
    sort_slots(world, world.cells.order());
    cut_chunks(world);
    for (WallState& wall : world.walls)
        wall.travel = 0;
    for_chunks(world, [&](Chunk& chunk) {
        clear(chunk);
        list_pairs(world, chunk);
        list_walls(world, chunk);
    });
    solver::find_partners(world.chunks);
    world.stale = false;
    ++world.rebuilds;
}

} // namespace tumble::sim3d
