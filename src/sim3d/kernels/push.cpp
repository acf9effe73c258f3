#include "sim3d/kernels/pusher.h"

namespace tumble::sim3d::TUMBLE_ISA {

void push_spheres(PushContext& context, const NearPair* pairs, const int* which, int count, MemoryLanes* memory) {
    if (context.further)
        return push_spheres_fully(context, pairs, which, count, memory);
    with_law<Plain>(context, [&](const auto& pusher) { pusher.spheres(context, pairs, which, count, memory); });
}

void push_bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory) {
    if (context.further)
        return push_bodies_fully(context, contacts, count, memory);
    with_law<Plain>(context, [&](const auto& pusher) { pusher.bodies(context, contacts, count, memory); });
}

void push_walls(PushContext& context, WallContact* contacts, int count) {
    if (context.further)
        return push_walls_fully(context, contacts, count);
    with_law<Plain>(context, [&](const auto& pusher) { pusher.walls(context, contacts, count); });
}

} // namespace tumble::sim3d::TUMBLE_ISA
