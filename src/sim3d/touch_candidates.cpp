#include "contact/jkr.h"
#include "sim3d/refresh.h"
#include "sim3d/step.h"
#include "solver/arrays.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tumble::sim3d {

namespace {

using Eigen::Vector3d;

void forget(Chunk& chunk, MemoryLanes& memory) {
    chunk.dropped_history += memory.energy;
    memory = {};
}

void forget(Chunk& chunk, FurtherLanes& further) {
    chunk.dropped_history += further.rolling_energy;
    chunk.dropped_adhesion += further.bond_energy;
    further = {};
}

void touch_spheres(const World& world, Chunk& chunk, NearSpheres& near, double neck) {
    near.contact_count = 0;
    if (near.pairs.empty())
        return;
    solver::make_room(near.contacts, near.pairs.size() + 8);
    solver::make_room(near.touching, near.pairs.size() + 8);
    solver::make_room(chunk.found, near.pairs.size());
    const TouchCounts counts = world.kernels->touch_spheres(
        world.motion.data(), near.pairs.data(), static_cast<int>(near.pairs.size()), world.images.data(), neck,
        near.touching.data(), near.contacts.data(), chunk.found.data());
    near.contact_count = counts.contacts;
    for (int k = 0; k < counts.ended; ++k) {
        const auto ended = static_cast<std::size_t>(chunk.found[static_cast<std::size_t>(k)]);
        forget(chunk, near.memory[ended]);
        if (world.remembers_more)
            forget(chunk, near.further[ended]);
    }
}

BodyContact body_contact(const World& world, const BodyPair& pair, const SphereCandidate& spheres, int candidate) {
    const auto& image = world.images[static_cast<std::size_t>(pair.image)].along;
    const BodyMotion& a = world.motion[static_cast<std::size_t>(pair.a)];
    const BodyMotion& b = world.motion[static_cast<std::size_t>(pair.b)];
    const Vector3d arm_a = sphere_arm(world, pair.a, spheres.a);
    const Vector3d arm_b = sphere_arm(world, pair.b, spheres.b);
    const Vector3d between(a.position[0] - b.position[0] - image[0], a.position[1] - b.position[1] - image[1],
                           a.position[2] - b.position[2] - image[2]);
    const Vector3d d = between + arm_a - arm_b;
    return {{d.x(), d.y(), d.z()},
            1,
            {arm_a.x(), arm_a.y(), arm_a.z()},
            world.shape_at(pair.a).exposed[4 * spheres.a + 3],
            {arm_b.x(), arm_b.y(), arm_b.z()},
            world.shape_at(pair.b).exposed[4 * spheres.b + 3],
            pair.a,
            pair.b,
            candidate};
}

/// Whether a listed contact of that kind is one, and not a gap that no neck holds over.
bool holds(const World& world, const Chunk& chunk, std::size_t kind, const BodyContact& contact) {
    if (world.neck_reach[kind] == 0)
        return true;
    const double radii = contact.radius_a + contact.radius_b;
    const double reach = contact::Jkr::reach(contact.radius_a * contact.radius_b / radii, world.pairs[kind]);
    return contact::Jkr::holds(radii - Vector3d(contact.d).norm(), reach,
                               chunk.candidates.further[static_cast<std::size_t>(contact.memory)].bonded) > 0;
}

bool holds(const World& world, const Chunk& chunk, std::size_t kind, const WallContact& contact) {
    if (world.neck_reach[kind] == 0)
        return true;
    const auto further = static_cast<std::size_t>(max_wall_touches * contact.candidate + contact.touch);
    return contact::Jkr::holds(contact.overlap, contact::Jkr::reach(contact.radius, world.pairs[kind]),
                               chunk.wall_further[further].bonded) > 0;
}

/// What each of n contacts between the same two keeps of its damping: n^(-x/2).
double kept_of_damping(std::ptrdiff_t n, double sharing) {
    const auto count = static_cast<double>(n);
    return sharing == 1 ? 1 / std::sqrt(count) : std::pow(count, -0.5 * sharing);
}

/// The last `listed` contacts of a kind, all between the same two, share their damping.
template <class Contact>
void share_damping(const World& world, const Chunk& chunk, std::size_t kind, std::vector<Contact>& contacts,
                   int listed) {
    const auto first = contacts.end() - listed;
    const auto count = listed > 1 ? std::count_if(first, contacts.end(),
                                                  [&](const Contact& each) { return holds(world, chunk, kind, each); })
                                  : 1;
    if (count > 1)
        for (auto contact = first; contact != contacts.end(); ++contact)
            contact->damping_share = kept_of_damping(count, world.scene.contact.sharing());
}

TouchCounts find_clump_touches(const World& world, Chunk& chunk) {
    ClumpCandidates& candidates = chunk.candidates;
    chunk.touches.resize(candidates.spheres.size());
    solver::make_room(chunk.found, candidates.spheres.size());
    return world.kernels->touch_clumps(
        {world.motion.data(), world.turn.data(), world.shape.data(), world.shape_constants.data(), world.images.data()},
        chunk.body_pairs.data(), static_cast<int>(chunk.body_pairs.size()), candidates.spheres.data(),
        {world.longest_neck > 0 ? world.neck_reach.data() : nullptr, world.materials}, candidates.touching.data(),
        chunk.touches.data(), chunk.found.data());
}

void touch_clumps(const World& world, Chunk& chunk) {
    for (auto& list : chunk.body_contacts)
        list.clear();
    if (chunk.body_pairs.empty())
        return;
    const TouchCounts counts = find_clump_touches(world, chunk);
    for (int k = 0; k < counts.ended; ++k) {
        const auto ended = static_cast<std::size_t>(chunk.found[static_cast<std::size_t>(k)]);
        forget(chunk, chunk.candidates.memory[ended]);
        if (world.remembers_more)
            forget(chunk, chunk.candidates.further[ended]);
    }
    for (int first = 0, next = 0; first < counts.contacts; first = next) {
        const int listed = chunk.touches[static_cast<std::size_t>(first)].pair;
        const BodyPair& pair = chunk.body_pairs[static_cast<std::size_t>(listed)];
        const auto kind = static_cast<std::size_t>(world.kind_of(pair.a, world.shape_at(pair.b).material));
        auto& contacts = chunk.body_contacts[kind];
        for (; next < counts.contacts && chunk.touches[static_cast<std::size_t>(next)].pair == listed; ++next) {
            const int candidate = chunk.touches[static_cast<std::size_t>(next)].candidate;
            contacts.push_back(
                body_contact(world, pair, chunk.candidates.spheres[static_cast<std::size_t>(candidate)], candidate));
        }
        if (world.scene.contact.sharing() > 0)
            share_damping(world, chunk, kind, contacts, next - first);
    }
}

/// Whether the sphere's centre has passed through the surface since the last step: what it touches is the same, but
/// pushes the other way.
bool crosses(const WallCandidate& candidate, std::span<const WallTouch> touches) {
    for (int old = 0; old < candidate.touches; ++old)
        for (const WallTouch& touch : touches) {
            const WallMemory& before = candidate.memory[static_cast<std::size_t>(old)];
            if (touch.feature == before.feature && touch.normal.dot(before.normal) < 0)
                return true;
        }
    return false;
}

void put(double* to, const Vector3d& from) {
    Eigen::Map<Vector3d>{to} = from;
}

void set_geometry(WallContact& contact, const WallState& wall, const BodyMotion& body, const Vector3d& arm,
                  double radius, const WallTouch& touch, double neck) {
    contact.damping_share = 1;
    contact.overlap = -touch.gap - neck;
    contact.radius = radius;
    const Vector3d normal = wall.pose.rotation * touch.normal;
    const Vector3d point = Vector3d(body.position) + arm - normal * (radius - 0.5 * contact.overlap);
    put(contact.normal, normal);
    put(contact.arm, arm);
    put(contact.wall_velocity, wall.half_pose.velocity_at(point));
    put(contact.wall_now, wall.pose.velocity_at(point));
    put(contact.wall_spin, wall.half_pose.angular_velocity);
}

/// Appends the body's touches with the wall to `contacts`; returns how many. `touches` is room for them.
int touch_wall(const World& world, Chunk& chunk, const BodyWall& near, std::vector<WallContact>& contacts,
               std::span<WallTouch> touches) {
    const WallState& wall = world.walls[static_cast<std::size_t>(near.wall)];
    const BodyMotion& body = world.motion[static_cast<std::size_t>(near.body)];
    const ShapeConstants& shape = world.shape_at(near.body);
    const double neck = world.neck_reach[static_cast<std::size_t>(world.kind_of(near.body, wall.wall.material))];
    int touching = 0;
    for (int k = near.begin; k < near.begin + near.count; ++k) {
        WallCandidate& candidate = chunk.wall_candidates[static_cast<std::size_t>(k)];
        const Vector3d arm = sphere_arm(world, near.body, candidate.sphere);
        const double radius = shape.exposed[4 * candidate.sphere + 3];
        const Vector3d local = wall.pose.rotation.transpose() * (Vector3d(body.position) + arm - wall.pose.translation);
        const int count = wall.surface.touches(local, radius + neck,
                                               {chunk.sphere_primitives.data() + candidate.primitives_begin,
                                                static_cast<std::size_t>(candidate.primitives_count)},
                                               touches);
        const std::span<const WallTouch> now(touches.data(), static_cast<std::size_t>(count));
        if (crosses(candidate, now)) {
            chunk.crossed_body = near.body;
            chunk.crossed_wall = near.wall;
        }
        if (count > 0 || candidate.touches > 0)
            solver::match_features(
                candidate.memory, candidate.touches,
                world.remembers_more ? &chunk.wall_further[static_cast<std::size_t>(max_wall_touches * k)] : nullptr,
                now, [&](auto& lost) { forget(chunk, lost); });
        for (int t = 0; t < count; ++t) {
            WallContact& contact = contacts.emplace_back();
            set_geometry(contact, wall, body, arm, radius, touches[static_cast<std::size_t>(t)], neck);
            const WallTouch& touch = touches[static_cast<std::size_t>(t)];
            put(contact.foot, local - touch.normal * (radius + touch.gap));
            contact.triangle = touch.triangle;
            contact.body = near.body;
            contact.candidate = k;
            contact.touch = t;
            contact.memory = candidate.memory[static_cast<std::size_t>(t)].memory;
        }
        touching += count;
    }
    return touching;
}

void touch_walls(const World& world, Chunk& chunk) {
    for (auto& list : chunk.wall_contacts)
        list.clear();
    std::array<WallTouch, max_wall_touches> touches;
    for (const BodyWall& near : chunk.body_walls) {
        if (near.count == 0)
            continue;
        const auto kind = static_cast<std::size_t>(
            world.kind_of(near.body, world.walls[static_cast<std::size_t>(near.wall)].wall.material));
        auto& contacts = chunk.wall_contacts[kind];
        const int touching = touch_wall(world, chunk, near, contacts, touches);
        if (world.scene.contact.sharing() > 0)
            share_damping(world, chunk, kind, contacts, touching);
    }
}

} // namespace

void touch_candidates(World& world, Chunk& chunk) {
    chunk.dropped_history = 0;
    chunk.dropped_adhesion = 0;
    for (std::size_t kind = 0; kind < chunk.near_spheres.size(); ++kind)
        touch_spheres(world, chunk, chunk.near_spheres[kind], world.neck_reach[kind]);
    touch_clumps(world, chunk);
    touch_walls(world, chunk);
}

} // namespace tumble::sim3d
