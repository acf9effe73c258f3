#include "sim3d/refresh.h"

#include "sim3d/placement.h"

#include <algorithm>
#include <limits>

namespace tumble::sim3d {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// A range that outgrew its place moves to the end of the pool; the next rebuild starts the pool anew.
void make_room(ClumpCandidates& pool, BodyPair& pair, int count, bool remembers_more) {
    if (count <= pair.capacity)
        return;
    pair.capacity = count + 2;
    pair.begin = pool.size();
    pool.resize(pool.size() + pair.capacity, remembers_more);
}

/// A touching candidate and its memory.
struct Remembered {
    SphereCandidate spheres;
    MemoryLanes memory;
    FurtherLanes further;
};

void take_touching(const ClumpCandidates& pool, const BodyPair& pair, std::vector<Remembered>& taken) {
    taken.clear();
    for (auto k = static_cast<std::size_t>(pair.begin); k < static_cast<std::size_t>(pair.begin + pair.count); ++k)
        if (pool.touching[k] != 0)
            taken.push_back({pool.spheres[k], pool.memory[k], pool.further.empty() ? FurtherLanes{} : pool.further[k]});
}

} // namespace

Vector3d sphere_arm(const World& world, int slot, int exposed) {
    const ShapeConstants& shape = world.shape_at(slot);
    if (shape.single)
        return Vector3d::Zero(); // spares the look at how it is turned
    const double* s = shape.exposed + 4 * static_cast<std::ptrdiff_t>(exposed);
    return Eigen::Map<const RowMajor>(world.turn[static_cast<std::size_t>(slot)].rotation) * Vector3d(s[0], s[1], s[2]);
}

void refresh(const World& world, Chunk& chunk, BodyPair& pair) {
    const double travelled =
        world.travel[static_cast<std::size_t>(pair.a)] + world.travel[static_cast<std::size_t>(pair.b)];
    const auto& image = world.images[static_cast<std::size_t>(pair.image)].along;
    SphereScan scan = scan_between(world, placement_of(world, pair.a), placement_of(world, pair.b),
                                   Vector3d(image[0], image[1], image[2]));
    const double apart =
        (Vector3d(scan.bounding_a) - Vector3d(scan.bounding_b)).norm() - scan.bounding_a[3] - scan.bounding_b[3];
    double smallest_gap = apart;
    const std::uint32_t* found = nullptr;
    const int count = apart < scan.far_skin ? run_scan(world, scan, smallest_gap, found) : 0;
    pair.expires = travelled + (count > 0 ? world.sphere_skin : smallest_gap);

    thread_local std::vector<Remembered> before;
    take_touching(chunk.candidates, pair, before);
    make_room(chunk.candidates, pair, count, world.remembers_more);
    pair.count = count;
    for (int k = 0; k < count; ++k) {
        const SphereCandidate fresh{static_cast<std::int16_t>(found[k] >> 16),
                                    static_cast<std::int16_t>(found[k] & 0xffffU)};
        const auto old = std::find_if(before.begin(), before.end(), [&](const Remembered& remembered) {
            return remembered.spheres.a == fresh.a && remembered.spheres.b == fresh.b;
        });
        const bool known = old != before.end();
        const FurtherLanes further = known ? old->further : FurtherLanes{};
        chunk.candidates.set(pair.begin + k, fresh, known, known ? old->memory : MemoryLanes{},
                             world.remembers_more ? &further : nullptr);
    }
}

namespace {

/// A fast wall gets longer lists of spheres near it, so that they last for about so many steps: finding them anew costs
/// as much as asking them some tens of times.
constexpr double steps_per_refresh = 32;

double sphere_skin(const World& world, const WallState& wall) {
    return std::clamp(steps_per_refresh * wall.way, world.sphere_skin,
                      std::max(world.sphere_skin, 0.5 * world.wall_skin));
}

/// The primitives of the body's list that any of its spheres may soon touch; `smallest` gets what is known of the
/// others' gaps.
void find_wall_primitives(const World& world, const Chunk& chunk, const BodyWall& near, double skin, double& smallest,
                          std::vector<int>& primitives) {
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const Vector3d centre = wall.pose.rotation.transpose() *
                            (bounding_centre(world, placement_of(world, near.body)) - wall.pose.translation);
    const double radius = world.shape_at(near.body).bounding_radius;
    primitives.clear();
    for (int p = near.primitives_begin; p < near.primitives_begin + near.primitives_count; ++p) {
        const int primitive = chunk.wall_primitives[static_cast<std::size_t>(p)];
        const double gap = wall.surface.distance(primitive, centre) - radius;
        if (gap < skin)
            primitives.push_back(primitive);
        else
            smallest = std::min(smallest, gap);
    }
}

/// Spheres of the body that may soon touch the wall, as fresh candidates at the end of the pool, and the smallest gap.
double find_wall_spheres(const World& world, Chunk& chunk, const BodyWall& near, double skin,
                         std::vector<WallCandidate>& fresh) {
    thread_local std::vector<int> primitives;
    double smallest = std::numeric_limits<double>::infinity();
    find_wall_primitives(world, chunk, near, skin, smallest, primitives);
    if (primitives.empty())
        return smallest;
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const ShapeConstants& shape = world.shape_at(near.body);
    const Matrix3d to_wall = wall.pose.rotation.transpose() * placement_of(world, near.body).rotation;
    const Vector3d place =
        wall.pose.rotation.transpose() * (placement_of(world, near.body).position - wall.pose.translation);
    for (int s = 0; s < shape.exposed_count; ++s) {
        const double* sphere = shape.exposed + 4 * static_cast<std::ptrdiff_t>(s);
        const Vector3d centre = place + to_wall * Vector3d(sphere[0], sphere[1], sphere[2]);
        WallCandidate candidate;
        candidate.sphere = static_cast<std::int16_t>(s);
        candidate.primitives_begin = static_cast<int>(chunk.sphere_primitives.size());
        for (const int primitive : primitives) {
            const double gap = wall.surface.distance(primitive, centre) - sphere[3];
            smallest = std::min(smallest, gap);
            if (gap < skin)
                chunk.sphere_primitives.push_back(primitive);
        }
        candidate.primitives_count = static_cast<int>(chunk.sphere_primitives.size()) - candidate.primitives_begin;
        if (candidate.primitives_count > 0)
            fresh.push_back(candidate);
    }
    return smallest;
}

/// Wall candidates and, where World::remembers_more, max_wall_touches of further memories each.
struct WallMemories {
    std::vector<WallCandidate> candidates;
    std::vector<FurtherLanes> further;

    void take(const Chunk& chunk, const BodyWall& near) {
        const auto end = near.begin + near.count;
        candidates.assign(chunk.wall_candidates.begin() + near.begin, chunk.wall_candidates.begin() + end);
        if (!chunk.wall_further.empty())
            further.assign(chunk.wall_further.begin() + max_wall_touches * near.begin,
                           chunk.wall_further.begin() + max_wall_touches * end);
    }
};

/// Puts what was known of the candidate's sphere into it and into `more`, which may be null.
void remember(WallCandidate& fresh, FurtherLanes* more, const WallMemories& old) {
    for (std::size_t k = 0; k < old.candidates.size(); ++k) {
        const WallCandidate& before = old.candidates[k];
        for (int t = 0; before.sphere == fresh.sphere && t < before.touches && fresh.touches < max_wall_touches; ++t) {
            if (more)
                more[fresh.touches] = old.further[max_wall_touches * k + static_cast<std::size_t>(t)];
            fresh.memory[static_cast<std::size_t>(fresh.touches++)] = before.memory[static_cast<std::size_t>(t)];
        }
    }
}

} // namespace

void refresh(const World& world, Chunk& chunk, BodyWall& near) {
    thread_local WallMemories old;
    old.take(chunk, near);
    std::vector<WallCandidate> fresh;
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const double skin = sphere_skin(world, wall);
    const double smallest = find_wall_spheres(world, chunk, near, skin, fresh);
    near.expires = world.travel[static_cast<std::size_t>(near.body)] + wall.travel + (fresh.empty() ? smallest : skin);
    if (static_cast<int>(fresh.size()) > near.capacity) {
        near.capacity = static_cast<int>(fresh.size()) + 2;
        near.begin = static_cast<int>(chunk.wall_candidates.size());
        chunk.wall_candidates.resize(chunk.wall_candidates.size() + static_cast<std::size_t>(near.capacity));
        if (world.remembers_more)
            chunk.wall_further.resize(max_wall_touches * chunk.wall_candidates.size());
    }
    near.count = static_cast<int>(fresh.size());
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const std::size_t at = static_cast<std::size_t>(near.begin) + k;
        remember(fresh[k], world.remembers_more ? &chunk.wall_further[max_wall_touches * at] : nullptr, old);
        chunk.wall_candidates[at] = fresh[k];
    }
}

} // namespace tumble::sim3d
