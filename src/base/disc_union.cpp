#include "base/disc_union.h"

#include <algorithm>
#include <cmath>

namespace tumble {

void add_arc(const UnionDisc& disc, double from, double to, AreaMoments& sums) {
    const double x = disc.x, y = disc.y, r = disc.radius;
    const double s0 = std::sin(from), s1 = std::sin(to), c0 = std::cos(from), c1 = std::cos(to);
    const double width = to - from;
    const auto cube = [](double v) { return v * v * v; };
    const auto fourth = [](double v) { return v * v * v * v; };
    // Integrals of cos^n, sin^n and sin cos^n over the arc.
    const double cos_1 = s1 - s0, sin_1 = c0 - c1;
    const double cos_2 = (width + s1 * c1 - s0 * c0) / 2, sin_2 = width - cos_2;
    const double cos_3 = cos_1 - (cube(s1) - cube(s0)) / 3, sin_3 = sin_1 - (cube(c0) - cube(c1)) / 3;
    const double cos_4 = (cube(c1) * s1 - cube(c0) * s0 + 3 * cos_2) / 4;
    const double sin_4 = (-cube(s1) * c1 + cube(s0) * c0 + 3 * sin_2) / 4;
    const double sin_cos_1 = (s1 * s1 - s0 * s0) / 2;
    const double sin_cos_2 = (cube(c0) - cube(c1)) / 3;
    const double sin_cos_3 = (fourth(c0) - fourth(c1)) / 4;

    sums[0] += r * (x * cos_1 + y * sin_1 + r * width) / 2;
    sums[1] += r * (x * x * cos_1 + 2 * x * r * cos_2 + r * r * cos_3) / 2;
    sums[2] += r * (y * y * sin_1 + 2 * y * r * sin_2 + r * r * sin_3) / 2;
    sums[3] += r * (cube(x) * cos_1 + 3 * x * x * r * cos_2 + 3 * x * r * r * cos_3 + cube(r) * cos_4) / 3;
    sums[4] += r * (cube(y) * sin_1 + 3 * y * y * r * sin_2 + 3 * y * r * r * sin_3 + cube(r) * sin_4) / 3;
    sums[5] += r *
               (y * (x * x * cos_1 + 2 * x * r * cos_2 + r * r * cos_3) +
                r * (x * x * sin_cos_1 + 2 * x * r * sin_cos_2 + r * r * sin_cos_3)) /
               2;
}

bool hide_inside(const UnionDisc& disc, const UnionDisc& other, AngleCover& cover) {
    const double dx = other.x - disc.x, dy = other.y - disc.y;
    const double apart = std::hypot(dx, dy);
    // Two equal discs would hide each other; the first of them stays.
    const bool same = apart + std::abs(other.radius - disc.radius) < 1e-13 * disc.radius;
    if (same)
        return disc.number < other.number;
    if (apart + disc.radius <= other.radius)
        return false;
    if (apart >= disc.radius + other.radius || apart + other.radius <= disc.radius)
        return true;
    const double cosine =
        (apart * apart + disc.radius * disc.radius - other.radius * other.radius) / (2 * apart * disc.radius);
    cover.hide(std::atan2(dy, dx), std::acos(std::clamp(cosine, -1.0, 1.0)));
    return true;
}

} // namespace tumble
