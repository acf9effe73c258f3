#include "about.h"
#include "half_space.h"
#include "solid/hertz_patch.h"

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
    // of a brick.
    std::vector<double> off;
    for (const int finer : {2, 3, 4, 6}) {
        const UnderPatch patch(finer);
        const Stress surface = patch.at(0);
        CAPTURE(finer);
        off.push_back(std::abs(surface[2] + 1));
        MESSAGE("a / ", finer, ": surface ", surface[2], " ", surface[0], ", at a radius ", patch.at(1)[2]);
        CHECK(surface[0] == about(surface[1], 0.01)); // the points tell x from y a little
        CHECK(std::abs(surface[0] + 0.8) < 0.4 / finer);
        CHECK(patch.at(1)[2] == about(-0.5, 0.5 / (finer * finer)));
        if (off.size() > 1)
            CHECK(off.back() < off[off.size() - 2]);
    }
    CHECK(off[3] < 0.05);
    CHECK(off[0] / off[3] > 2.5);
}

} // namespace test_patch_stress
