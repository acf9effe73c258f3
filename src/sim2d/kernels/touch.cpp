#include "sim2d/kernels/isa.h"

namespace tumble::sim2d::TUMBLE_ISA {

namespace {

constexpr int ahead = 24; // which row comes next is known long before the processor could guess it

template <class Pair>
TUMBLE_INLINE int closer_than(double gap, const Row* rows, const Pair& pair, const Shift* images) {
    const Row& a = rows[pair.a];
    const Row& b = rows[pair.b];
    const double* shift = images[pair.image].along;
    const double dx = a.x - b.x - shift[0];
    const double dy = a.y - b.y - shift[1];
    const double reach = a.radius + b.radius + gap;
    return dx * dx + dy * dy < reach * reach;
}

} // namespace

// Which pairs are found is hard to predict: both always write, and advance only when it counts.

int near_discs(const Row* rows, const DiscPair* pairs, int count, const Shift* images, double skin, int* found) {
    int n = 0;
    for (int p = 0; p < count; ++p) {
        __builtin_prefetch(&rows[pairs[p + ahead < count ? p + ahead : p].b]);
        found[n] = p;
        n += closer_than(skin, rows, pairs[p], images);
    }
    return n;
}

TouchCounts touch_discs(const Row* rows, const NearPair* pairs, int count, const Shift* images, std::uint8_t* touching,
                        int* contacts, int* ended) {
    TouchCounts n{0, 0};
    for (int p = 0; p < count; ++p) {
        __builtin_prefetch(&rows[pairs[p + ahead < count ? p + ahead : p].b]);
        const int now = closer_than(0, rows, pairs[p], images);
        const int was = touching[p];
        contacts[n.contacts] = p;
        n.contacts += now;
        ended[n.ended] = p;
        n.ended += was & ~now;
        touching[p] = static_cast<std::uint8_t>(now);
    }
    return n;
}

} // namespace tumble::sim2d::TUMBLE_ISA
