#pragma once

#include "base/lines.h"
#include "base/parallel_for.h"
#include "base/stop.h"
#include "contact/air_drag.h"
#include "contact/material.h"
#include "discs/body_shape.h"
#include "discs/wall_line.h"
#include "scene/scene.h"
#include "sim2d/cells.h"
#include "sim2d/kept_memory.h"
#include "sim2d/kernels.h"
#include "sim2d/solver.h"
#include "solver/asked_again.h"
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
/// body's id never changes, its slot may. The first rows are the bodies in slot order, then come the discs of the
/// clumps; only rows with a radius touch anything. Slots are cut into chunks of fixed ranges that do not depend on the
/// number of threads; whatever a chunk does, it does in one fixed order, and each takes the forces that others have for
/// its rows in a fixed order. That is why one thread and two give the same bits.
namespace tumble::sim2d {

using discs::ShapeData;
using discs::WallFrame;
using discs::WallLine;
using discs::WallTouch;
using solver::ChunkSet;
using solver::FillState;
using solver::for_chunks;
using solver::Phase;
using solver::timed;

/// The smooth velocity field that neighbours share. Lists wear by what rows do beside it, so a bed that shakes as one
/// or shears evenly keeps its lists for long.
struct MeanFlow {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();   // m
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero(); // m/s, at the centre
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero(); // 1/s
    Eigen::Vector2d lo = Eigen::Vector2d::Zero();       // m, where rows are until the next fit
    Eigen::Vector2d hi = Eigen::Vector2d::Zero();

    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& point) const {
        return velocity + gradient * (point - centre);
    }
};
constexpr std::int64_t steps_per_fit = 64;

/// A disc near a wall, with the wall's pieces in reach and its touches.
struct WallNear {
    int row = 0;
    int wall = 0;
    bool awake = false;   // may touch before `expires`
    double expires = 0;   // m, on the row's odometer plus the wall's
    int pieces_begin = 0; // into Chunk::wall_pieces
    int pieces_count = 0;
    int touches = 0;
    std::array<WallMemory, max_wall_touches> memory{}; // the first `touches`
};

using NearDiscs = solver::NearList<Memory, FurtherMemory>;

/// Contiguous ranges of slots and of discs, and everything that they own.
struct Chunk {
    Owned owned{};
    ChunkSet partners_after = 0;  // chunks whose rows stand as b in this chunk's pairs
    ChunkSet partners_before = 0; // chunks that have this chunk's rows as b in theirs

    std::vector<DiscPair> pairs;
    std::vector<NearDiscs> near_discs; // per material pair
    double near_until = 0;             // m, on World::rush

    std::vector<WallNear> wall_nears;
    std::vector<FurtherMemory> wall_further; // max_wall_touches each where World::remembers_more, else empty
    std::vector<int> wall_pieces;
    std::vector<std::vector<WallContact>> wall_contacts; // per material pair

    std::vector<ForeignPush> foreign; // forces for rows of other chunks, which look for theirs; room for the kernels
    int foreign_count = 0;
    std::vector<int> found;     // room for the kernels
    double dropped_history = 0; // J forgotten by contacts that ended in this step
    int crossed_row = -1;       // row whose centre has passed through a wall, ...
    int crossed_wall = -1;      // ... and the wall
    solver::Sums sums;
    solver::PhaseSeconds seconds{};
};

struct WallState {
    scene::Wall wall;
    WallLine line;
    WallFrame frame;      // at the step's time
    WallFrame half_frame; // half a step earlier, where leapfrog's velocities live
    double travel = 0;    // m, odometer: way beside the mean flow since the last rebuild
    double leap = 0;      // m, how far it went in the last step where bodies are
};

struct World {
    scene::Scene scene;
    double dt = 0;
    std::int64_t step = 0;
    std::vector<ShapeData> shapes;
    std::vector<BodyShape> plain_shapes;
    std::vector<contact::AirDrag> drag; // per shape; empty without air
    std::vector<ShapeConstants> shape_constants;
    std::vector<contact::PairConstants> pairs; // materials squared
    int materials = 0;
    bool remembers_more = false; // some pair's law is not plain
    std::vector<WallState> walls;
    std::vector<FillState> fills;
    std::int64_t next_fill_step = 0;
    solver::Newcomers newcomers;

    // Per slot.
    std::vector<std::int64_t> id;
    std::vector<int> shape;
    Lines<double> angle;         // rad
    std::vector<int> first_disc; // row of the first disc of a clump

    // Per row.
    Lines<Row> rows;
    Lines<Load> loads;
    std::vector<int> body_of; // slot
    std::vector<int> chunk_of;
    // m, odometer: a bound on how far a disc's centre has gone beside the mean flow, the row's half share of the flow's
    // strain included. Two discs come closer by no more than both odometers advance. Lists are made for rows that start
    // with minus their leash and hold until the first odometer shows 0.
    std::vector<double> travel;

    // Per id: the first of the tags of its discs, which are as lasting as the id.
    std::vector<int> first_tag;
    int tags = 0;

    std::vector<Chunk> chunks;
    Lines<Shift> images; // 9 of them
    MeanFlow flow;
    double reach = 0;           // m, farthest two centres of discs that touch, with skin
    double skin = 0;            // m, of the list of pairs: two leashes of mean length
    double wall_skin = 0;       // m, of the list of discs near walls
    double near_skin = 0;       // m, of the list of near pairs
    double rush = 0;            // m, how far the fastest two discs could have closed in since the start
    double last_rush = 0;       // m, in the last step
    double smallest_radius = 0; // m
    double largest_radius = 0;  // m
    bool stale = true;          // the lists must be made anew
    KeptMemory kept;            // from the insertion of bodies, or within a rebuild, to the end of the rebuild
    Cells cells;                // room for rebuilds, as are the next two
    std::vector<Eigen::Vector2d> centres; // per row, m, inside the periodic box
    std::vector<int> periods;             // per row, how many it stands past the box: y times 3 + x, as in an image
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
    [[nodiscard]] Row& row(int at) { return rows[static_cast<std::size_t>(at)]; }
    [[nodiscard]] const Row& row(int at) const { return rows[static_cast<std::size_t>(at)]; }
    [[nodiscard]] int slot_of(int at) const { return body_of[static_cast<std::size_t>(at)]; }
    /// The lasting name of a row that touches.
    [[nodiscard]] int tag_of(int at) const {
        const auto slot = static_cast<std::size_t>(slot_of(at));
        return first_tag[static_cast<std::size_t>(id[slot])] + (at < bodies() ? 0 : at - first_disc[slot]);
    }
    /// Index into `pairs` of a row's material against another material.
    [[nodiscard]] int kind_of(int at, int other_material) const {
        return shape_at(slot_of(at)).material * materials + other_material;
    }
    [[nodiscard]] double time() const { return static_cast<double>(step) * dt; }
};

} // namespace tumble::sim2d
