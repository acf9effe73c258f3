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
