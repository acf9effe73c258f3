#pragma once

#include "base/pack.h"
#include "sim3d/kernels.h"

/// One instruction set's kernels; what each does stands at sim3d/kernels.h.
namespace tumble::sim3d::TUMBLE_ISA {

using tumble::TUMBLE_ISA::bits;
using tumble::TUMBLE_ISA::Columns;
using tumble::TUMBLE_ISA::for_rows;
using tumble::TUMBLE_ISA::gather;
using tumble::TUMBLE_ISA::Pack;
using tumble::TUMBLE_ISA::Quad;
using tumble::TUMBLE_ISA::quad_at;

int near_bodies(const Bounds* bounds, int begin, int end, const Bounds& sphere, int* found);
int near_spheres(const BodyMotion* motion, const SpherePair* pairs, int count, const Shift* images, double skin,
                 int* found);
TouchCounts touch_spheres(const BodyMotion* motion, const NearPair* pairs, int count, const Shift* images, double neck,
                          std::uint8_t* touching, int* contacts, int* ended);
TouchCounts touch_clumps(const Placements& at, const BodyPair* pairs, int count, const SphereCandidate* candidates,
                         const Necks& necks, std::uint8_t* touching, ClumpTouch* contacts, int* ended);
void push_spheres(PushContext& context, const NearPair* pairs, const int* which, int count, MemoryLanes* memory);
void push_bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory);
void push_walls(PushContext& context, WallContact* contacts, int count);
/// The same for pairs whose law is not plain.
void push_spheres_fully(PushContext& context, const NearPair* pairs, const int* which, int count, MemoryLanes* memory);
void push_bodies_fully(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory);
void push_walls_fully(PushContext& context, WallContact* contacts, int count);
MotionSums integrate(const IntegrateContext& context);
int scan_spheres(const SphereScan& scan, std::uint32_t* found, int room, double* smallest_gap);

const Kernels& kernels();

} // namespace tumble::sim3d::TUMBLE_ISA
