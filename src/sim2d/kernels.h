#pragma once

#include "contact/material.h"
#include "solver/kernels.h"

#include <cstdint>
#include <string_view>

/// The loops that take the time. kernels/*.cpp are built once per instruction set; everything they see is a plain
/// pointer or number, so that no template of the standard library is built for a set the machine may lack.
namespace tumble::sim2d {

using solver::ContactSums;
using solver::MotionSums;
using solver::NearPair;
using solver::Shift;
using solver::TouchCounts;

/// What moves: a body, or one disc of a clump. A body of a single disc is both. Velocities are those of half a step
/// ago.
struct alignas(64) Row {
    double x, y;   // m, centre of mass, or of the disc
    double radius; // m; 0 for a clump, which only its discs' rows touch
    double mass;   // kg, of the body
    double vx, vy; // m/s
    double spin;   // rad/s
    double kick;   // share of a step's kick that is due: 1, and 1/2 in a body's first step, which starts leapfrog
};

struct alignas(32) Load {
    double fx, fy; // N
    double torque; // N m about the row's centre
    double unused;
};

struct alignas(16) Memory {
    double kept;   // contact::DiscMemory: how the shear spring stands, in its law's unit
    double energy; // J
};

/// What contacts remember beside it where a law needs more: contact::Further. The same seen from both sides.
struct FurtherMemory {
    double rolling; // rad
    double rolling_energy;
    double impact_speed; // m/s
};

struct DiscPair {
    int a;
    int b;
    std::int16_t image; // index into the periodic shifts
    std::int16_t kind;  // material pair
};

struct alignas(32) WallContact {
    double normal[2];   // from wall to disc
    double overlap;     // m
    double spin;        // rad/s, of the wall, half a step ago
    double velocity[2]; // m/s, of the wall at the contact, half a step ago
    double now[2];      // m/s, at the step
    Memory memory;
    int row;
    int near;  // index of its WallNear
    int touch; // which of its touches
};

constexpr int max_wall_touches = 3;

/// A force for a row that another chunk owns.
struct ForeignPush {
    int row;
    double fx, fy, torque;
};

/// Rows that a chunk owns: bodies, and discs of its clumps.
struct Owned {
    int body_begin, body_end;
    int disc_begin, disc_end;
};

// Always inlined, so that no instruction set's copy of it is linked for another.
[[gnu::always_inline]] inline bool owns(const Owned& owned, int row) {
    return (row >= owned.body_begin && row < owned.body_end) || (row >= owned.disc_begin && row < owned.disc_end);
}

struct PushContext {
    const Row* rows;
    Load* loads;
    Owned owned;
    const Shift* images;
    bool periodic;
    double dt;
    double gravity[2]; // m/s2
    contact::PairConstants pair;
    int normal_law;     // scene::NormalLaw
    int tangential_law; // scene::TangentialLaw
    bool limit_force;
    ForeignPush* foreign; // room for one per contact
    int foreign_count;
    FurtherMemory* further; // parallel to the memory of what is pushed; null where the pair's law is plain
    ContactSums* sums;
};

struct ShapeConstants {
    double mass;            // kg
    double inertia;         // kg m2
    double reach;           // m, farthest point from the centre of mass
    double smallest_radius; // m, of its exposed discs
    int material;
    bool single;
    const double* exposed; // x y r of the discs that can touch anything
    int exposed_count;
};

struct IntegrateContext {
    Row* rows;
    const Load* loads;
    double* angle;  // rad, per body
    double* travel; // m, per row
    const int* shape;
    const int* first_disc; // per body, row of a clump's first disc
    const ShapeConstants* shapes;
    int begin;
    int end;
    double dt;
    double gravity[2];
    double damping;          // 1/s, mass-proportional
    double flow_velocity[2]; // m/s, of the mean flow at the origin
    double flow_gradient[4]; // 1/s, row-major
    double strain_way;       // m, a row's half share of the flow's strain in one step
};

struct Kernels {
    /// Writes the index of each of `count` pairs whose gap is below `skin` to `found`, which has room for count + 1;
    /// returns how many.
    int (*near_discs)(const Row* rows, const DiscPair* pairs, int count, const Shift* images, double skin, int* found);
    /// Brings touching[] of `count` pairs up to date. Writes the indices of those that touch to `contacts` and of those
    /// that ceased to touch to `ended`, each with room for count + 1.
    TouchCounts (*touch_discs)(const Row* rows, const NearPair* pairs, int count, const Shift* images,
                               std::uint8_t* touching, int* contacts, int* ended);
    /// `which` lists the `count` pairs that touch; memory is parallel to pairs.
    void (*push_discs)(PushContext&, const NearPair* pairs, const int* which, int count, Memory* memory);
    /// Each WallNear has max_wall_touches of PushContext::further.
    void (*push_walls)(PushContext&, WallContact* contacts, int count);
    MotionSums (*integrate)(const IntegrateContext&);
};

/// The best set this processor has.
const Kernels& choose_kernels();
/// By name ("baseline", "x86-64-v3", "x86-64-v4"), or null when this build or this processor lacks it.
const Kernels* kernels_named(std::string_view name);

/// Discs of a clump in the world: their places and velocities from the body's row and its angle (rad).
void place_discs(const ShapeConstants& shape, const Row& body, double angle, Row* discs);

} // namespace tumble::sim2d
