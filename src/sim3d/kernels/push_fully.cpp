#include "sim3d/kernels/pusher.h"

/// A file of its own, because the laws with additions take as long to compile as those without.
namespace tumble::sim3d::TUMBLE_ISA {

void push_spheres_fully(PushContext& context, const NearPair* pairs, const int* which, int count, MemoryLanes* memory) {
    with_law<Full>(context, [&](const auto& pusher) { pusher.spheres(context, pairs, which, count, memory); });
}

void push_bodies_fully(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory) {
    with_law<Full>(context, [&](const auto& pusher) { pusher.bodies(context, contacts, count, memory); });
}

void push_walls_fully(PushContext& context, WallContact* contacts, int count) {
    with_law<Full>(context, [&](const auto& pusher) { pusher.walls(context, contacts, count); });
}

} // namespace tumble::sim3d::TUMBLE_ISA
