#pragma once

#include "base/archive.h"
#include "sim3d/world.h"

/// What of the world a saved state holds: all that the next step reads and that cannot be made from the scene. Lists of
/// neighbours are saved as they stand, for when they are made anew decides in which order forces are added up, and so
/// the last bits. base/archive.h says how such a list is kept complete.
namespace tumble::scene {

template <class Archive, As<WallPose> P> void carry(Archive& archive, P& pose) {
    auto& [rotation, translation, velocity, angular_velocity] = pose;
    archive(rotation, translation, velocity, angular_velocity);
}

template <class Archive, As<Box> B> void carry(Archive& archive, B& box) {
    auto& [lo, hi] = box;
    archive(lo, hi);
}

} // namespace tumble::scene

namespace tumble::sim3d {

// Bodies.

template <class Archive, As<BodyMotion> M> void carry(Archive& archive, M& motion) {
    auto& [position, radius, velocity, mass, spin, kick] = motion;
    archive(position, radius, velocity, mass, spin, kick);
}

template <class Archive, As<BodyLoad> L> void carry(Archive& archive, L& load) {
    auto& [force, torque] = load;
    archive(force, torque);
}

template <class Archive, As<BodyOrientation> O> void carry(Archive& archive, O& orientation) {
    auto& [q] = orientation;
    archive(q);
}

template <class Archive, As<BodyTurn> T> void carry(Archive& archive, T& turn) {
    auto& [momentum, rotation] = turn;
    archive(momentum, rotation);
}

// What contacts remember.

template <class Archive, As<MemoryLanes> M> void carry(Archive& archive, M& memory) {
    auto& [spring, energy] = memory;
    archive(spring, energy);
}

template <class Archive, As<FurtherLanes> F> void carry(Archive& archive, F& further) {
    auto& [rolling, rolling_energy, impact_speed, bonded, bond_energy, unused] = further;
    archive(rolling, rolling_energy, impact_speed, bonded, bond_energy, unused);
}

// Lists.

template <class Archive, As<SpherePair> P> void carry(Archive& archive, P& pair) {
    auto& [a, b, image, kind] = pair;
    archive(a, b, image, kind);
}

template <class Archive, As<BodyPair> P> void carry(Archive& archive, P& pair) {
    auto& [a, b, expires, begin, count, capacity, image] = pair;
    archive(a, b, expires, begin, count, capacity, image);
}

template <class Archive, As<SphereCandidate> C> void carry(Archive& archive, C& candidate) {
    auto& [a, b] = candidate;
    archive(a, b);
}

template <class Archive, As<ClumpCandidates> C> void carry(Archive& archive, C& candidates) {
    auto& [spheres, memory, further, touching] = candidates; // touching is longer: kernels load from its end
    archive(spheres);
    archive(Sparse{memory, spheres.size()}, touching);
    carry_if_any(archive, further, spheres.size());
}

template <class Archive, As<BodyWall> W> void carry(Archive& archive, W& near) {
    auto& [body, wall, expires, primitives_begin, primitives_count, begin, count, capacity] = near;
    archive(body, wall, expires, primitives_begin, primitives_count, begin, count, capacity);
}

template <class Archive, As<WallCandidate> C> void carry(Archive& archive, C& candidate) {
    auto& [sphere, touches, primitives_begin, primitives_count, memory] = candidate;
    archive(sphere, touches, primitives_begin, primitives_count);
    archive(Part{memory, static_cast<std::size_t>(touches)});
}

/// Of the last step's sums: what is not booked in the step that finds it. Spheres know no global damping.
template <class Archive, As<MotionSums> S> void carry_motion(Archive& archive, S& sums) {
    auto& [kinetic_translation, kinetic_rotation, gravity, lost_global_damping, travel_max, way_max, speed_squared_max,
           spin_squared_max, finite] = sums;
    archive(kinetic_translation, kinetic_rotation, gravity, travel_max, way_max, speed_squared_max, spin_squared_max,
            finite);
}

template <class Archive, As<Chunk> C> void carry(Archive& archive, C& chunk) {
    auto& [begin, end, partners_after, partners_before, sphere_pairs, near_spheres, near_until, body_pairs, candidates,
           touches, body_walls, wall_primitives, wall_candidates, wall_further, sphere_primitives, body_contacts,
           wall_contacts, foreign, foreign_count, found, dropped_history, dropped_adhesion, crossed_body, crossed_wall,
           sums, seconds] = chunk;
    archive(begin, end, partners_after, partners_before, sphere_pairs, near_spheres, near_until, body_pairs, candidates,
            body_walls, wall_primitives, wall_candidates, sphere_primitives);
    carry_motion(archive, sums.motion);
    carry_if_any(archive, wall_further, max_wall_touches * wall_candidates.size());
    // Each step's own: touches, body_contacts, wall_contacts, foreign, foreign_count, found,
    // dropped_history, dropped_adhesion. Set only in a step that ends the run: crossed_body and crossed_wall. Wall
    // time: seconds.
}

// The world.

template <class Archive, As<MeanFlow> F> void carry(Archive& archive, F& flow) {
    auto& [centre, velocity, gradient, box, spare] = flow;
    archive(centre, velocity, gradient, box, spare);
}

template <class Archive, As<WallState> W> void carry(Archive& archive, W& state) {
    auto& [wall, surface, pose, half_pose, travel, way, leap, in_place] = state;
    archive(pose, half_pose, travel, way); // leap is each step's own, the rest the scene's
}

/// Spheres know no global damping.
template <class Archive, As<solver::Ledger> L> void carry_ledger(Archive& archive, L& ledger) {
    auto& [lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling, lost_air_drag, lost_adhesion,
           lost_history, lost_global_damping, wall_work, inserted, overlap_ratio_peak] = ledger;
    archive(lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling, lost_air_drag, lost_adhesion,
            lost_history, wall_work, inserted, overlap_ratio_peak);
}

template <class Archive, As<World> W> void carry(Archive& archive, W& world) {
    auto& [scene, dt, step, shapes, plain_shapes, drag, pairs, materials, remembers_more, has_clumps, neck_reach,
           longest_neck, walls, fills, next_fill_step, id, shape, motion, load, orientation, turn, travel, slot_of,
           shape_constants, chunks, chunk_of, images, flow, reach, skin, wall_skin, near_skin, rush, last_rush,
           sphere_skin, smallest_radius, stale, kept, cells, wraps, bounds, rebuilds, ledger, books, kernels, stop,
           crew, seconds] = world;
    archive(step, Standing{walls}, Standing{fills}, next_fill_step, id, shape, motion, load, orientation, turn, travel,
            chunks, chunk_of, flow, rush, stale, rebuilds);
    carry_ledger(archive, ledger);
    archive(books);
    // Of the scene: scene, dt, shapes, plain_shapes, drag, pairs, materials, remembers_more, has_clumps, neck_reach,
    // longest_neck, shape_constants, images, reach and the skins, smallest_radius. Follows from id: slot_of. Each
    // step's own: last_rush. Room for rebuilds: kept, cells, wraps, bounds. Of this process: kernels, stop, crew,
    // seconds.
}

} // namespace tumble::sim3d
