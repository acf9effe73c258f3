#pragma once

#include "base/pack.h"
#include "sim2d/kernels.h"

/// One instruction set's kernels; what each does stands at sim2d/kernels.h.
namespace tumble::sim2d::TUMBLE_ISA {

using tumble::TUMBLE_ISA::Columns;
using tumble::TUMBLE_ISA::for_rows;
using tumble::TUMBLE_ISA::gather;
using tumble::TUMBLE_ISA::Pack;
using tumble::TUMBLE_ISA::Quad;
using tumble::TUMBLE_ISA::quad_at;

int near_discs(const Row* rows, const DiscPair* pairs, int count, const Shift* images, double skin, int* found);
TouchCounts touch_discs(const Row* rows, const NearPair* pairs, int count, const Shift* images, std::uint8_t* touching,
                        int* contacts, int* ended);
void push_discs(PushContext& context, const NearPair* pairs, const int* which, int count, Memory* memory);
void push_walls(PushContext& context, WallContact* contacts, int count);
/// The same for pairs whose law is not plain.
void push_discs_fully(PushContext& context, const NearPair* pairs, const int* which, int count, Memory* memory);
void push_walls_fully(PushContext& context, WallContact* contacts, int count);
MotionSums integrate(const IntegrateContext& context);

const Kernels& kernels();

} // namespace tumble::sim2d::TUMBLE_ISA
