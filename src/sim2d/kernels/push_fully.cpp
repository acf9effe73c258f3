#include "sim2d/kernels/pusher.h"

/// A file of its own, because the laws with additions take as long to compile as those without.
namespace tumble::sim2d::TUMBLE_ISA {

void push_discs_fully(PushContext& context, const NearPair* pairs, const int* which, int count, Memory* memory) {
    with_law(context, [&]<class Law>(const Law& law) {
        push_pairs(Full<Law>{{law, context.pair}}, context, pairs, which, count, memory);
    });
}

void push_walls_fully(PushContext& context, WallContact* contacts, int count) {
    with_law(context, [&]<class Law>(const Law& law) {
        push_wall_contacts(Full<Law>{{law, context.pair}}, context, contacts, count);
    });
}

} // namespace tumble::sim2d::TUMBLE_ISA
