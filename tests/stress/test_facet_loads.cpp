#include "about.h"
#include "run/specimens.h"
#include "stress/facet_loads.h"

#include <algorithm>
#include <cmath>

namespace test_facet_loads {

using namespace tumble;
using namespace tumble::stress;
using Eigen::Vector3d;
using test::about;
using test::recorded;
using test::specimen_of;

namespace {

scene::Scene loaded(const std::vector<scene::Override>& sets = {}) {
    auto scene = scene::load_scene_text(test::ball_on_prism, "ball-on-prism.toml", sets);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return std::move(*scene);
}

} // namespace

TEST_CASE("a ball that rests across an edge presses and shears a facet alike, and what facets bear is its weight") {
    // Gravity lies along the square's diagonal and the ball on the upright edge between +x and +z. Its contact's normal
    // is 45 degrees off either facet's: of its weight W the facet that is touched bears W / sqrt(2) along its own
    // normal and as much across it, though the contact shears with nothing.
    const scene::Scene scene =
        loaded({{"gravity_m_s2=[-6.9367175, 0, -6.9367175]"}, {"fill.0.position_m=[0.011177, 0.0225, 0.011177]"}});
    const solid::HexMesh& mesh = *specimen_of(scene).mesh;
    const run::PartLoads loads = recorded(scene, {.every = 0.3});
    const Vector3d weight = -test::weight_of_ball / std::sqrt(2.0) * Vector3d(1, 0, 1);
    Vector3d sum = Vector3d::Zero();
    double pressing = 0;
    const auto facets = facet_loads(loads.instants.back().pushes, FacetFinder(mesh));
    for (const auto& [facet, load] : facets) {
        const Vector3d normal = mesh.area_of(facet).normalized();
        CHECK(load.shearing.norm() == about(load.pressing, 1e-3));
        CHECK(std::abs(load.shearing.dot(normal)) < 1e-12);
        pressing += load.pressing;
        sum += load.shearing - load.pressing * normal;
    }
    CHECK(pressing == about(test::weight_of_ball / std::sqrt(2.0), 1e-3));
    CHECK((sum - weight).norm() < 1e-3 * test::weight_of_ball);
    for (const observe::WallPush& push : loads.instants.back().pushes)
        CHECK(push.shearing().norm() < 1e-3 * push.pressing());
    const std::string csv = facets_csv(loads, mesh);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + static_cast<std::ptrdiff_t>(facets.size()));
}

TEST_CASE("a contact at an edge counts for the facet that faces the body, whichever triangle it was found on") {
    // At the upper edge of +x, 20 degrees above the horizon: with F along its normal it presses +x with F cos 20 and
    // shears it with F sin 20, though it was found on a triangle of the upper end. On a face it stays where it is.
    const scene::Scene scene = loaded();
    const solid::HexMesh& mesh = *specimen_of(scene).mesh;
    const FacetFinder finder(mesh);
    const double lean = std::acos(-1.0) / 9;
    const auto triangle_beneath = [&](const char* side, const Vector3d& foot) {
        const auto& facets = mesh.facet_sets.at(side);
        return 2 * *std::min_element(facets.begin(), facets.end(), [&](int one, int other) {
                   return (mesh.centre_of(one) - foot).norm() < (mesh.centre_of(other) - foot).norm();
               });
    };
    observe::WallPush push;
    push.foot = Vector3d(0.0075, 0.05, 0.0005);
    push.normal = Vector3d(std::cos(lean), std::sin(lean), 0);
    push.force = -2 * push.normal;
    for (const char* found_on : {"top", "+x"}) {
        CAPTURE(found_on);
        push.triangle = triangle_beneath(found_on, push.foot);
        const auto facets = facet_loads({push}, finder);
        REQUIRE(facets.size() == 1);
        CHECK(mesh.area_of(facets.begin()->first).normalized().x() == about(1, 1e-12));
        CHECK(facets.begin()->second.pressing == about(2 * std::cos(lean), 1e-12));
        CHECK((facets.begin()->second.shearing - Vector3d(0, -2 * std::sin(lean), 0)).norm() < 1e-12);
    }
    push.normal = Vector3d::UnitY();
    push.triangle = triangle_beneath("top", push.foot);
    CHECK(finder.facet_of(push) == push.triangle / 2);
}

} // namespace test_facet_loads
