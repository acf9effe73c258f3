#include "about.h"
#include "half_space.h"
#include "solid/hertz_patch.h"

#include <map>

namespace test_patch_stress {

using namespace tumble;
using namespace tumble::fem;
using Eigen::Vector3d;
using tumble::test::about;
using tumble::test::GradedBlock;

namespace {

constexpr double force = 100, a = 0.0025;                           // N, m
constexpr double peak = 3 * force / (2 * std::numbers::pi * a * a); // Pa, in the middle of the patch

/// The stress on the axis of a patch that is so many bricks in radius.
class UnderPatch {
public:
    explicit UnderPatch(int finer) : finer_(finer), block_(a, finer, force, test::steel) {
        const auto push =
            solid::moved_to(*block_.mesh, {0, Vector3d::Zero(), {0, 0, force}}, -Vector3d::UnitZ()).value();
        const auto points = solid::PatchSpreader(*block_.mesh).spread(push, -Vector3d::UnitZ(), a);
        const Eigen::Matrix3Xd loads = solid::nodal_loads(*block_.mesh, points).value();
        solution_ =
            test::solved(block_.mesh, test::steel, Formulation::incompatible, block_.supports, loads.reshaped(), 2);
    }

    /// At a depth of so many radii, in units of Hertz' largest pressure.
    [[nodiscard]] Stress at(int radii) const {
        return test::stress_at(solution_, block_.beneath(finer_ * radii)) / peak;
    }

private:
    int finer_;
    GradedBlock block_;
    Solution solution_;
};

} // namespace

TEST_CASE("the stress right at the surface under a patch goes to Hertz' pressure as bricks get finer") {
    // On the axis sigma_zz = -p0 / (1 + z^2 / a^2); at the surface sigma_xx = sigma_yy = -p0 (1 + 2 nu) / 2 = -0.8 p0
    // (Johnson, Contact Mechanics, 3.4). At a radius' depth, where stresses are smooth, the error falls with the square
    // of a brick at least; at the surface, to which stresses are extrapolated, with the brick at least.
    std::map<int, std::array<double, 3>> off; // by bricks a radius: across and along the surface, a radius deep
    for (const int finer : {2, 3, 4, 6}) {
        const UnderPatch patch(finer);
        const Stress surface = patch.at(0);
        CAPTURE(finer);
        CHECK(surface[0] == about(surface[1], 0.01)); // the points tell x from y a little
        off[finer] = {std::abs(surface[2] + 1), std::abs(surface[0] + 0.8), std::abs(patch.at(1)[2] + 0.5)};
    }
    // The coarsest is the only one that is held by itself; all others follow from it and the order.
    CHECK(off[2][0] < 0.2);
    CHECK(off[2][1] < 0.2);
    CHECK(off[2][2] < 0.0625); // an eighth of the stress there
    for (const auto& [coarse, fine] : {std::pair{2, 3}, {2, 4}, {2, 6}, {3, 6}}) {
        const double finer = static_cast<double>(fine) / coarse;
        CAPTURE(coarse);
        CAPTURE(fine);
        CHECK(off[coarse][0] / off[fine][0] > finer);
        CHECK(off[coarse][1] / off[fine][1] > finer);
        CHECK(off[coarse][2] / off[fine][2] > finer * finer);
    }
    CHECK(off[4][0] < off[3][0]);
    CHECK(off[6][0] < 0.05);
}

} // namespace test_patch_stress
