#pragma once

#include "sim2d/world.h"

namespace tumble::sim2d {

/// One time step, leapfrog: forces at time t from positions at t and velocities at t - dt/2, then velocities to
/// t + dt/2 and positions to t + dt. The cycle of the thesis' (3.10) to (3.17).
void step(World& world);

/// Walls to their poses at t.
void move_walls(World& world);
/// Keeps the lists of discs near discs and of discs near walls; makes them anew when they are worn.
void list_neighbours(World& world);
/// Keeps the lists of discs that may soon touch.
void find_candidates(World& world, Chunk& chunk);
/// Starts the load of each of the chunk's rows: its body's weight, no torque.
void push_gravity(World& world, Chunk& chunk);
/// The drag of still air on each of the chunk's bodies.
void push_air(World& world, Chunk& chunk);
/// Which candidates overlap now (3.18), and where.
void touch_candidates(World& world, Chunk& chunk);
/// The law's force on every touching pair, to the chunk's own rows at once, to others' by letter.
void push_contacts(World& world, Chunk& chunk);
/// The context of pushes by the law of a pair of materials, before it knows whom they push.
PushContext law_of(const World& world, std::size_t kind);
/// Opens the letters from other chunks, in their order, and hands what clumps' discs got to their bodies.
void collect_pushes(World& world, Chunk& chunk);
/// Velocities, then positions; angles likewise; the discs of clumps go with their bodies.
void integrate(World& world, Chunk& chunk);
/// Adds up every chunk's account of the step and lets time pass.
void book_energy(World& world);
/// The account before any step: bodies, their energies and what they brought; nothing has been asked about contacts.
Books opening_books(const World& world);

} // namespace tumble::sim2d
