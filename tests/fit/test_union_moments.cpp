#include "about.h"
#include "fit/union_moments.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <numbers>

namespace test_union_moments {

using namespace tumble;
using namespace tumble::fit;
using Eigen::Vector3d;
using tumble::test::about;

TEST_CASE("two overlapping spheres have the volume of two less the lens") {
    // Lens of spheres R, r at distance d: pi (R+r-d)^2 (d^2 + 2d(r+R) - 3(r-R)^2) / (12 d).
    const double R = 3e-3, r = 2e-3;
    for (double d : {1.5e-3, 2.5e-3, 4e-3, 4.99e-3, 5.5e-3}) {
        const double gap = std::max(0.0, R + r - d);
        const double lens = std::numbers::pi * gap * gap * (d * d + 2 * d * (r + R) - 3 * (r - R) * (r - R)) / (12 * d);
        const double expected = 4.0 / 3 * std::numbers::pi * (R * R * R + r * r * r) - lens;
        for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0.6, 0.64, 0.48)}) {
            const UnionMoments moments = union_moments({{Vector3d(1, 1, 1), R}, {Vector3d(1, 1, 1) + d * way, r}});
            CHECK(moments.volume == about(expected, 2e-8));
            CHECK(moments.error < 1e-8);
        }
    }
}

} // namespace test_union_moments
