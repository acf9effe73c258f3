#pragma once

#include "base/rng.h"
#include "base/stop.h"
#include "sim2d/crowd.h"

#include <cstdint>
#include <string>
#include <vector>

/// How fills bring in their bodies, whichever solver moves them: the same scene begins alike under each.
namespace tumble::sim2d {

struct FillState {
    scene::Fill fill;
    Rng rng{0};
    std::int64_t asked = 0;
    std::int64_t placed = 0;
    std::int64_t next_step = 0;
    bool begun = false; // has been tried
    bool over = false;
};

/// What fills see of a world.
struct Site {
    const scene::Scene& scene;
    const std::vector<ShapeData>& shapes;
    std::vector<StandingWall> walls; // those of the scene, in its order
    std::vector<Placement> bodies;
    std::int64_t step = 0;
    double dt = 0; // s
    StopFlag stop = nullptr;
};

/// The scene's fills before their first bodies. Problems: a mass below one body's.
Result<std::vector<FillState>> begin_fills(const scene::Scene& scene, const std::vector<ShapeData>& shapes, double dt);

/// What the fills that are due at the site's step put in: bodies at random, wholly inside their region, touching no
/// body and no wall. A fill meant to happen at once that cannot place all is a problem; one spread over time tries
/// again later, and unfilled() tells what it still owes. Once a stop is wanted fills stay as they are, the one at work
/// as it was before.
Result<std::vector<BodyState>> place_due(std::vector<FillState>& fills, const Site& site);

/// The first step at which a fill is due; never: the largest number.
std::int64_t next_due(const std::vector<FillState>& fills);

/// A sentence for each fill that still owes bodies.
std::vector<std::string> owed_by(const std::vector<FillState>& fills, const std::vector<ShapeData>& shapes);

} // namespace tumble::sim2d
