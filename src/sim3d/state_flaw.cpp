#include "sim3d/state_flaw.h"

#include "solver/state.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;
using solver::below;
using solver::range_in;

std::string flaw_of_bodies(const World& world) {
    const std::size_t bodies = world.id.size();
    if (world.shape.size() != bodies || world.motion.size() != bodies || world.load.size() != bodies ||
        world.orientation.size() != bodies || world.turn.size() != bodies || world.travel.size() != bodies)
        return "its arrays have different lengths";
    if (std::string flaw = solver::flaw_of_bodies(world.id, world.shape, world.shape_constants.size()); !flaw.empty())
        return flaw;
    for (const BodyMotion& motion : world.motion)
        if (!Vector3d(motion.position).allFinite() || !Vector3d(motion.velocity).allFinite() ||
            !Vector3d(motion.spin).allFinite() || !(motion.mass > 0))
            return "a body has a position, speed or mass that is none";
    return "";
}

bool fits(const World& world, const Chunk& chunk, const NearSpheres& near) {
    if (near.further.size() != (world.remembers_more ? near.pairs.size() : 0))
        return false;
    return std::all_of(near.pairs.begin(), near.pairs.end(), [&](const NearPair& pair) {
        return below(pair.a, world.id.size()) && below(pair.b, world.id.size()) &&
               below(pair.image, world.images.size()) && below(pair.listed, chunk.sphere_pairs.size());
    });
}

bool fits(const World& world, const SpherePair& pair) {
    return below(pair.a, world.id.size()) && below(pair.b, world.id.size()) && below(pair.image, world.images.size()) &&
           below(pair.kind, world.pairs.size());
}

bool fits(const World& world, const Chunk& chunk, const BodyPair& pair) {
    if (!below(pair.a, world.id.size()) || !below(pair.b, world.id.size()) || !below(pair.image, world.images.size()) ||
        pair.count > pair.capacity || !range_in(pair.begin, pair.capacity, chunk.candidates.spheres.size()) ||
        pair.count < 0)
        return false;
    const auto first = chunk.candidates.spheres.begin() + pair.begin;
    return std::all_of(first, first + pair.count, [&](const SphereCandidate& spheres) {
        return below(spheres.a, static_cast<std::size_t>(world.shape_at(pair.a).exposed_count)) &&
               below(spheres.b, static_cast<std::size_t>(world.shape_at(pair.b).exposed_count));
    });
}

bool fits(const World& world, const Chunk& chunk, const BodyWall& near) {
    if (!below(near.body, world.id.size()) || !below(near.wall, world.walls.size()) || near.count > near.capacity ||
        near.count < 0 || !range_in(near.begin, near.capacity, chunk.wall_candidates.size()) ||
        !range_in(near.primitives_begin, near.primitives_count, chunk.wall_primitives.size()))
        return false;
    const auto primitives =
        static_cast<std::size_t>(world.walls[static_cast<std::size_t>(near.wall)].surface.primitives());
    const auto are_the_walls = [&](const std::vector<int>& pool, int begin, int count) {
        return std::all_of(pool.begin() + begin, pool.begin() + begin + count,
                           [&](int primitive) { return below(primitive, primitives); });
    };
    if (!are_the_walls(chunk.wall_primitives, near.primitives_begin, near.primitives_count))
        return false;
    const auto first = chunk.wall_candidates.begin() + near.begin;
    return std::all_of(first, first + near.count, [&](const WallCandidate& candidate) {
        return below(candidate.sphere, static_cast<std::size_t>(world.shape_at(near.body).exposed_count)) &&
               candidate.touches >= 0 && candidate.touches <= max_wall_touches &&
               range_in(candidate.primitives_begin, candidate.primitives_count, chunk.sphere_primitives.size()) &&
               are_the_walls(chunk.sphere_primitives, candidate.primitives_begin, candidate.primitives_count);
    });
}

bool fits(const World& world, const Chunk& chunk) {
    const ClumpCandidates& candidates = chunk.candidates;
    const auto all = [](const auto& list, auto&& fit) { return std::all_of(list.begin(), list.end(), fit); };
    return chunk.near_spheres.size() == world.pairs.size() &&
           candidates.touching.size() == candidates.spheres.size() + 8 &&
           candidates.further.size() == (world.remembers_more ? candidates.spheres.size() : 0) &&
           chunk.wall_further.size() == (world.remembers_more ? max_wall_touches * chunk.wall_candidates.size() : 0) &&
           all(chunk.sphere_pairs, [&](const SpherePair& pair) { return fits(world, pair); }) &&
           all(chunk.near_spheres, [&](const NearSpheres& near) { return fits(world, chunk, near); }) &&
           all(chunk.body_pairs, [&](const BodyPair& pair) { return fits(world, chunk, pair); }) &&
           all(chunk.body_walls, [&](const BodyWall& near) { return fits(world, chunk, near); });
}

} // namespace

std::string flaw_of(const World& world) {
    if (const std::string flaw = flaw_of_bodies(world); !flaw.empty())
        return flaw;
    if (world.chunks.size() > static_cast<std::size_t>(solver::most_chunks) || world.chunk_of.size() > world.id.size())
        return "its chunks are too many";
    // Lists that are made anew in the next step may still speak of fewer bodies.
    if (!world.stale && world.chunk_of.size() != world.id.size())
        return "a body belongs to no chunk";
    for (const int chunk : world.chunk_of)
        if (!below(chunk, world.chunks.size()))
            return "a body belongs to no chunk";
    int next = 0;
    for (const Chunk& chunk : world.chunks) {
        if (chunk.begin != next || chunk.end < next || chunk.end > world.bodies())
            return "its chunks leave gaps";
        next = chunk.end;
        if (!fits(world, chunk))
            return "a list of neighbours leads nowhere";
    }
    if (!world.stale && next != world.bodies())
        return "its chunks leave gaps";
    return "";
}

} // namespace tumble::sim3d
