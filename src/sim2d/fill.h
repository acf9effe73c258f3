#pragma once

#include "sim2d/world.h"

namespace tumble::sim2d {

/// Makes the fills ready to place their first bodies. Problems: a mass below one body's.
Problems prepare_fills(World& world);

/// Places what is due at the world's step: bodies at random, wholly inside their region, touching no body and no wall.
/// A fill meant to happen at once that cannot place all is a problem; one spread over time tries again later, and
/// unfilled() tells what it still owes. Once a stop is wanted fills stay as they are, the one at work as it was before.
std::optional<Problem> insert_due_fills(World& world, const Tally& tally = {});

} // namespace tumble::sim2d
