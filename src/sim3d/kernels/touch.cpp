#include "base/vec3.h"
#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

namespace {

constexpr int lanes = Pack::lanes;

/// A bit for each of eight pairs whose gap is below `gap`; lanes from n on repeat the last pair.
template <class Pair>
TUMBLE_INLINE unsigned closer_than(double gap, const BodyMotion* motion, const Pair* pairs, int n,
                                   const Shift* images) {
    const auto pair = [&](int k) TUMBLE_INLINE_LAMBDA -> const Pair& { return pairs[k < n ? k : n - 1]; };
    const Columns a = gather([&](int k) TUMBLE_INLINE_LAMBDA { return motion[pair(k).a].position; });
    const Columns b = gather([&](int k) TUMBLE_INLINE_LAMBDA { return motion[pair(k).b].position; });
    Vec3<Pack> d{a.x - b.x, a.y - b.y, a.z - b.z};
    bool shifted = false;
    for (int k = 0; k < lanes; ++k)
        shifted |= pair(k).image != no_image;
    if (shifted) {
        const Columns shift = gather([&](int k) TUMBLE_INLINE_LAMBDA { return images[pair(k).image].along; });
        d = d - Vec3<Pack>{shift.x, shift.y, shift.z};
    }
    const Pack reach = a.w + b.w + Pack(gap);
    return bits(dot(d, d) < reach * reach) & ((1U << n) - 1);
}

/// Appends first + lane for every set bit; room for eight more is needed. Which bits are set is hard to predict, so
/// eight are written whatever they are.
TUMBLE_INLINE void append(unsigned set, int first, int* to, int& count) {
#if defined(__AVX512VL__)
    const __m256i number = _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const __m256i packed = _mm256_maskz_compress_epi32(static_cast<__mmask8>(set), number);
    __builtin_memcpy(to + count, &packed, sizeof packed);
    count += __builtin_popcount(set);
#else
    for (int lane = 0; lane < lanes; ++lane) {
        to[count] = first + lane;
        count += static_cast<int>(set >> lane & 1);
    }
#endif
}

/// Calls pack(first, n) for every eight of `count` pairs; full packs are known to be full.
template <class PackOf> TUMBLE_INLINE void by_whole_packs(int count, PackOf&& pack) {
    int first = 0;
    for (; first + lanes <= count; first += lanes)
        pack(first, lanes);
    if (first < count)
        pack(first, count - first);
}

/// One bit per byte, each 0 or 1; the lowest n.
TUMBLE_INLINE unsigned bits_of_bytes(const std::uint8_t* bytes, int n) {
    std::uint64_t eight = 0;
    __builtin_memcpy(&eight, bytes, sizeof eight);
    return static_cast<unsigned>((eight * 0x0102040810204080U) >> 56) & ((1U << n) - 1);
}

/// The reverse: eight bytes, each 0 or 1.
TUMBLE_INLINE void bytes_of_bits(unsigned bits, std::uint8_t* bytes) {
    const std::uint64_t spread = (bits * 0x0101010101010101U) & 0x8040201008040201U;
    const std::uint64_t eight = (spread + 0x7f7f7f7f7f7f7f7fU) >> 7 & 0x0101010101010101U;
    __builtin_memcpy(bytes, &eight, sizeof eight);
}

} // namespace

int near_bodies(const Bounds* bounds, int begin, int end, const Bounds& sphere, int* found) {
    int count = 0;
    for (int first = begin; first < end; first += lanes) {
        const int n = end - first < lanes ? end - first : lanes;
        const Columns other =
            gather([&](int k) TUMBLE_INLINE_LAMBDA { return bounds[first + (k < n ? k : n - 1)].centre; });
        const Vec3<Pack> d{other.x - Pack(sphere.centre[0]), other.y - Pack(sphere.centre[1]),
                           other.z - Pack(sphere.centre[2])};
        const Pack reach = other.w + Pack(sphere.reach);
        append(bits(dot(d, d) < reach * reach) & ((1U << n) - 1), first, found, count);
    }
    return count;
}

int near_spheres(const BodyMotion* motion, const SpherePair* pairs, int count, const Shift* images, double skin,
                 int* found) {
    int n = 0;
    by_whole_packs(count, [&](int first, int of_these) TUMBLE_INLINE_LAMBDA {
        append(closer_than(skin, motion, pairs + first, of_these, images), first, found, n);
    });
    return n;
}

TouchCounts touch_spheres(const BodyMotion* motion, const NearPair* pairs, int count, const Shift* images, double neck,
                          std::uint8_t* touching, int* contacts, int* ended) {
    TouchCounts counts{0, 0};
    by_whole_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
        const unsigned was = bits_of_bytes(touching + first, n);
        unsigned now = closer_than(0, motion, pairs + first, n, images);
        if (neck > 0)
            now |= was & closer_than(neck, motion, pairs + first, n, images);
        append(now, first, contacts, counts.contacts);
        for (unsigned parted = was & ~now; parted != 0; parted &= parted - 1)
            ended[counts.ended++] = first + __builtin_ctz(parted);
        bytes_of_bits(now, touching + first);
    });
    return counts;
}

namespace {

/// b's spheres seen from a, in a's principal frame.
struct SeenFrom {
    double rotation[9]; // row-major
    double offset[3];   // m, from b's centre of mass to a's
    const double* spheres_a;
    const double* spheres_b;

    TUMBLE_INLINE SeenFrom(const Placements& at, const BodyPair& pair) {
        const BodyMotion& a = at.motion[pair.a];
        const BodyMotion& b = at.motion[pair.b];
        const double* to_world_a = at.turn[pair.a].rotation;
        const double* to_world_b = at.turn[pair.b].rotation;
        const double* shift = at.images[pair.image].along;
        double between[3];
        for (int k = 0; k < 3; ++k)
            between[k] = a.position[k] - b.position[k] - shift[k];
        for (int i = 0; i < 3; ++i) {
            offset[i] = to_world_a[i] * between[0] + to_world_a[3 + i] * between[1] + to_world_a[6 + i] * between[2];
            for (int j = 0; j < 3; ++j)
                rotation[3 * i + j] = to_world_a[i] * to_world_b[j] + to_world_a[3 + i] * to_world_b[3 + j] +
                                      to_world_a[6 + i] * to_world_b[6 + j];
        }
        spheres_a = at.shapes[at.shape[pair.a]].exposed;
        spheres_b = at.shapes[at.shape[pair.b]].exposed;
    }

    /// A bit for each of eight candidates whose gap is below `gap`; lanes from n on repeat the last of them.
    TUMBLE_INLINE unsigned closer_than(double gap, const SphereCandidate* candidates, int n) const {
        const auto lane = [&](int k) TUMBLE_INLINE_LAMBDA { return candidates[k < n ? k : n - 1]; };
        const Columns a = gather([&](int k) TUMBLE_INLINE_LAMBDA { return spheres_a + 4 * lane(k).a; });
        const Columns b = gather([&](int k) TUMBLE_INLINE_LAMBDA { return spheres_b + 4 * lane(k).b; });
        const double* r = rotation;
        const Pack dx = Pack(offset[0]) + a.x - (Pack(r[0]) * b.x + Pack(r[1]) * b.y + Pack(r[2]) * b.z);
        const Pack dy = Pack(offset[1]) + a.y - (Pack(r[3]) * b.x + Pack(r[4]) * b.y + Pack(r[5]) * b.z);
        const Pack dz = Pack(offset[2]) + a.z - (Pack(r[6]) * b.x + Pack(r[7]) * b.y + Pack(r[8]) * b.z);
        const Pack reach = a.w + b.w + Pack(gap);
        return bits(dx * dx + dy * dy + dz * dz < reach * reach) & ((1U << n) - 1);
    }
};

TUMBLE_INLINE double neck_of(const Necks& necks, const Placements& at, const BodyPair& pair) {
    if (!necks.reach)
        return 0;
    return necks.reach[at.shapes[at.shape[pair.a]].material * necks.materials + at.shapes[at.shape[pair.b]].material];
}

} // namespace

TouchCounts touch_clumps(const Placements& at, const BodyPair* pairs, int count, const SphereCandidate* candidates,
                         const Necks& necks, std::uint8_t* touching, ClumpTouch* contacts, int* ended) {
    TouchCounts counts{0, 0};
    for (int p = 0; p < count; ++p) {
        const BodyPair& pair = pairs[p];
        if (pair.count == 0)
            continue;
        const SeenFrom seen(at, pair);
        const double neck = neck_of(necks, at, pair);
        const int end = pair.begin + pair.count;
        for (int first = pair.begin; first < end; first += Pack::lanes) {
            const int n = end - first < Pack::lanes ? end - first : Pack::lanes;
            const unsigned was = bits_of_bytes(touching + first, n);
            unsigned now = seen.closer_than(0, candidates + first, n);
            if (neck > 0)
                now |= was & seen.closer_than(neck, candidates + first, n);
            for (unsigned left = now; left != 0; left &= left - 1)
                contacts[counts.contacts++] = {p, first + __builtin_ctz(left)};
            for (unsigned changed = now ^ was; changed != 0; changed &= changed - 1) {
                const int lane = __builtin_ctz(changed);
                const unsigned touches = now >> lane & 1;
                ended[counts.ended] = first + lane;
                counts.ended += touches == 0;
                touching[first + lane] = static_cast<std::uint8_t>(touches);
            }
        }
    }
    return counts;
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
