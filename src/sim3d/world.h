#pragma once

#include "base/lines.h"
#include "base/parallel_for.h"
#include "base/stop.h"
#include "contact/air_drag.h"
#include "contact/material.h"
#include "scene/scene.h"
#include "sim3d/cells.h"
#include "sim3d/kept_memory.h"
#include "sim3d/kernels.h"
#include "sim3d/solver.h"
#include "sim3d/wall_surface.h"
#include "solver/books.h"
#include "solver/chunks.h"
#include "solver/fill_state.h"
#include "solver/near_list.h"
#include "solver/verbs.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// The solver's state. Bodies stand in slots, sorted by cell so that neighbours in space are neighbours in memory; a
/// body's id never changes, its slot may. Slots are cut into chunks of fixed ranges that do not depend on the number of
/// threads; whatever a chunk does, it does in one fixed order, and each takes the forces that others have for its
/// bodies in a fixed order. That is why one thread and two give the same bits.
namespace tumble::sim3d {

using solver::ChunkSet;
using solver::FillState;
using solver::for_chunks;
using solver::Phase;
using solver::timed;

/// Per template, what the solver needs beside BodyShape.
struct ShapeData {
    BodyShape shape;
    int material = 0;
    Lines<double> exposed; // x y z r of the spheres that can touch anything, principal frame
};

/// The smooth velocity field that neighbours share. Lists wear by what bodies do beside it, so a bed that shakes as one
/// or shears evenly keeps its lists for long.
struct MeanFlow {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();   // m
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(); // m/s, at the centre
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero(); // 1/s
    scene::Box box;                                     // m, where bodies are until the next fit
    double spare = 0;                                   // m, how far they may go until they could leave it

    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& point) const {
        return velocity + gradient * (point - centre);
    }
};
constexpr std::int64_t steps_per_fit = 64;

/// A body near a wall, with the wall's primitives in reach.
struct BodyWall {
    int body = 0;
    int wall = 0;
    double expires = 0;       // m, on the body's odometer plus the wall's
    int primitives_begin = 0; // into Chunk::wall_primitives
    int primitives_count = 0;
    int begin = 0; // into Chunk::wall_candidates
    int count = 0;
    int capacity = 0;
};

/// A sphere near a wall and its touches.
struct WallCandidate {
    std::int16_t sphere = 0;
    std::int16_t touches = 0;
    int primitives_begin = 0; // into Chunk::sphere_primitives
    int primitives_count = 0;
    std::array<WallMemory, max_wall_touches> memory{}; // the first `touches`
};

using NearSpheres = solver::NearList<MemoryLanes, FurtherLanes>;

/// Sphere pairs of clumps that may soon touch; each BodyPair has a range of them.
struct ClumpCandidates {
    std::vector<SphereCandidate> spheres;
    std::vector<MemoryLanes> memory;
    std::vector<FurtherLanes> further; // parallel to them where World::remembers_more, else empty
    std::vector<std::uint8_t> touching = std::vector<std::uint8_t>(8); // 1 or 0; the kernels load eight from anywhere

    [[nodiscard]] int size() const { return static_cast<int>(spheres.size()); }
    void resize(int size, bool remembers_more) {
        spheres.resize(static_cast<std::size_t>(size));
        memory.resize(static_cast<std::size_t>(size));
        if (remembers_more)
            further.resize(static_cast<std::size_t>(size));
        touching.resize(static_cast<std::size_t>(size) + 8);
    }
    /// `more` is null unless World::remembers_more.
    void set(int at, const SphereCandidate& candidate, bool touches, const MemoryLanes& remembered,
             const FurtherLanes* more) {
        if (more)
            further[static_cast<std::size_t>(at)] = *more;
        spheres[static_cast<std::size_t>(at)] = candidate;
        memory[static_cast<std::size_t>(at)] = remembered;
        touching[static_cast<std::size_t>(at)] = touches ? 1 : 0;
    }
};

/// A contiguous range of slots and everything that its bodies own.
struct Chunk {
    int begin = 0;
    int end = 0;
    ChunkSet partners_after = 0;  // chunks whose bodies stand as b in this chunk's pairs
    ChunkSet partners_before = 0; // chunks that have this chunk's bodies as b in theirs

    std::vector<SpherePair> sphere_pairs;  // both bodies single spheres
    std::vector<NearSpheres> near_spheres; // per material pair
    double near_until = 0;                 // m, on World::rush

    std::vector<BodyPair> body_pairs;
    ClumpCandidates candidates;
    std::vector<ClumpTouch> touches; // room for the kernels

    std::vector<BodyWall> body_walls;
    std::vector<int> wall_primitives;
    std::vector<WallCandidate> wall_candidates;
    std::vector<FurtherLanes> wall_further; // max_wall_touches each where World::remembers_more, else empty
    std::vector<int> sphere_primitives;

    std::vector<std::vector<BodyContact>> body_contacts; // per material pair
    std::vector<std::vector<WallContact>> wall_contacts; // per material pair

    std::vector<ForeignPush> foreign; // forces for bodies of other chunks, which look for theirs; room for the kernels
    int foreign_count = 0;
    std::vector<int> found;      // room for the kernels
    double dropped_history = 0;  // J forgotten by contacts that ended in this step
    double dropped_adhesion = 0; // J that went with their necks
    int crossed_body = -1;       // slot of a body whose sphere's centre has passed through a wall, ...
    int crossed_wall = -1;       // ... and the wall
    solver::Sums sums;
    solver::PhaseSeconds seconds{};
};

struct WallState {
    scene::Wall wall;
    WallSurface surface;
    scene::WallPose pose;      // at the step's time
    scene::WallPose half_pose; // half a step earlier, where leapfrog's velocities live
    double travel = 0;         // m, odometer: way beside the mean flow since the last rebuild
    double way = 0;            // m, the same in the last step
    double leap = 0;           // m, how far it went in the last step where bodies are
    bool in_place = false;     // only the surface's velocity changes: turns_in_place
};

/// Pose at a time (s); of a wall that turns in place the unmoved one with its velocities.
scene::WallPose pose_of(const WallState& wall, double time);

struct World {
    scene::Scene scene;
    double dt = 0;
    std::int64_t step = 0;
    std::vector<ShapeData> shapes;
    std::vector<BodyShape> plain_shapes;
    std::vector<contact::AirDrag> drag;        // per shape; empty without air
    std::vector<contact::PairConstants> pairs; // materials squared
    int materials = 0;
    bool remembers_more = false;    // some pair's law is not plain
    bool has_clumps = false;        // some template is not a single sphere
    std::vector<double> neck_reach; // m, per pair: the widest gap over which two that touched may still pull
    double longest_neck = 0;        // m, the largest of them
    std::vector<WallState> walls;
    std::vector<FillState> fills;
    std::int64_t next_fill_step = 0;

    // Per slot.
    std::vector<std::int64_t> id;
    std::vector<int> shape;
    Lines<BodyMotion> motion;
    Lines<BodyLoad> load;
    Lines<BodyOrientation> orientation;
    Lines<BodyTurn> turn;
    // m, odometer: a bound on how far any sphere's centre has gone beside the mean flow, the body's half share of the
    // flow's strain included. Two spheres come closer by no more than both odometers advance. Lists are made for
    // bodies that start with minus their leash and hold until the first odometer shows 0.
    std::vector<double> travel;

    // Per id.
    std::vector<int> slot_of;

    // Per shape, for the kernels.
    std::vector<ShapeConstants> shape_constants;

    std::vector<Chunk> chunks;
    std::vector<int> chunk_of; // per slot
    Lines<Shift> images;       // 27 of them
    MeanFlow flow;
    double reach = 0;           // m, farthest two centres of mass whose bodies touch, with skin
    double skin = 0;            // m, of the body list: two leashes of mean length
    double wall_skin = 0;       // m, of the list of bodies near walls
    double near_skin = 0;       // m, of the list of near sphere pairs
    double rush = 0;            // m, how far the fastest two bodies could have closed in since the start
    double last_rush = 0;       // m, in the last step
    double sphere_skin = 0;     // m, of the sphere candidates of a body pair
    double smallest_radius = 0; // m, of all exposed spheres
    bool stale = true;          // the body list must be rebuilt
    KeptMemory kept;            // room for rebuilds, as are the next two
    Cells cells;
    std::vector<std::array<int, 3>> wraps; // per slot, periods moved back at the rebuild
    Lines<Bounds> bounds;                  // per slot
    std::int64_t rebuilds = 0;

    solver::Ledger ledger;
    Books books;
    const Kernels* kernels = nullptr;
    StopFlag stop = nullptr;
    Crew crew;
    solver::PhaseSeconds seconds{};

    explicit World(int threads) : crew(threads) {}
    [[nodiscard]] int bodies() const { return static_cast<int>(id.size()); }
    [[nodiscard]] const ShapeConstants& shape_at(int slot) const {
        return shape_constants[static_cast<std::size_t>(shape[static_cast<std::size_t>(slot)])];
    }
    /// Index into `pairs` of a body's material against another material.
    [[nodiscard]] int kind_of(int slot, int other_material) const {
        return shape_at(slot).material * materials + other_material;
    }
    [[nodiscard]] double time() const { return static_cast<double>(step) * dt; }
};

} // namespace tumble::sim3d
