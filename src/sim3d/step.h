#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// One time step, leapfrog: forces at time t from positions at t and velocities at t - dt/2, then velocities to
/// t + dt/2 and positions to t + dt.
void step(World& world);

/// Walls to their poses at t.
void move_walls(World& world);
/// Keeps the lists of bodies near bodies and of bodies near walls; makes them anew when they are worn.
void list_neighbours(World& world);
/// Keeps the lists of spheres that may soon touch, for pairs that have travelled too far since they were looked at.
void find_candidates(World& world, Chunk& chunk);
/// Starts the load of each of the chunk's bodies: its weight, no torque.
void push_gravity(World& world, Chunk& chunk);
/// The drag of still air on each of the chunk's bodies.
void push_air(World& world, Chunk& chunk);
/// Which candidates overlap now, and where.
void touch_candidates(World& world, Chunk& chunk);
/// The law's force on every touching pair, to the chunk's own bodies at once, to others' by letter.
void push_contacts(World& world, Chunk& chunk);
/// The context of pushes by the law of a pair of materials, before it knows whom they push.
PushContext law_of(const World& world, std::size_t kind);
/// Opens the letters from other chunks, in their order.
void collect_pushes(World& world, Chunk& chunk);
/// Velocities, then positions; orientation likewise.
void integrate(World& world, Chunk& chunk);
/// Adds up every chunk's account of the step and lets time pass.
void book_energy(World& world);
/// The account before any step: bodies, their energies and what they brought; nothing has been asked about contacts.
Books opening_books(const World& world);

} // namespace tumble::sim3d
