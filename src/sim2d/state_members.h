#pragma once

#include "base/archive.h"
#include "sim2d/world.h"

/// What of the world a saved state holds: all that the next step reads and that cannot be made from the scene. Lists of
/// neighbours are saved as they stand, for when they are made anew decides in which order forces are added up, and so
/// the last bits. base/archive.h says how such a list is kept complete.
namespace tumble::discs {

template <class Archive, As<WallFrame> F> void carry(Archive& archive, F& frame) {
    auto& [rotation, translation, velocity, spin] = frame;
    archive(rotation, translation, velocity, spin);
}

} // namespace tumble::discs

namespace tumble::sim2d {

// Bodies and discs.

template <class Archive, As<Row> R> void carry(Archive& archive, R& row) {
    auto& [x, y, radius, mass, vx, vy, spin, kick] = row;
    archive(x, y, radius, mass, vx, vy, spin, kick);
}

template <class Archive, As<Load> L> void carry(Archive& archive, L& load) {
    auto& [fx, fy, torque, unused] = load;
    archive(fx, fy, torque, unused);
}

// What contacts remember.

template <class Archive, As<Memory> M> void carry(Archive& archive, M& memory) {
    auto& [kept, energy] = memory;
    archive(kept, energy);
}

template <class Archive, As<FurtherMemory> F> void carry(Archive& archive, F& further) {
    auto& [rolling, rolling_energy, impact_speed] = further;
    archive(rolling, rolling_energy, impact_speed);
}

template <class Archive, As<KeptPair> P> void carry(Archive& archive, P& kept) {
    auto& [first, second, further, memory] = kept;
    archive(first, second, further, memory);
}

template <class Archive, As<KeptWall> W> void carry(Archive& archive, W& kept) {
    auto& [disc, wall, further, memory] = kept;
    archive(disc, wall, further, memory);
}

// Lists.

template <class Archive, As<DiscPair> P> void carry(Archive& archive, P& pair) {
    auto& [a, b, image, kind] = pair;
    archive(a, b, image, kind);
}

template <class Archive, As<WallNear> W> void carry(Archive& archive, W& near) {
    auto& [row, wall, awake, expires, pieces_begin, pieces_count, touches, memory] = near;
    archive(row, wall, awake, expires, pieces_begin, pieces_count, touches);
    archive(Part{memory, static_cast<std::size_t>(touches)});
}

/// Of the last step's sums: what is not booked in the step that finds it.
template <class Archive, As<MotionSums> S> void carry_motion(Archive& archive, S& sums) {
    auto& [kinetic_translation, kinetic_rotation, gravity, lost_global_damping, travel_max, way_max, speed_squared_max,
           spin_squared_max, finite] = sums;
    archive(kinetic_translation, kinetic_rotation, gravity, lost_global_damping, travel_max, way_max, speed_squared_max,
            spin_squared_max, finite);
}

template <class Archive, As<Owned> O> void carry(Archive& archive, O& owned) {
    auto& [body_begin, body_end, disc_begin, disc_end] = owned;
    archive(body_begin, body_end, disc_begin, disc_end);
}

template <class Archive, As<Chunk> C> void carry(Archive& archive, C& chunk) {
    auto& [owned, partners_after, partners_before, pairs, near_discs, near_until, wall_nears, wall_further, wall_pieces,
           wall_contacts, foreign, foreign_count, found, dropped_history, crossed_row, crossed_wall, sums, seconds] =
        chunk;
    archive(owned, partners_after, partners_before, pairs, near_discs, near_until, wall_nears, wall_pieces);
    carry_motion(archive, sums.motion);
    carry_if_any(archive, wall_further, max_wall_touches * wall_nears.size());
    // Each step's own: wall_contacts, foreign, foreign_count, found, dropped_history. Set only in a step that ends the
    // run: crossed_row and crossed_wall. Wall time: seconds.
}

// The world.

template <class Archive, As<MeanFlow> F> void carry(Archive& archive, F& flow) {
    auto& [centre, velocity, gradient, lo, hi] = flow;
    archive(centre, velocity, gradient, lo, hi);
}

template <class Archive, As<WallState> W> void carry(Archive& archive, W& state) {
    auto& [wall, line, frame, half_frame, travel, leap] = state; // the first two are the scene's, the last each step's
    archive(frame, half_frame, travel);
}

/// Discs know no adhesion.
template <class Archive, As<solver::Ledger> L> void carry_ledger(Archive& archive, L& ledger) {
    auto& [lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling, lost_air_drag, lost_adhesion,
           lost_history, lost_global_damping, wall_work, inserted, overlap_ratio_peak] = ledger;
    archive(lost_normal_damping, lost_tangential_damping, lost_sliding, lost_rolling, lost_air_drag, lost_history,
            lost_global_damping, wall_work, inserted, overlap_ratio_peak);
}

template <class Archive, As<World> W> void carry(Archive& archive, W& world) {
    auto& [scene, dt, step, shapes, plain_shapes, drag, shape_constants, pairs, materials, remembers_more, walls, fills,
           next_fill_step, newcomers, id, shape, angle, first_disc, rows, loads, body_of, chunk_of, travel, first_tag,
           tags, chunks, images, flow, reach, skin, wall_skin, near_skin, rush, last_rush, smallest_radius,
           largest_radius, stale, kept, cells, centres, periods, rebuilds, ledger, books, kernels, stop, crew,
           seconds] = world;
    archive(step, Standing{walls}, Standing{fills}, next_fill_step, id, shape, angle, first_disc, rows, loads, body_of,
            chunk_of, travel, chunks, flow, rush, stale, kept, rebuilds);
    carry_ledger(archive, ledger);
    archive(books);
    // Of the scene: scene, dt, shapes, plain_shapes, drag, shape_constants, pairs, materials, remembers_more, images,
    // reach and the skins, the radii. Follow from id and shape: first_tag and tags. Each step's own: last_rush,
    // newcomers. Room for rebuilds: cells, centres, periods. Of this process: kernels, stop, crew, seconds.
}

} // namespace tumble::sim2d
