#include "base/rng.h"
#include "solver/cell_chains.h"

#include <doctest/doctest.h>
#include <vector>

namespace test_cell_chains {

using namespace tumble;

namespace {

/// A box of 1 x 2 x 3 m whose first side is periodic.
const scene::Domain domain{{{0, 0, 0}, {1, 2, 3}}, {true, false, false}};

template <int dimensions> void against_brute_force() {
    using Point = typename solver::CellChains<dimensions>::Point;
    constexpr double reach = 0.1;
    solver::CellChains<dimensions> cells(domain, reach);
    std::vector<Point> points;
    Rng rng(7);
    const auto random_point = [&] {
        Point point;
        for (int axis = 0; axis < dimensions; ++axis)
            point[axis] = rng.uniform(axis == 0 ? -1.0 : 0.0, axis == 0 ? 2.0 : domain.box.hi[axis]);
        point += cells.way_into_box(point);
        REQUIRE(point.x() >= 0);
        REQUIRE(point.x() <= 1);
        return point;
    };
    for (int k = 0; k < 300; ++k) {
        points.push_back(random_point());
        cells.add(points.back());
    }
    int met = 0;
    for (int k = 0; k < 300; ++k) {
        const Point point = random_point();
        bool expected = false;
        for (const Point& other : points)
            for (const double shift : {-1.0, 0.0, 1.0})
                expected = expected || (other + shift * Point::UnitX() - point).norm() < reach;
        const bool found = cells.any_near(point, [&](std::size_t number, const Point& shift) {
            return (points[number] + shift - point).norm() < reach;
        });
        CHECK(found == expected);
        met += found ? 1 : 0;
    }
    CHECK(met > 0);
    CHECK(met < 300);
}

} // namespace

TEST_CASE("what stands near a point is found, also through a periodic side, in the plane and in space") {
    against_brute_force<2>();
    against_brute_force<3>();
}

} // namespace test_cell_chains
