#pragma once

#include "base/pack.h"
#include "render/kernels.h"

#include <cstdint>
#if defined(__AVX__)
#include <immintrin.h>
#endif

/// Eight floats side by side, one a sample. Each rounds exactly as a lone float does, on every instruction set.
namespace tumble::render::TUMBLE_ISA {

using Lanes = float __attribute__((vector_size(32)));
using Words = std::int32_t __attribute__((vector_size(32)));
static_assert(sizeof(Lanes) == samples_at_once * sizeof(float));

TUMBLE_INLINE Lanes all(float x) {
    return Lanes{x, x, x, x, x, x, x, x};
}
TUMBLE_INLINE Words all(std::int32_t x) {
    return Words{x, x, x, x, x, x, x, x};
}
/// Both from and to any address.
TUMBLE_INLINE Lanes load(const float* from) {
    Lanes lanes;
    __builtin_memcpy(&lanes, from, sizeof lanes);
    return lanes;
}
template <class T, class V> TUMBLE_INLINE void store(V lanes, T* to) {
    static_assert(sizeof lanes == samples_at_once * sizeof(T));
    __builtin_memcpy(to, &lanes, sizeof lanes);
}
TUMBLE_INLINE Lanes select(Words condition, Lanes yes, Lanes no) {
    return condition ? yes : no;
}
TUMBLE_INLINE Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}
TUMBLE_INLINE Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}
/// NaN of a negative number.
TUMBLE_INLINE Lanes root(Lanes x) {
#if defined(__AVX__)
    return Lanes(_mm256_sqrt_ps(__m256(x)));
#else
    Lanes r;
    for (int lane = 0; lane < samples_at_once; ++lane)
        r[lane] = __builtin_sqrtf(x[lane]);
    return r;
#endif
}
TUMBLE_INLINE bool any(Words mask) {
#if defined(__AVX__)
    return _mm256_testz_si256(__m256i(mask), __m256i(mask)) == 0;
#else
    std::int32_t together = 0;
    for (int lane = 0; lane < samples_at_once; ++lane)
        together |= mask[lane];
    return together != 0;
#endif
}
TUMBLE_INLINE Words larger(Words a, Words b) {
    return a > b ? a : b;
}
TUMBLE_INLINE Words smaller(Words a, Words b) {
    return a < b ? a : b;
}
TUMBLE_INLINE Lanes within(Lanes x, Lanes lo, Lanes hi) {
    return smaller(larger(x, lo), hi);
}
/// from[index] for every lane.
TUMBLE_INLINE Lanes look_up(const float* from, Words index) {
#if defined(__AVX2__)
    return Lanes(_mm256_i32gather_ps(from, __m256i(index), sizeof(float)));
#else
    Lanes r;
    for (int lane = 0; lane < samples_at_once; ++lane)
        r[lane] = from[index[lane]];
    return r;
#endif
}
TUMBLE_INLINE float least(Lanes x) {
    float s = x[0];
    for (int lane = 1; lane < samples_at_once; ++lane)
        s = x[lane] < s ? x[lane] : s;
    return s;
}
TUMBLE_INLINE Lanes as_numbers(Words x) {
    return __builtin_convertvector(x, Lanes);
}
/// Towards zero.
TUMBLE_INLINE Words as_words(Lanes x) {
    return __builtin_convertvector(x, Words);
}

} // namespace tumble::render::TUMBLE_ISA
