#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

namespace {

constexpr int ahead = 24; // which body comes next is known long before the processor could guess it

template <class Pair>
TUMBLE_INLINE int closer_than(double gap, const BodyMotion* motion, const Pair& pair, const Shift* images) {
    const BodyMotion& a = motion[pair.a];
    const BodyMotion& b = motion[pair.b];
    const double* shift = images[pair.image].along;
    const double dx = a.position[0] - b.position[0] - shift[0];
    const double dy = a.position[1] - b.position[1] - shift[1];
    const double dz = a.position[2] - b.position[2] - shift[2];
    const double reach = a.radius + b.radius + gap;
    return dx * dx + dy * dy + dz * dz < reach * reach;
}

} // namespace

// Which pairs are found is hard to predict: both always write, and advance only when it counts.

int near_spheres(const BodyMotion* motion, const SpherePair* pairs, int count, const Shift* images, double skin,
                 int* found) {
    int n = 0;
    for (int p = 0; p < count; ++p) {
        __builtin_prefetch(&motion[pairs[p + ahead < count ? p + ahead : p].b]);
        found[n] = p;
        n += closer_than(skin, motion, pairs[p], images);
    }
    return n;
}

TouchCounts touch_spheres(const BodyMotion* motion, const NearPair* pairs, int count, const Shift* images,
                          std::uint8_t* touching, int* contacts, int* ended) {
    TouchCounts n{0, 0};
    for (int p = 0; p < count; ++p) {
        __builtin_prefetch(&motion[pairs[p + ahead < count ? p + ahead : p].b]);
        const int now = closer_than(0, motion, pairs[p], images);
        const int was = touching[p];
        contacts[n.contacts] = p;
        n.contacts += now;
        ended[n.ended] = p;
        n.ended += was & ~now;
        touching[p] = static_cast<std::uint8_t>(now);
    }
    return n;
}

namespace {

// Spheres of a that come near b's bounding sphere, as four arrays padded to whole packs.
int gather_near(const SphereScan& scan, double* xs, double* ys, double* zs, double* rs, int* index, int stride) {
    int n = 0;
    for (int k = 0; k < scan.count_a; ++k) {
        const double* s = scan.exposed_a + 4 * k;
        const double dx = s[0] - scan.bounding_b[0];
        const double dy = s[1] - scan.bounding_b[1];
        const double dz = s[2] - scan.bounding_b[2];
        const double reach = s[3] + scan.bounding_b[3] + scan.far_skin;
        xs[n] = s[0];
        ys[n] = s[1];
        zs[n] = s[2];
        rs[n] = s[3];
        index[n] = k;
        n += dx * dx + dy * dy + dz * dz < reach * reach;
    }
    for (int k = n; k < (n + Pack::lanes - 1) / Pack::lanes * Pack::lanes && k < stride; ++k) {
        xs[k] = ys[k] = zs[k] = 0;
        rs[k] = -1e30; // no gap is ever this large
    }
    return n;
}

} // namespace

int scan_spheres(const SphereScan& scan, std::uint32_t* found, int room, double* smallest_gap) {
    const int stride = (scan.count_a + Pack::lanes) / Pack::lanes * Pack::lanes;
    double* xs = scan.scratch;
    double* ys = xs + stride;
    double* zs = ys + stride;
    double* rs = zs + stride;
    int* index = reinterpret_cast<int*>(rs + stride);
    const int near = gather_near(scan, xs, ys, zs, rs, index, stride);

    int n = 0;
    double smallest = scan.far_skin;
    const double* r = scan.rotation;
    for (int k = 0; k < scan.count_b && near > 0; ++k) {
        const double* s = scan.exposed_b + 4 * k;
        const double x = r[0] * s[0] + r[1] * s[1] + r[2] * s[2] + scan.offset[0];
        const double y = r[3] * s[0] + r[4] * s[1] + r[5] * s[2] + scan.offset[1];
        const double z = r[6] * s[0] + r[7] * s[1] + r[8] * s[2] + scan.offset[2];
        const double dx = x - scan.bounding_a[0];
        const double dy = y - scan.bounding_a[1];
        const double dz = z - scan.bounding_a[2];
        const double reach = s[3] + scan.bounding_a[3] + scan.far_skin;
        if (dx * dx + dy * dy + dz * dz >= reach * reach)
            continue;
        for (int p = 0; p < near; p += Pack::lanes) {
            const Pack px = Pack::load(xs + p) - Pack(x);
            const Pack py = Pack::load(ys + p) - Pack(y);
            const Pack pz = Pack::load(zs + p) - Pack(z);
            const Pack gap = root(px * px + py * py + pz * pz) - Pack::load(rs + p) - Pack(s[3]);
            double gaps[Pack::lanes] __attribute__((aligned(64)));
            gap.store(gaps);
            const double least = -largest(-gap);
            smallest = least < smallest ? least : smallest;
            if (least >= scan.skin)
                continue;
            for (int lane = 0; lane < Pack::lanes && p + lane < near; ++lane)
                if (gaps[lane] < scan.skin) {
                    if (n < room)
                        found[n] = static_cast<std::uint32_t>(index[p + lane]) << 16 | static_cast<std::uint32_t>(k);
                    ++n;
                }
        }
    }
    *smallest_gap = smallest;
    return n;
}

} // namespace tumble::sim3d::TUMBLE_ISA
