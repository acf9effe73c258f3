#pragma once

#include <cmath>
#include <cstdint>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif

// The hot files are built several times, once per instruction set, and the set is chosen at run time. Everything they
// share inline must therefore be inlined for certain (else the linker could keep one set's copy for all) or carry the
// set in its type's name, as Pack does.
#define TUMBLE_INLINE [[gnu::always_inline]] inline
#define TUMBLE_INLINE_LAMBDA __attribute__((always_inline))
#ifndef TUMBLE_ISA
#define TUMBLE_ISA isa_baseline
#endif

namespace tumble {

TUMBLE_INLINE double select(bool condition, double yes, double no) {
    return condition ? yes : no;
}
TUMBLE_INLINE double root(double x) {
    return std::sqrt(x);
}
TUMBLE_INLINE double larger(double a, double b) {
    return a > b ? a : b;
}
TUMBLE_INLINE double logarithm(double x) {
    return std::log(x);
}
TUMBLE_INLINE double exponential(double x) {
    return std::exp(x);
}
TUMBLE_INLINE double cube_root(double x) {
    return std::cbrt(x);
}

namespace TUMBLE_ISA {

/// Eight doubles side by side. Each lane rounds exactly as a lone double does, on every instruction set.
struct Pack {
    static constexpr int lanes = 8;
    using Lanes = double __attribute__((vector_size(64)));
    using MaskLanes = std::int64_t __attribute__((vector_size(64)));

    Lanes v;

    struct Mask {
        MaskLanes m;
        TUMBLE_INLINE Mask operator&(Mask o) const { return {m & o.m}; }
        TUMBLE_INLINE Mask operator|(Mask o) const { return {m | o.m}; }
    };

    Pack() = default;
    TUMBLE_INLINE Pack(double x) : v{x, x, x, x, x, x, x, x} {}
    TUMBLE_INLINE explicit Pack(Lanes lanes_) : v(lanes_) {}

    /// `from` holds 8 doubles and is 64-byte aligned.
    TUMBLE_INLINE static Pack load(const double* from) { return Pack(*reinterpret_cast<const Lanes*>(from)); }
    TUMBLE_INLINE void store(double* to) const { *reinterpret_cast<Lanes*>(to) = v; }
    /// The same at any address.
    TUMBLE_INLINE static Pack load_anywhere(const double* from) {
        Pack p;
        __builtin_memcpy(&p.v, from, sizeof p.v);
        return p;
    }
    TUMBLE_INLINE void store_anywhere(double* to) const { __builtin_memcpy(to, &v, sizeof v); }

    TUMBLE_INLINE Pack operator-() const { return Pack(-v); }
    TUMBLE_INLINE friend Pack operator+(Pack a, Pack b) { return Pack(a.v + b.v); }
    TUMBLE_INLINE friend Pack operator-(Pack a, Pack b) { return Pack(a.v - b.v); }
    TUMBLE_INLINE friend Pack operator*(Pack a, Pack b) { return Pack(a.v * b.v); }
    TUMBLE_INLINE friend Pack operator/(Pack a, Pack b) { return Pack(a.v / b.v); }
    TUMBLE_INLINE Pack& operator+=(Pack b) {
        v += b.v;
        return *this;
    }
    TUMBLE_INLINE friend Mask operator<(Pack a, Pack b) { return {a.v < b.v}; }
    TUMBLE_INLINE friend Mask operator>(Pack a, Pack b) { return {a.v > b.v}; }
};

TUMBLE_INLINE Pack select(Pack::Mask condition, Pack yes, Pack no) {
    return Pack(condition.m ? yes.v : no.v);
}
/// One bit per lane, the first the lowest.
TUMBLE_INLINE unsigned bits(Pack::Mask mask) {
#if defined(__AVX512F__)
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask.m));
#else
    unsigned all = 0;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        all |= static_cast<unsigned>(mask.m[lane] & 1) << lane;
    return all;
#endif
}
TUMBLE_INLINE Pack larger(Pack a, Pack b) {
    return Pack(a.v > b.v ? a.v : b.v);
}
TUMBLE_INLINE Pack root(Pack x) {
#if defined(__AVX512F__)
    return Pack(static_cast<Pack::Lanes>(_mm512_sqrt_pd(x.v)));
#else
    Pack r;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        r.v[lane] = __builtin_sqrt(x.v[lane]);
    return r;
#endif
}
/// Lane by lane, the library's own.
TUMBLE_INLINE Pack logarithm(Pack x) {
    Pack r;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        r.v[lane] = __builtin_log(x.v[lane]);
    return r;
}
TUMBLE_INLINE Pack exponential(Pack x) {
    Pack r;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        r.v[lane] = __builtin_exp(x.v[lane]);
    return r;
}
TUMBLE_INLINE Pack cube_root(Pack x) {
    Pack r;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        r.v[lane] = __builtin_cbrt(x.v[lane]);
    return r;
}
/// Four doubles side by side: a row.
using Quad = double __attribute__((vector_size(32)));

/// Four packs that stand for eight rows of four doubles: column k holds the k-th double of every row.
struct Columns {
    Pack x, y, z, w;
};

/// Columns of eight rows of four doubles; row(k) points to one, 32-byte aligned, for k = 0 .. 7.
template <class RowOf> TUMBLE_INLINE Columns gather(RowOf&& row) {
    const auto quad = [&](int k) TUMBLE_INLINE_LAMBDA { return *reinterpret_cast<const Quad*>(row(k)); };
    // Rows k and k + 4 share a register; then 4 x 4 blocks are turned in both halves at once.
    const auto both = [&](int k) TUMBLE_INLINE_LAMBDA {
        return __builtin_shufflevector(quad(k), quad(k + 4), 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const auto r0 = both(0), r1 = both(1), r2 = both(2), r3 = both(3);
    const auto even01 = __builtin_shufflevector(r0, r1, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto odd01 = __builtin_shufflevector(r0, r1, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto even23 = __builtin_shufflevector(r2, r3, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto odd23 = __builtin_shufflevector(r2, r3, 1, 9, 3, 11, 5, 13, 7, 15);
    return {Pack(static_cast<Pack::Lanes>(__builtin_shufflevector(even01, even23, 0, 1, 8, 9, 4, 5, 12, 13))),
            Pack(static_cast<Pack::Lanes>(__builtin_shufflevector(odd01, odd23, 0, 1, 8, 9, 4, 5, 12, 13))),
            Pack(static_cast<Pack::Lanes>(__builtin_shufflevector(even01, even23, 2, 3, 10, 11, 6, 7, 14, 15))),
            Pack(static_cast<Pack::Lanes>(__builtin_shufflevector(odd01, odd23, 2, 3, 10, 11, 6, 7, 14, 15)))};
}

/// gather() undone: calls put(k, row) for the eight rows.
template <class Put> TUMBLE_INLINE void for_rows(const Columns& c, Put&& put) {
    const auto even01 = __builtin_shufflevector(c.x.v, c.y.v, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto odd01 = __builtin_shufflevector(c.x.v, c.y.v, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto even23 = __builtin_shufflevector(c.z.v, c.w.v, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto odd23 = __builtin_shufflevector(c.z.v, c.w.v, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto halves = [&](int k, auto rows) TUMBLE_INLINE_LAMBDA {
        put(k, static_cast<Quad>(__builtin_shufflevector(rows, rows, 0, 1, 2, 3)));
        put(k + 4, static_cast<Quad>(__builtin_shufflevector(rows, rows, 4, 5, 6, 7)));
    };
    halves(0, __builtin_shufflevector(even01, even23, 0, 1, 8, 9, 4, 5, 12, 13));
    halves(1, __builtin_shufflevector(odd01, odd23, 0, 1, 8, 9, 4, 5, 12, 13));
    halves(2, __builtin_shufflevector(even01, even23, 2, 3, 10, 11, 6, 7, 14, 15));
    halves(3, __builtin_shufflevector(odd01, odd23, 2, 3, 10, 11, 6, 7, 14, 15));
}

/// The quad at a 32-byte aligned address.
TUMBLE_INLINE Quad& quad_at(double* at) {
    return *reinterpret_cast<Quad*>(at);
}

/// Sum in lane order.
TUMBLE_INLINE double sum(Pack x) {
    double s = 0;
    for (int lane = 0; lane < Pack::lanes; ++lane)
        s += x.v[lane];
    return s;
}
TUMBLE_INLINE double largest(Pack x) {
    double s = x.v[0];
    for (int lane = 1; lane < Pack::lanes; ++lane)
        s = x.v[lane] > s ? x.v[lane] : s;
    return s;
}

} // namespace TUMBLE_ISA
} // namespace tumble
