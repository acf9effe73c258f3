#include "about.h"
#include "base/rng.h"
#include "observe/mean_pushes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace test_mean_pushes {

using namespace tumble;
using namespace tumble::observe;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

/// Two halves of a facet of 8 x 2 mm in the plane y = 0, and one that rises from its edge.
const std::vector<std::array<Vector3d, 3>> triangles{
    {Vector3d(0, 0, 0), Vector3d(0, 0, 0.002), Vector3d(0.008, 0, 0.002)},
    {Vector3d(0, 0, 0), Vector3d(0.008, 0, 0.002), Vector3d(0.008, 0, 0)},
    {Vector3d(0, 0, 0), Vector3d(0, 0.003, 0), Vector3d(0, 0.001, 0.005)}};

WallPush push_on(int triangle, double v, double w, const Vector3d& force, double patch) {
    const auto& [a, b, c] = triangles[static_cast<std::size_t>(triangle)];
    WallPush push;
    push.body = 3;
    push.triangle = triangle;
    push.foot = a + v * (b - a) + w * (c - a);
    push.normal = (b - a).cross(c - a).normalized();
    push.force = force;
    push.patch = patch;
    return push;
}

} // namespace

TEST_CASE("the mean of many steps has their force and moment to rounding, at places of the triangles") {
    MeanPushes means(triangles);
    Rng rng(5);
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    const int steps = 400;
    const auto take = [&](const std::vector<WallPush>& pushes) {
        means.take(pushes);
        for (const WallPush& push : pushes) {
            force += push.force / (steps + 3);
            moment += push.foot.cross(push.force) / (steps + 3);
        }
    };
    for (int step = 0; step < steps; ++step) {
        double v = rng.uniform(), w = rng.uniform();
        if (v + w > 1)
            v = 1 - v, w = 1 - w;
        const Vector3d newtons(rng.uniform(-1, 1), rng.uniform(-5, 0), rng.uniform(-1, 1));
        take({push_on(step % 3, v, w, newtons, rng.uniform(0, 0.001)), push_on(1, w, v, newtons, 0.0008)});
    }
    // Corners, and sides between them.
    take({push_on(0, 0, 0, {0, -1, 0}, 0.001), push_on(0, 1, 0, {0, -2, 0}, 0.001), push_on(0, 0, 1, {0, -3, 0}, 0)});
    take({push_on(0, 0.3, 0.7, {0, -1, 0}, 0.001), push_on(2, 0, 0.37, {0, -2, 1}, 0.1)});
    take({});
    CHECK(means.steps() == steps + 3);
    const auto found = means.finish();
    Vector3d found_force = Vector3d::Zero(), found_moment = Vector3d::Zero();
    for (const WallPush& mean : found) {
        found_force += mean.force;
        found_moment += mean.foot.cross(mean.force);
        const auto& [a, b, c] = triangles[static_cast<std::size_t>(mean.triangle)];
        CHECK(closest_point(flat_triangle(a, b, c), mean.foot).distance2 < 1e-33);
        CHECK(mean.normal.norm() == about(1));
        CHECK(mean.body == -1);
    }
    CHECK((found_force - force).norm() < 1e-12);
    CHECK((found_moment - moment).norm() < 1e-15);
    CHECK(means.steps() == 0);
    CHECK(means.finish().empty());
}

TEST_CASE("a body that rolls along a facet presses on its whole path, hardly wider than its patch") {
    // Along the middle line z = 1 mm from x = 2 to 6 mm: pressed evenly, so that the mean of x is 4 mm and its variance
    // that of the path, (4 mm)^2 / 12, and of the lattice, whose side of at most half the patch adds a sixth of its
    // square in the mean over a path: (0.5 a)^2 / 6 = 0.04 a^2, where Hertz' pressure itself has 0.2 a^2.
    const double a = 0.0008;
    MeanPushes means(triangles);
    const int steps = 4001;
    for (int step = 0; step < steps; ++step) {
        const double x = 0.002 + 0.004 * step / (steps - 1);
        // On the triangle that holds it: z / 2 mm against x / 8 mm.
        const int triangle = 0.001 / 0.002 >= x / 0.008 ? 0 : 1;
        const double w = triangle == 0 ? x / 0.008 : 0.5, v = triangle == 0 ? 0.5 - w : 0.5;
        const auto place =
            triangle == 0 ? push_on(0, v, w, {0, -4, 0}, a) : push_on(1, v, x / 0.008 - v, {0, -4, 0}, a);
        REQUIRE((place.foot - Vector3d(x, 0, 0.001)).norm() < 1e-15);
        means.take({place});
    }
    const auto found = means.finish();
    double force = 0, x1 = 0, x2 = 0, z1 = 0, z2 = 0;
    for (const WallPush& mean : found) {
        const double share = -mean.force.y() / 4;
        force += share;
        x1 += share * mean.foot.x();
        x2 += share * mean.foot.x() * mean.foot.x();
        z1 += share * mean.foot.z();
        z2 += share * mean.foot.z() * mean.foot.z();
        CHECK(mean.patch == about(a, 1e-12));
    }
    CHECK(force == about(1, 1e-12));
    CHECK(x1 == about(0.004, 1e-9));
    CHECK(z1 == about(0.001, 1e-9));
    const double widened = 0.04 * 1.05 * a * a;
    CHECK(x2 - x1 * x1 - 0.004 * 0.004 / 12 > -1e-11);
    CHECK(x2 - x1 * x1 < 0.004 * 0.004 / 12 * 1.001 + widened);
    CHECK(z2 - z1 * z1 < widened);
    CHECK(found.size() < 200); // of 4001 steps
}

namespace {

/// Variances of where one push counts: along x, along z, and along the direction in which it is largest.
std::array<double, 3> widened(const std::vector<std::array<Vector3d, 3>>& on, const WallPush& push) {
    MeanPushes means(on);
    means.take({push});
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const WallPush& mean : means.finish()) {
        const Eigen::Vector2d off(mean.foot.x() - push.foot.x(), mean.foot.z() - push.foot.z());
        spread += mean.force.norm() / push.force.norm() * off * off.transpose();
    }
    return {spread(0, 0), spread(1, 1), Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues()[1]};
}

} // namespace

TEST_CASE("at its worst place a cell widens a patch by 15 percent along its sides and by 27 along its diagonal") {
    // Linear shares at distances u and h - u from two points have the variance u (h - u), h^2 / 4 in the middle; in the
    // middle of the diagonal, h sqrt(2) long, h^2 / 2. With h = a / 2 that is 1 / 16 and 1 / 8 of a^2 beside Hertz' 1 /
    // 5: sqrt(1.3125) = 1.146 and sqrt(1.625) = 1.275.
    const double a = 0.0008, h = a / 2;
    const std::vector<std::array<Vector3d, 3>> half{{Vector3d(0, 0, 0), Vector3d(0, 0, 8 * h), Vector3d(8 * h, 0, 0)}};
    const auto at = [&](double x, double z) {
        WallPush push;
        push.foot = Vector3d(x, 0, z);
        push.normal = Vector3d::UnitY();
        push.force = Vector3d(0, -3, 0);
        push.patch = a;
        return widened(half, push);
    };
    CHECK(at(2.5 * h, h)[0] == about(h * h / 4, 1e-9));
    CHECK(at(2.5 * h, h)[2] == about(h * h / 4, 1e-9));
    CHECK(at(2 * h, 1.5 * h)[1] == about(h * h / 4, 1e-9));
    CHECK(at(1.5 * h, 2.5 * h)[2] == about(h * h / 2, 1e-9));
    CHECK(at(2 * h, 3 * h)[2] < 1e-9 * h * h); // at a point of the lattice
    Rng rng(3);
    double most = 0, aslant = 0;
    for (int k = 0; k < 5000; ++k) {
        const double x = rng.uniform() * 8 * h, z = rng.uniform() * (8 * h - x);
        const auto [along, across, largest] = at(x, z);
        most = std::max({most, along, across});
        aslant = std::max(aslant, largest);
    }
    CHECK(most < h * h / 4 * (1 + 1e-9));
    CHECK(most > h * h / 4 * 0.98);
    CHECK(aslant < h * h / 2 * (1 + 1e-9));
    CHECK(aslant > h * h / 2 * 0.98);
}

TEST_CASE("a patch below a 32nd of its triangle's side counts at a 64th of it") {
    const std::vector<std::array<Vector3d, 3>> large{{Vector3d(0, 0, 0), Vector3d(0, 0, 0.008), Vector3d(0.008, 0, 0)}};
    const double h = 0.008 / 64;
    WallPush push;
    push.foot = Vector3d(20.5 * h, 0, 7 * h);
    push.normal = Vector3d::UnitY();
    push.force = Vector3d(0, -1, 0);
    for (const double patch : {1e-5, 1e-4, 2 * h}) {
        push.patch = patch;
        CHECK(widened(large, push)[0] == about(h * h / 4, 1e-9));
    }
    push.patch = 4 * h; // cells of 2 h: the foot is a quarter of one from a point
    CHECK(widened(large, push)[0] == about(0.25 * 0.75 * 4 * h * h, 1e-9));
}

} // namespace test_mean_pushes
