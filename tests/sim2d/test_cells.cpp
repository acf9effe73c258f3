#include "base/rng.h"
#include "sim2d/cells.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>
#include <tuple>

namespace test_cells {

using namespace tumble;
using namespace tumble::sim2d;
using Eigen::Vector2d;

namespace {

struct Points {
    scene::Domain domain;
    std::vector<Vector2d> points;
    double reach = 0;
};

Points points_in_a_box(std::array<bool, 3> periodic, int count, double reach) {
    Points p;
    p.domain.box = {{-0.1, 0.2, 0}, {0.1, 0.5, 1}};
    p.domain.periodic = periodic;
    p.reach = reach;
    Rng rng(static_cast<std::uint64_t>(count));
    for (int k = 0; k < count; ++k)
        p.points.emplace_back(rng.uniform(-0.1, 0.1), rng.uniform(0.2, 0.5));
    return p;
}

using Found = std::set<std::tuple<int, int, int>>; // a, b, image

bool within_reach(const Points& p, int a, int b, int image) {
    const Vector2d length = (p.domain.box.hi - p.domain.box.lo).head<2>();
    const Vector2d shift((image % 3 - 1) * length.x(), (image / 3 - 1) * length.y());
    return (p.points[static_cast<std::size_t>(a)] - p.points[static_cast<std::size_t>(b)] - shift).norm() < p.reach;
}

Found each_with_each(const Points& p) {
    Found found;
    const int count = static_cast<int>(p.points.size());
    for (int image = 0; image < 9; ++image) {
        if ((image % 3 != 1 && !p.domain.periodic[0]) || (image / 3 != 1 && !p.domain.periodic[1]))
            continue;
        for (int a = 0; a < count; ++a)
            for (int b = 0; b < count; ++b)
                if (within_reach(p, a, b, image))
                    found.emplace(a, b, image);
    }
    return found;
}

Found through_cells(const Points& p) {
    Cells cells;
    cells.sort(p.domain, p.points, p.reach);
    Found found;
    std::array<Cells::Seen, 9> seen{};
    for (int a = 0; a < static_cast<int>(p.points.size()); ++a) {
        const int count = cells.around(p.points[static_cast<std::size_t>(a)], seen);
        for (int k = 0; k < count; ++k)
            for (const int* b = seen[static_cast<std::size_t>(k)].begin; b != seen[static_cast<std::size_t>(k)].end;
                 ++b) {
                const int image = seen[static_cast<std::size_t>(k)].image;
                if (!within_reach(p, a, *b, image))
                    continue;
                const bool once = found.emplace(a, *b, image).second;
                CHECK(once);
            }
    }
    return found;
}

} // namespace

TEST_CASE("the cells around a point hold every point within reach, each image once") {
    for (const auto& periodic : {std::array{false, false, false}, {true, false, false}, {true, true, false}})
        for (const double reach : {0.01, 0.03, 0.09}) {
            const Points p = points_in_a_box(periodic, 200, reach);
            CHECK(through_cells(p) == each_with_each(p));
        }
}

TEST_CASE("the order lists every point once") {
    const Points p = points_in_a_box({false, true, false}, 300, 0.03);
    Cells cells;
    cells.sort(p.domain, p.points, p.reach);
    std::vector<int> sorted = cells.order();
    std::sort(sorted.begin(), sorted.end());
    REQUIRE(sorted.size() == 300);
    for (int k = 0; k < 300; ++k)
        CHECK(sorted[static_cast<std::size_t>(k)] == k);
}

} // namespace test_cells
