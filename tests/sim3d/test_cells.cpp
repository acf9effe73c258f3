#include "base/rng.h"
#include "sim3d/cells.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <set>
#include <tuple>

namespace test_cells {

using namespace tumble;
using namespace tumble::sim3d;
using Eigen::Vector3d;

namespace {

struct Crowd {
    scene::Domain domain;
    Lines<Bounds> bodies;
    double reach = 0;
};

Crowd crowd(std::array<bool, 3> periodic, int bodies, double reach) {
    Crowd c;
    c.domain.box = {{-0.1, 0.2, 0}, {0.1, 0.5, 0.45}};
    c.domain.periodic = periodic;
    c.reach = reach;
    Rng rng(static_cast<std::uint64_t>(bodies));
    for (int k = 0; k < bodies; ++k)
        c.bodies.push_back({{rng.uniform(-0.1, 0.1), rng.uniform(0.2, 0.5), rng.uniform(0, 0.45)}, reach / 2});
    return c;
}

using Found = std::set<std::tuple<int, int, int>>; // a, b, image

Vector3d shift_of(const Crowd& c, int image) {
    const Vector3d length = c.domain.box.hi - c.domain.box.lo;
    return {(image % 3 - 1) * length.x(), (image / 3 % 3 - 1) * length.y(), (image / 9 - 1) * length.z()};
}

bool within_reach(const Crowd& c, int a, int b, int image) {
    const Vector3d seen = Vector3d(c.bodies[static_cast<std::size_t>(b)].centre) + shift_of(c, image);
    return (Vector3d(c.bodies[static_cast<std::size_t>(a)].centre) - seen).norm() < c.reach;
}

Found each_with_each(const Crowd& c) {
    Found found;
    const int bodies = static_cast<int>(c.bodies.size());
    for (int image = 0; image < 27; ++image) {
        bool exists = true;
        for (int k = 0, rest = image; k < 3; ++k, rest /= 3)
            exists = exists && (rest % 3 == 1 || c.domain.periodic[static_cast<std::size_t>(k)]);
        for (int a = 0; exists && a < bodies; ++a)
            for (int b = 0; b < bodies; ++b)
                if (within_reach(c, a, b, image))
                    found.emplace(a, b, image);
    }
    return found;
}

Found through_cells(const Crowd& c) {
    Cells cells;
    cells.sort(c.domain, c.bodies, c.reach);
    Found found;
    std::array<Cells::Seen, 27> seen{};
    for (int a = 0; a < static_cast<int>(c.bodies.size()); ++a) {
        const int count = cells.around(c.bodies[static_cast<std::size_t>(a)].centre, seen);
        for (int k = 0; k < count; ++k) {
            const Cells::Seen& row = seen[static_cast<std::size_t>(k)];
            for (int place = row.begin; place < row.end; ++place) {
                const int b = cells.order()[static_cast<std::size_t>(place)];
                if (!within_reach(c, a, b, row.image))
                    continue;
                const bool once = found.emplace(a, b, row.image).second;
                CHECK(once);
            }
        }
    }
    return found;
}

} // namespace

TEST_CASE("the cells around a body hold every body within reach, each image once") {
    for (const auto& periodic : {std::array{false, false, false}, {true, false, false}, {true, true, true}})
        for (const double reach : {0.02, 0.06, 0.15}) {
            const Crowd c = crowd(periodic, 150, reach);
            CHECK(through_cells(c) == each_with_each(c));
        }
}

TEST_CASE("the order lists every body once, cell by cell") {
    const Crowd c = crowd({false, true, false}, 300, 0.03);
    Cells cells;
    cells.sort(c.domain, c.bodies, c.reach);
    std::vector<int> sorted = cells.order();
    int last = 0;
    for (const int body : sorted) {
        const int cell = cells.cell_of(c.bodies[static_cast<std::size_t>(body)].centre);
        CHECK(cell >= last);
        last = cell;
    }
    std::sort(sorted.begin(), sorted.end());
    for (int k = 0; k < 300; ++k)
        CHECK(sorted[static_cast<std::size_t>(k)] == k);
}

TEST_CASE("two bodies a kilometre apart do not cost millions of cells") {
    Crowd c = crowd({false, false, false}, 0, 0.01);
    c.bodies = {{{0, 0, 0}, 0.005}, {{1000, 1000, 1000}, 0.005}};
    Cells cells;
    cells.sort(c.domain, c.bodies, c.reach);
    CHECK(cells.count() <= 4 * 2 + 64);
}

} // namespace test_cells
