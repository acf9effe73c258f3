#pragma once

#include "base/lines.h"
#include "contact/material.h"
#include "solver/kernels.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

/// The loops that take the time. kernels/*.cpp are built once per instruction set; everything they see is a plain
/// pointer or number, so that no template of the standard library is built for a set the machine may lack.
namespace tumble::sim3d {

using solver::ContactSums;
using solver::MotionSums;
using solver::NearPair;
using solver::Shift;
using solver::TouchCounts;

/// What a contact reads of a body. Velocities are those of half a step ago.
struct alignas(32) BodyMotion {
    double position[3]; // m, centre of mass
    double radius;      // m, of a single-sphere body; 0 for a clump
    double velocity[3]; // m/s
    double mass;        // kg
    double spin[3];     // rad/s, world frame
    double kick;        // share of a step's kick that is due: 1, and 1/2 in a body's first step, which starts leapfrog
};

struct alignas(32) BodyLoad {
    double force[4];  // N; the fourth is unused
    double torque[4]; // N m about the centre of mass
};

/// Quaternion w x y z, principal frame to world.
struct alignas(32) BodyOrientation {
    double q[4];
};

/// What only clumps need to turn.
struct alignas(32) BodyTurn {
    double momentum[3]; // kg m2/s, angular, world frame
    double rotation[9]; // row-major matrix of the orientation
};

struct ShapeConstants {
    double mass;
    double inertia[3];
    double reach; // m, farthest point from the centre of mass
    int material;
    bool single;
    const double* exposed; // x y z r, 64-byte aligned
    int exposed_count;
    double bounding_centre[3]; // m, principal frame
    double bounding_radius;    // m
};

/// Tangential spring (m) and its stored energy (J).
struct alignas(32) MemoryLanes {
    double spring[3];
    double energy;
};

/// What contacts remember beside it where a law needs more: contact::Further. Two rows of four, as the kernels load
/// them.
struct alignas(32) FurtherLanes {
    double rolling[3]; // rad
    double rolling_energy;
    double impact_speed; // m/s
    double bonded;       // 1 or 0
    double bond_energy;
    double unused;
};

/// Sphere about a body that it does not leave before its list is made anew.
struct alignas(32) Bounds {
    double centre[3]; // m
    double reach;     // m, radius of the bounding sphere and the body's leash
};

struct SpherePair {
    int a;
    int b;
    std::int16_t image;
    std::int16_t kind; // material pair
};

/// Where the spheres of a body pair may soon touch: valid until the two odometers together show `expires`.
struct BodyPair {
    int a = 0;
    int b = 0;
    double expires = 0; // m, on the sum of the two odometers (World::travel)
    int begin = 0;      // into Chunk::candidates
    int count = 0;
    int capacity = 0;
    std::int16_t image = 0; // index into World::images: where b stands relative to its own place
};

/// A sphere of `a` and a sphere of `b` that may soon touch; indices into ShapeConstants::exposed.
struct SphereCandidate {
    std::int16_t a = 0;
    std::int16_t b = 0;
};

/// Indices of a BodyPair and of a SphereCandidate of its own that touches.
struct ClumpTouch {
    int pair;
    int candidate;
};

/// The Shift that shifts nothing: both bodies stand in the box itself.
constexpr int no_image = 13;

/// What clumps need to be placed in the world.
struct Placements {
    const BodyMotion* motion;
    const BodyTurn* turn;
    const int* shape;
    const ShapeConstants* shapes;
    const Shift* images;
};

/// m, over how wide a gap two that touched may stay in contact, per pair of materials; null where none does.
struct Necks {
    const double* reach;
    int materials;
};

/// A touching pair of clump spheres; d is from b's sphere centre to a's. Rows of four, as the kernels load them.
struct alignas(32) BodyContact {
    double d[3]; // m
    double damping_share;
    double arm_a[3]; // m, centre of mass to sphere centre
    double radius_a;
    double arm_b[3];
    double radius_b;
    int a;
    int b;
    int memory;
};

struct alignas(32) WallContact {
    double normal[3]; // world, wall to body
    double overlap;
    double arm[3]; // m, centre of mass to sphere centre
    double radius;
    double wall_velocity[3]; // m/s at the contact, half a step ago
    double damping_share;
    MemoryLanes memory;
    double wall_now[3];  // m/s at the contact, at the step
    double wall_spin[3]; // rad/s, half a step ago
    double foot[3];      // m, on the wall, in its own frame
    int body;
    int candidate;
    int touch;
    int triangle;                // of a mesh: the one touched
    alignas(32) double force[4]; // N, on the body: what push_walls found; the fourth is unused
};

// A sphere on the square hole of a sieve touches four edges, one in a corner where six facets meet six.
constexpr int max_wall_touches = 8;

/// A force for a body that another chunk owns, as a kernel writes it.
struct ForeignPush {
    int body;
    double force[3];
    double torque[3];
};

/// What push kernels work on: the bodies, their loads, and where this chunk's bodies end.
struct PushContext {
    const BodyMotion* motion;
    BodyLoad* load;
    int begin;
    int end;
    const Shift* images;
    double dt;
    double gravity[3]; // m/s2
    contact::PairConstants pair;
    int normal_law;     // scene::NormalLaw
    int tangential_law; // scene::TangentialLaw
    bool limit_force;
    ForeignPush* foreign; // room for one per contact
    int foreign_count;
    FurtherLanes* further; // parallel to the memory of what is pushed; null where the pair's law is plain
    ContactSums* sums;
};

struct IntegrateContext {
    BodyMotion* motion;
    const BodyLoad* load;
    BodyOrientation* orientation;
    BodyTurn* turn;
    double* travel;
    const int* shape;
    const ShapeConstants* shapes;
    int begin;
    int end;
    double dt;
    double gravity[3];
    double flow_velocity[3]; // m/s, of the mean flow at x = 0
    double flow_gradient[9]; // 1/s, row-major
    double strain_way;       // m, a body's half share of the flow's strain in one step
    bool turn_spheres;       // false: bodies of one sphere keep their orientation
};

struct SphereScan {
    const double* exposed_a; // x y z r
    int count_a;
    const double* exposed_b;
    int count_b;
    double rotation[9];   // b's frame to a's frame, row-major
    double offset[3];     // m, b's centre of mass in a's frame
    double bounding_a[4]; // centre and radius, m, a's frame
    double bounding_b[4]; // centre and radius, m, a's frame
    double skin;          // m, pairs with a smaller gap are candidates
    double far_skin;      // m, gaps up to here are measured
    double* scratch;      // 4 * (count_a + 8) doubles, 64-byte aligned
};

struct Kernels {
    /// Writes each slot of begin .. end whose bounds meet a sphere to `found`, which has room for eight more than there
    /// are slots; returns how many.
    int (*near_bodies)(const Bounds* bounds, int begin, int end, const Bounds& sphere, int* found);
    /// Writes the index of each of `count` pairs whose gap is below `skin` to `found`, which has room for count + 8;
    /// returns how many.
    int (*near_spheres)(const BodyMotion* motion, const SpherePair* pairs, int count, const Shift* images, double skin,
                        int* found);
    /// Brings touching[] of `count` pairs up to date: those that overlap touch, and those that touched do until their
    /// gap exceeds `neck`, m. Writes the indices of those that touch to `contacts` and of those that ceased to touch to
    /// `ended`. touching[] and contacts[] have room for count + 8.
    TouchCounts (*touch_spheres)(const BodyMotion* motion, const NearPair* pairs, int count, const Shift* images,
                                 double neck, std::uint8_t* touching, int* contacts, int* ended);
    /// The same for the candidates of `count` pairs of bodies; touching[] has room for eight more.
    TouchCounts (*touch_clumps)(const Placements&, const BodyPair* pairs, int count, const SphereCandidate* candidates,
                                const Necks& necks, std::uint8_t* touching, ClumpTouch* contacts, int* ended);
    /// `which` lists the `count` pairs that touch; memory is parallel to pairs.
    void (*push_spheres)(PushContext&, const NearPair* pairs, const int* which, int count, MemoryLanes* memory);
    void (*push_bodies)(PushContext&, const BodyContact* contacts, int count, MemoryLanes* memory);
    /// Each candidate has max_wall_touches of PushContext::further.
    void (*push_walls)(PushContext&, WallContact* contacts, int count);
    MotionSums (*integrate)(const IntegrateContext&);
    /// Writes candidates as (a << 16 | b), at most `room`; returns how many there are. `smallest_gap` becomes the
    /// smallest gap of all pairs, m, never above far_skin.
    int (*scan_spheres)(const SphereScan&, std::uint32_t* found, int room, double* smallest_gap);
};

/// The best set this processor has.
const Kernels& choose_kernels();
/// By name ("baseline", "x86-64-v3", "x86-64-v4"), or null when this build or this processor lacks it.
const Kernels* kernels_named(std::string_view name);

} // namespace tumble::sim3d
