#pragma once

#include "base/pack.h"
#include "sim3d/kernels.h"

/// One instruction set's kernels; what each does stands at sim3d/kernels.h.
namespace tumble::sim3d::TUMBLE_ISA {

using tumble::TUMBLE_ISA::add_quad;
using tumble::TUMBLE_ISA::Columns;
using tumble::TUMBLE_ISA::copy_quad;
using tumble::TUMBLE_ISA::gather;
using tumble::TUMBLE_ISA::Pack;
using tumble::TUMBLE_ISA::RowBlock;
using tumble::TUMBLE_ISA::subtract_quad;

int near_spheres(const BodyMotion* motion, const SpherePair* pairs, int count, const Shift* images, double skin,
                 const std::uint8_t* was, int* found);
int touch_spheres(const BodyMotion* motion, const SpherePair* pairs, const int* which, int count, const Shift* images,
                  const std::uint8_t* was, int* found);
void push_spheres(PushContext& context, const SpherePair* pairs, const int* which, int count, MemoryLanes* memory);
void push_bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory);
void push_walls(PushContext& context, WallContact* contacts, int count);
IntegrateSums integrate(const IntegrateContext& context);
int scan_spheres(const SphereScan& scan, std::uint32_t* found, int room, double* smallest_gap);

const Kernels& kernels();

} // namespace tumble::sim3d::TUMBLE_ISA
