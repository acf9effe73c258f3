#pragma once

#include "sim3d/world.h"

namespace tumble::sim3d {

/// One time step, leapfrog: forces at time t from positions at t and velocities at t - dt/2, then velocities to
/// t + dt/2 and positions to t + dt.
void step(World& world);

/// Keeps the lists of what may soon touch: bodies near bodies and walls, then spheres near spheres.
void find_candidates(World& world);
/// Starts every body's load: its weight, no torque.
void push_gravity(World& world);
/// Which candidates overlap now, and where.
void touch_candidates(World& world);
/// The law's force on every touching pair, handed to both bodies.
void push_contacts(World& world);
/// Velocities, then positions; orientation likewise.
void integrate(World& world);
/// Adds up every chunk's account of the step.
void book_energy(World& world);

} // namespace tumble::sim3d
