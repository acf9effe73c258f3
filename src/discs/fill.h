#pragma once

#include "base/stop.h"
#include "base/tally.h"
#include "discs/placement.h"
#include "solver/fill_state.h"

#include <cstdint>
#include <string>
#include <vector>

/// How fills bring in their bodies, whichever solver moves them: the same scene begins alike under each.
namespace tumble::discs {

using solver::FillState;

/// What fills see of a world.
struct Site {
    const scene::Scene& scene;
    const std::vector<ShapeData>& shapes;
    std::vector<StandingWall> walls; // those of the scene, in its order
    std::vector<Placement> bodies;
    std::int64_t step = 0;
    double dt = 0; // s
    StopFlag stop = nullptr;
    Tally tally{}; // hears of each body that found its place
};

/// What the fills that are due at the site's step put in: bodies at random, wholly inside their region, touching no
/// body and no wall. A fill meant to happen at once that cannot place all is a problem; one spread over time tries
/// again later, and owed_by() tells what it still owes. Once a stop is wanted fills stay as they are, the one at work
/// as it was before.
Result<std::vector<BodyState>> place_due(std::vector<FillState>& fills, const Site& site);

/// A sentence for each fill that still owes bodies.
std::vector<std::string> owed_by(const std::vector<FillState>& fills, const std::vector<ShapeData>& shapes);

} // namespace tumble::discs
