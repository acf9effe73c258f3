#pragma once

#include "hard2d/world.h"

namespace tumble::hard2d {

/// One time step: walls are sent on their way, Box2D takes them and the bodies there, the books look at what became.
void step(World& world);

/// Gives walls the velocities that bring them to their poses at the step's end.
void move_walls(World& world);
/// Box2D's step: velocities gain gravity, impulses keep contacts from closing and from sliding freely, bodies move, and
/// what overlaps by more than the slop is taken apart a little.
void solve(World& world);
/// Lets time pass and looks at energies and overlaps.
void book_energy(World& world);
/// What is there now.
Books account_of(const World& world);

/// Places what fills have due at the world's step.
std::optional<Problem> insert_due_fills(World& world, const Tally& tally = {});

/// What is not sane about the state after a step, if anything: a number that is not finite, a body faster than Box2D
/// moves any, one that left the domain, discs that overlap by more than a radius.
std::optional<Problem> insanity(const World& world);

} // namespace tumble::hard2d
