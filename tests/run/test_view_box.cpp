#include "about.h"
#include "run/scenes.h"
#include "run/simulation.h"
#include "run/view_box.h"

namespace test_view_box {

using namespace tumble;
using namespace tumble::test;

namespace {

Eigen::AlignedBox3d box_of(const std::vector<std::string>& sets) {
    const scene::Scene scene = loaded(falling_ball, sets);
    const auto simulation = run::simulate(scene, 1);
    REQUIRE_MESSAGE(simulation.ok(), to_string(simulation.problems()));
    return run::view_box(scene, *(*simulation)->layout());
}

} // namespace

TEST_CASE("a picture of a run that begins holds its walls and the body where it will appear") {
    const Eigen::AlignedBox3d box = box_of({"fill.0.start_s=0.01"});
    // The floor is cut at the domain, the ball of 10 mm begins at 0.5 m.
    CHECK(box.min().isApprox(Eigen::Vector3d(-0.1, 0, -0.1)));
    CHECK(box.max().isApprox(Eigen::Vector3d(0.1, 0.51, 0.1)));
}

TEST_CASE("a picture of a run that begins holds the places that its walls will move to") {
    const Eigen::AlignedBox3d box =
        box_of({"wall.floor.motion=[{kind=\"linear\", velocity_m_s=[0, -2, 0], stop_s=0.01}]"});
    CHECK(box.min().y() == about(-0.02));
}

} // namespace test_view_box
