#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "base/stop.h"
#include "base/tally.h"
#include "scene/motion.h"
#include "scene/scene.h"
#include "solver/contact_push.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The 3D solver as the layers above see it; src/sim3d/step.cpp is what it does.
namespace tumble::sim3d {

using solver::ContactPush;

struct World;

struct WorldDeleter {
    void operator()(World* world) const;
};
using WorldPtr = std::unique_ptr<World, WorldDeleter>;

/// Ready to step at t = 0, fills that are due at 0 inserted. `threads` >= 1 changes the time taken, never a bit of the
/// result; `tally` hears of each body that found its place. Problems: a fill that cannot fit at once, a time step above
/// the stable limit, a wall outside the domain.
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
std::optional<Problem> insert(World& world, const std::vector<struct BodyState>& bodies);

double time_of(const World& world); // s
std::int64_t steps_of(const World& world);
/// The account of the last step taken: its forces, stored energies and kinetic energies are those at the step's start,
/// at Books::time, one dt before time_of(world). Before the first step: the state as it was put in, its contacts unseen
/// (a fill leaves none).
Books books_of(const World& world);

/// A template as the solver uses it: centred on its centre of mass, turned into its principal frame.
struct BodyShape {
    std::string name;
    double mass = 0;                                   // kg
    double volume = 0;                                 // m3, of the union
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero(); // kg m2, principal
    std::vector<scene::Sphere> spheres;                // m, principal frame, all of them, also wholly covered ones
    double bounding_radius = 0;                        // m, about the centre of mass
    Eigen::Vector3d written_centre = Eigen::Vector3d::Zero(); // m, centre of mass in the template's frame
    Eigen::Quaterniond written_from_principal = Eigen::Quaterniond::Identity(); // orientation of a body "as written"
};
const std::vector<BodyShape>& shapes_of(const World& world);

struct BodyState {
    std::int64_t id = 0; // constant over the run, in order of insertion
    int shape = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();              // m, centre of mass
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity(); // principal frame to world
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();              // m/s, at the same instant as the position
    Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();      // rad/s, world frame
};
/// Ordered by id.
std::vector<BodyState> bodies_of(const World& world);
/// Poses of scene.walls at the world's time.
std::vector<scene::WallPose> walls_of(const World& world);

/// A place where a body touched a wall in the last step taken; vectors in the wall's own frame.
struct WallPush {
    std::int64_t body = 0;                              // id
    int triangle = 0;                                   // of a wall that is a mesh, in the mesh's order
    Eigen::Vector3d foot = Eigen::Vector3d::Zero();     // m, on the wall
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // unit, towards the body
    Eigen::Vector3d force = Eigen::Vector3d::Zero();    // N, on the wall
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); // m/s, of the body's centre past it, before
    double patch = 0;                                   // m, radius of the circle in which they touch
};
/// Of scene.walls[wall]; in an order that does not depend on the threads. Empty before the first step.
std::vector<WallPush> wall_pushes_of(const World& world, int wall);
/// Who touched whom in the last step taken, and with what force, one dt before time_of(world); in an order that does
/// not depend on the threads. Empty before the first step. Costs about as much as a step.
std::vector<ContactPush> contacts_of(const World& world);

/// What a fill still owes after its last attempt: "asked for 300 cones, placed 212; ...". Empty when all is in.
std::vector<std::string> unfilled(const World& world);

/// Seconds spent per phase since the world was built, summed over threads, in the order of the step's verbs.
std::vector<PhaseTime> phase_times(const World& world);

} // namespace tumble::sim3d
