#pragma once

#include "base/pack.h"

namespace tumble {

/// Three numbers, or three packs of numbers: what the laws compute with, in place of Eigen's vectors, because the same
/// line must work on eight contacts at once.
template <class Real> struct Vec3 {
    Real x, y, z;

    TUMBLE_INLINE friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    TUMBLE_INLINE friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    TUMBLE_INLINE friend Vec3 operator*(const Vec3& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
};

template <class Real> TUMBLE_INLINE Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real> TUMBLE_INLINE Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace tumble
