#include "about.h"
#include "fit/union_moments.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace test_reductions {

using namespace tumble;
using namespace tumble::scene;
using tumble::test::about;

namespace {

const std::filesystem::path scenes = TUMBLE_ROOT "/scenes";

Scene loaded(const char* name, const std::vector<Override>& sets = {}) {
    const auto scene = load_scene(scenes / name, sets);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return *scene;
}

std::string refusal(const char* name, const std::vector<Override>& sets) {
    return to_string(load_scene(scenes / name, sets).problems());
}

double mass_of(const Scene& scene, std::size_t body) {
    const BodyTemplate& b = scene.bodies[body];
    return b.mass
               ? *b.mass
               : scene.materials[static_cast<std::size_t>(b.material)].density * fit::union_moments(b.spheres).volume;
}

} // namespace

TEST_CASE("reductions that do nothing leave every bit of a scene") {
    for (const char* name : {"trough-quick.toml", "bowl-quick.toml"})
        CHECK(to_toml(loaded(name,
                             {{"reduce.softening=1"}, {"reduce.size=1"}, {"reduce.slice=1"}, {"reduce.spheres=0"}})) ==
              to_toml(loaded(name)));
    CHECK(to_toml(loaded("trough-quick.toml", {{"reduce.spheres=65"}})) == to_toml(loaded("trough-quick.toml")));
}

TEST_CASE("a reduced scene loads again from its resolved text to the same values") {
    const Scene scene =
        loaded("trough-quick.toml", {{"reduce.softening=3"}, {"reduce.spheres=20"}, {"reduce.size=1.3"}});
    const std::string text = to_toml(scene);
    const auto again = load_scene_text(text, "/nowhere/resolved.toml");
    REQUIRE_MESSAGE(again, to_string(again.problems()));
    CHECK(to_toml(*again) == text);
}

TEST_CASE("softening by 2^(5/2) makes the step twice as long, as Hertz' impact lasts as E^-2/5") {
    const double factor = 5.656854249492380;
    const Scene stiff = loaded("trough-slice.toml");
    const Scene soft = loaded("trough-slice.toml", {{"reduce.softening=5.656854249492380"}});
    for (std::size_t i = 0; i < stiff.materials.size(); ++i)
        CHECK(soft.materials[i].youngs_modulus == about(stiff.materials[i].youngs_modulus / factor, 1e-15));
    CHECK(soft.time_step == about(2 * stiff.time_step, 1e-12));
    CHECK(soft.fills[0].count == stiff.fills[0].count);
}

TEST_CASE(
    "softening keeps the speed of Thornton and Ning below which bodies stick, at the price of the pull-off force") {
    // v_s goes as (w^5 R^4 / E^2)^(1/6), the pull-off force as w: 32 times as soft, w over 32^(2/5) = 4.
    const std::vector<Override> sticky{{"contact.adhesion=\"jkr\""}, {"pair.media-lining.work_of_adhesion_J_m2=0.3"}};
    std::vector<Override> softened = sticky;
    softened.push_back({"reduce.softening=32"});
    softened.push_back({"material.lining.allow_soft=true"});
    const Scene stiff = loaded("trough-slice.toml", sticky), soft = loaded("trough-slice.toml", softened);
    const double before = stiff.pair(0, 1).work_of_adhesion, now = soft.pair(0, 1).work_of_adhesion;
    CHECK(before == 0.3);
    CHECK(now == about(before / 4, 1e-12));
    const double E_before = stiff.materials[0].youngs_modulus, E_now = soft.materials[0].youngs_modulus;
    CHECK(std::pow(now, 5) / (E_now * E_now) == about(std::pow(before, 5) / (E_before * E_before), 1e-12));
    CHECK(
        refusal("trough-slice.toml",
                {{"contact.adhesion=\"sjkr\""}, {"pair.media-lining.cohesion_energy_J_m3=1e4"}, {"reduce.softening=2"}})
            .find("would pull harder by as much") != std::string::npos);
}

TEST_CASE("softening a linear law by 4 makes the step twice as long, as a mass on a spring swings") {
    const Scene stiff = loaded("trough-2d.toml"), soft = loaded("trough-2d.toml", {{"reduce.softening=4"}});
    CHECK(soft.pair(0, 0).normal_stiffness == about(stiff.pair(0, 0).normal_stiffness / 4, 1e-15));
    CHECK(soft.time_step == about(2 * stiff.time_step, 1e-12));
}

TEST_CASE("bodies twice as long are eight times fewer and eight times as heavy; a single sensor stays itself") {
    const Scene fine = loaded("bowl.toml"), coarse = loaded("bowl.toml", {{"reduce.size=2"}});
    CHECK(*coarse.fills[0].count == 1782); // 14259 / 8 = 1782.4
    CHECK(mass_of(coarse, 0) == about(8 * mass_of(fine, 0), 1e-7));
    CHECK(coarse.bodies[0].spheres[3].radius == 2 * fine.bodies[0].spheres[3].radius);
    CHECK(coarse.time_step == 2 * fine.time_step);
    CHECK(*coarse.fills[1].count == 1);
    CHECK(*coarse.bodies[1].mass == *fine.bodies[1].mass);
    CHECK(coarse.bodies[1].spheres[0].radius == fine.bodies[1].spheres[0].radius);
}

TEST_CASE("discs twice as wide are four times fewer, and their springs, per length of disc, stay") {
    const Scene fine = loaded("trough-2d.toml"), coarse = loaded("trough-2d.toml", {{"reduce.size=2"}});
    CHECK(*coarse.fills[0].count == 63); // 250 / 4 = 62.5
    CHECK(coarse.pair(0, 1).normal_stiffness == fine.pair(0, 1).normal_stiffness);
    CHECK(coarse.bodies[0].spheres[0].radius == 2 * fine.bodies[0].spheres[0].radius);
}

TEST_CASE("a cone of fewer spheres has as many as asked for, its volume and nearly its moments of inertia") {
    const Scene many = loaded("trough-quick.toml"), few = loaded("trough-quick.toml", {{"reduce.spheres=20"}});
    CHECK(few.bodies[0].spheres.size() == 20);
    const fit::UnionMoments before = fit::union_moments(many.bodies[0].spheres);
    const fit::UnionMoments after = fit::union_moments(few.bodies[0].spheres);
    CHECK(after.volume == about(before.volume, 1e-6));
    // `tumble fit` with 20 spheres: a moment of inertia 5.9 % smaller about the axis, the least, and two 8.7 % larger
    // across it (docs/reduced-order.md), to the digits of that page; across it a clump need not be quite round.
    const auto moments = [](const fit::UnionMoments& of) {
        const Eigen::Matrix3d inertia = of.second.trace() * Eigen::Matrix3d::Identity() - of.second;
        const Eigen::Vector3d sorted = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
        return Eigen::Vector2d(sorted[0], (sorted[1] + sorted[2]) / 2);
    };
    CHECK(std::abs(moments(after)[0] / moments(before)[0] - 0.941) < 0.001);
    CHECK(std::abs(moments(after)[1] / moments(before)[1] - 1.087) < 0.001);
    CHECK(few.time_step == many.time_step);
}

TEST_CASE("half a slice is the middle half of the domain, the trough and the fills, with half the bodies") {
    const Scene whole = loaded("trough-slice.toml"), half = loaded("trough-slice.toml", {{"reduce.slice=0.5"}});
    CHECK(half.domain.box.lo.x() == about(-0.025, 1e-12));
    CHECK(half.domain.box.hi.x() == about(0.025, 1e-12));
    CHECK(half.domain.box.hi.z() == whole.domain.box.hi.z());
    CHECK(*half.fills[0].count == 2439);
    CHECK(half.fills[0].region.lo.x() == about(-0.025, 1e-12));
    CHECK(std::get<TroughShape>(half.walls[0].shape).x_hi == about(0.025, 1e-12));
    CHECK(half.time_step == whole.time_step);
}

TEST_CASE("reductions that a scene cannot take are refused with the reason") {
    CHECK(refusal("bowl.toml", {{"reduce.slice=0.5"}}) ==
          "--set reduce.slice: a slice is cut along the one periodic direction, and the domain has none\n"
          "    leave it at 1\n");
    CHECK(refusal("drop.toml", {{"reduce.size=2"}}).find("there is nothing to enlarge") != std::string::npos);
    CHECK(refusal("drop.toml", {{"reduce.spheres=9"}}).find("no body says which cone") != std::string::npos);
    CHECK(refusal("trough-quick.toml", {{"reduce.spheres=5"}}).find("5 spheres are too few for a cone") !=
          std::string::npos);
    CHECK(refusal("trough-quick.toml", {{"reduce.softening=50"}}).find("softer than rubber") != std::string::npos);
    CHECK(refusal("trough-quick.toml", {{"reduce.size=2"}, {"air.density_kg_m3=1.2"}}).find("[air]") !=
          std::string::npos);
    CHECK(refusal("trough-quick.toml", {{"body.cone.cone_diameter_m=0.010"}, {"reduce.spheres=20"}})
              .find("do not stand for its cone") != std::string::npos);
    CHECK(refusal("trough-quick.toml", {{"domain.periodic=[]"}, {"reduce.slice=0.5"}}).find("has none") !=
          std::string::npos);
}

} // namespace test_reductions
