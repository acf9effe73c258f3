#include "sim2d/kernels/pusher.h"

namespace tumble::sim2d::TUMBLE_ISA {

void push_discs(PushContext& context, const NearPair* pairs, const int* which, int count, Memory* memory) {
    if (context.further)
        return push_discs_fully(context, pairs, which, count, memory);
    with_law(context,
             [&]<class Law>(const Law& law) { push_pairs(Plain<Law>{law}, context, pairs, which, count, memory); });
}

void push_walls(PushContext& context, WallContact* contacts, int count) {
    if (context.further)
        return push_walls_fully(context, contacts, count);
    with_law(context,
             [&]<class Law>(const Law& law) { push_wall_contacts(Plain<Law>{law}, context, contacts, count); });
}

} // namespace tumble::sim2d::TUMBLE_ISA
