#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "base/stop.h"
#include "base/tally.h"
#include "discs/bodies.h"
#include "scene/motion.h"
#include "scene/scene.h"
#include "solver/contact_push.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The 2D solver as the layers above see it; src/sim2d/step.cpp is what it does. The twin of src/sim3d.
namespace tumble::sim2d {

using discs::BodyShape;
using discs::BodyState;
using discs::Disc;
using solver::ContactPush;

struct World;

struct WorldDeleter {
    void operator()(World* world) const;
};
using WorldPtr = std::unique_ptr<World, WorldDeleter>;

/// Ready to step at t = 0, fills that are due at 0 inserted. `threads` >= 1 changes the time taken, never a bit of the
/// result; `tally` hears of each body that found its place. Problems: a fill that cannot fit at once, a time step above
/// the stable limit, a period too short.
Result<WorldPtr> build_world(const scene::Scene& scene, int threads, StopFlag stop = nullptr, const Tally& tally = {});

/// Everything that the steps to come depend on and that the scene does not say, as bytes.
std::string state_of(const World& world);

/// The world of a scene as state_of kept it: steps taken from it give the same bits as if it had never been kept,
/// whatever the number of threads before and now. Problems: those of the scene that build_world finds without placing
/// bodies; bytes that are damaged, of another layout, or of a scene with other bodies, walls or fills.
Result<WorldPtr> restore_world(const scene::Scene& scene, int threads, std::string_view state, StopFlag stop = nullptr);

/// Takes `steps` steps, inserting fills when they are due. A state that stopped being sane ends it early with a problem
/// naming body, time and reason; the world then stays at the last step taken. A stop that is wanted ends a search for
/// room, and with it the stretch of steps, as if that search had not begun; between steps it is the caller who asks.
std::optional<Problem> advance(World& world, std::int64_t steps);

/// Puts bodies exactly where they are said to be (ids are given anew, in order), whatever they overlap; their energy is
/// booked as inserted, that of overlaps among them only before the first step. For states measured elsewhere and for
/// tests; fills are the usual way. Problems: a shape index that does not exist, a position outside the domain, a number
/// that is not finite.
std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies);

double time_of(const World& world); // s
std::int64_t steps_of(const World& world);
/// The account of the last step taken: its forces, stored energies and kinetic energies are those at the step's start,
/// at Books::time, one dt before time_of(world). Before the first step: the state as it was put in, its contacts unseen
/// (a fill leaves none).
Books books_of(const World& world);

const std::vector<BodyShape>& shapes_of(const World& world);

/// Ordered by id.
std::vector<BodyState> bodies_of(const World& world);
/// Poses of scene.walls at the world's time.
std::vector<scene::WallPose> walls_of(const World& world);
/// Who touched whom in the last step taken, and with what force, one dt before time_of(world); in an order that does
/// not depend on the threads. Empty before the first step. Costs about as much as a step.
std::vector<ContactPush> contacts_of(const World& world);

/// What a fill still owes after its last attempt: "asked for 300 of body 'disc', placed 212; ...". Empty when all is
/// in.
std::vector<std::string> unfilled(const World& world);

/// Seconds spent per phase since the world was built, summed over threads, in the order of the step's verbs.
std::vector<PhaseTime> phase_times(const World& world);

} // namespace tumble::sim2d
