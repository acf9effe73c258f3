#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "base/stop.h"
#include "base/tally.h"
#include "discs/bodies.h"
#include "scene/motion.h"
#include "scene/scene.h"
#include "scene/time_step.h"
#include "solver/contact_push.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Discs with hard contacts: the bodies, walls and fills of src/discs, moved by Box2D's impulses in place of springs.
/// The same functions as the soft solver has, for the scenes with solver = "box2d"; docs/hard-contacts.md says what it
/// is good for.
namespace tumble::hard2d {

using discs::BodyShape;
using discs::BodyState;
using solver::ContactPush;

struct World;

struct WorldDeleter {
    void operator()(World* world) const;
};
using WorldPtr = std::unique_ptr<World, WorldDeleter>;

/// Ready to step at t = 0, fills that are due at 0 inserted; takes steps of scene.box2d.time_step on one thread.
/// `tally` hears of each body that found its place. Problems: a fill that cannot fit at once, periodic sides, a wall
/// too fast for its steps.
Result<WorldPtr> build_world(const scene::Scene& scene, StopFlag stop = nullptr, const Tally& tally = {});

/// Takes `steps` steps, inserting fills when they are due. A state that stopped being sane ends it early with a
/// problem. A stop that is wanted ends a search for room as if it had not begun.
std::optional<Problem> advance(World& world, std::int64_t steps);

/// Puts bodies exactly where they are said to be (ids are given anew, in order), whatever they overlap. Problems:
/// those of discs::refusal_of.
std::optional<Problem> insert(World& world, const std::vector<BodyState>& bodies);

double time_of(const World& world); // s
std::int64_t steps_of(const World& world);
/// The account of time_of(world). Losses are known only in sum, as what the balance lacks; contacts store nothing.
Books books_of(const World& world);
const std::vector<BodyShape>& shapes_of(const World& world);
/// Ordered by id.
std::vector<BodyState> bodies_of(const World& world);
/// Poses of scene.walls at the world's time.
std::vector<scene::WallPose> walls_of(const World& world);
/// Who touches whom, and the mean force over the last step: its impulse over its length.
std::vector<ContactPush> contacts_of(const World& world);
/// What a fill still owes after its last attempt, a sentence each.
std::vector<std::string> unfilled(const World& world);
/// Seconds spent per phase since the world was built.
std::vector<PhaseTime> phase_times(const World& world);

/// Box2D's step has no limit of stability.
scene::TimeStepReport time_step_report(const scene::Scene& scene);

} // namespace tumble::hard2d
