// What a study says of itself where its figures are not to be taken at their word.
#include "about.h"
#include "run/specimens.h"
#include "stress/edges.h"
#include "stress/recorded.h"
#include "stress/trim.h"
#include "studies.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace test_study_doubts {

using namespace tumble;
using namespace tumble::stress;
using Eigen::Vector3d;
using test::about;
using test::has;
using test::loaded;
using test::said;
using test::specimen_of;
using test::squeezed;
using test::studied;

TEST_CASE("edges are where sides and ends meet, not between the facets of a round side") {
    const Edges prism(*specimen_of(loaded()).mesh); // 50 x 15 x 15 mm, upright
    CHECK(prism.distance({0.0075, 0.025, 0}) == about(0.0075, 1e-9));
    CHECK(prism.distance({0.0075, 0.025, 0.0075}) < 1e-12);
    CHECK(prism.distance({0, 0.025, 0}) == about(0.0075 * std::sqrt(2.0), 1e-9));
    const solid::HexMesh cylinder = *solid::mesh_of(solid::BoredCylinder{.length = 0.1,
                                                                         .radius = 0.015,
                                                                         .bore_radius = 0.005,
                                                                         .shell = 0.0015,
                                                                         .around = 36,
                                                                         .along = 4,
                                                                         .shell_rings = 3,
                                                                         .inner_rings = 2},
                                                    {});
    const Edges round(cylinder);
    CHECK(round.distance({0.015, 0.03, 0}) == about(0.03, 1e-6)); // to the ring of the lower end
}

TEST_CASE("how far the worst node lies from an edge is said, and what is worst elsewhere") {
    // The ball lies at (3, 2) mm of the upper end, 4.5 mm from the nearest edge; the facet's corners at 2.7 and 5.1 mm,
    // 0 and 2.7 mm are 2.4 and 4.8 mm from it.
    const scene::Scene scene = loaded();
    const run::PartLoads loads = test::recorded(scene, {.every = 0.1});
    StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    options.counting.edge = 1e-4;
    const Study far = studied(scene, loads, options);
    REQUIRE(far.worst_edge > options.counting.edge);
    CHECK(far.worst_edge == about(Edges(*specimen_of(scene).mesh).distance(far.worst_place)));
    CHECK(has(said(far, options), fmt::format("lies {:.3g} mm from the part's nearest edge", 1e3 * far.worst_edge)));
    REQUIRE(far.away);
    CHECK(far.away->von_mises == far.cases[far.worst.index].von_mises);
    options.counting.edge = far.worst_edge + 1e-4;
    const Study near = studied(scene, loads, options);
    REQUIRE(near.away);
    CHECK(near.away->von_mises < far.away->von_mises);
    CHECK(Edges(*specimen_of(scene).mesh).distance(near.away->place) > options.counting.edge);
    CHECK(has(said(near, options),
              fmt::format("Farther from all edges the largest is {}, at", format_si(near.away->von_mises, "Pa", 3))));
    CHECK(has(said(near, options), fmt::format("at node {}, (", near.away->node)));
    options.counting.edge = 1; // m
    CHECK(has(said(studied(scene, loads, options), options), "No node lies farther from all edges."));
}

TEST_CASE("instants that missed the impacts are told with both numbers, and not where they saw them") {
    // It falls by 0.2 mm; its impact lasts a millisecond (Hertz: 2.87 (m^2 / (R E*^2 v))^(1/5) = 1.3 ms) and is above
    // its weight, which is all that instants 0.1 s apart see.
    const scene::Scene scene = loaded();
    const StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    const Study missed = studied(scene, test::recorded(scene, {.every = 0.1}), options);
    double peak = 0; // N
    for (const observe::Touching& touch : missed.impacts.hardest)
        peak = std::max(peak, touch.peak_normal);
    CHECK(peak > 2 * test::weight_of_ball);
    REQUIRE(missed.doubts.size() == 1);
    CHECK(missed.doubts[0].starts_with(
        fmt::format("touches' peaks reach {:.3g} N, the 3 instants saw at most {:.3g} N", peak, test::weight_of_ball)));
    CHECK(has(said(missed, options), "Warning: touches' peaks reach"));
    CHECK(has(said(missed, options), "The largest von Mises stress of the 3 instants is"));
    for (const sheet::Figure* figure : sheet_of(missed, options).figures())
        if (figure->name != "impact")
            for (const sheet::Curve& curve : figure->curves)
                CHECK(curve.style == sheet::Style::points);
    scene::Scene brief = scene;
    brief.duration = 0.05;
    CHECK(studied(brief, test::recorded(brief, {.every = 1e-4}), options).doubts.empty());
}

TEST_CASE("cases of before the media were in and the walls moved are told with what leaves them out") {
    scene::Scene scene = loaded();
    const run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 4); // 0, 0.1, 0.2, 0.3 s
    const StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    CHECK(studied(scene, loads, options).doubts.empty());
    CHECK(has(said(studied(scene, loads, options), options), "4 instants of the media, from 0 to 0.3 s, on"));
    scene.fills[0].until = 0.05;
    CHECK(studied(scene, loads, options).doubts ==
          std::vector<std::string>{"the cases begin at 0 s, before filling ends at 0.05 s, and all means count them: "
                                   "`--from 0.05` leaves them out"});
    scene.walls[0].motion.rotations.push_back({.active = {.start = 0.15}, .angular_velocity = 1});
    CHECK(studied(scene, loads, options).doubts ==
          std::vector<std::string>{"the cases begin at 0 s, before 'part' begins to move at 0.15 s, and all means "
                                   "count them: `--from 0.15` leaves them out"});
    auto recorded = specimen_in(scene, "");
    REQUIRE(recorded);
    recorded->loads = loads;
    REQUIRE(trim(*recorded, 0.15, 0.2));
    REQUIRE(recorded->loads.instants.size() == 1);
    CHECK(recorded->loads.instants[0].time == about(0.2));
    CHECK(recorded->first_frame == 2);
    CHECK(studied(scene, recorded->loads, options).doubts.empty());
    CHECK(has(trim(*recorded, 7, 8).problems().at(0).what, "no instant is left between 7 and 8 s"));
}

TEST_CASE("a slice ends at the first wall: neither in a bore nor behind it, and none is asked for twice") {
    // A wall of 10 mm about a bore of 10 mm: 12 mm beneath the side is the bore, 22 and 28 mm the wall behind it.
    scene::SpecimenShape specimen;
    specimen.mesh = std::make_shared<solid::HexMesh>(*solid::mesh_of(solid::BoredCylinder{.length = 0.1,
                                                                                          .radius = 0.015,
                                                                                          .bore_radius = 0.005,
                                                                                          .shell = 0.0015,
                                                                                          .around = 36,
                                                                                          .along = 4,
                                                                                          .shell_rings = 3,
                                                                                          .inner_rings = 2},
                                                                     {}));
    specimen.part = solid::BoredCylinder{};
    CHECK(slices_of(specimen, {.depths = {0.0005, 0.0095}}));
    CHECK(has(slices_of(specimen, {.depths = {0.012}}).problems().at(0).what, "the part ends"));
    for (const double depth : {0.022, 0.028}) {
        const auto slices = slices_of(specimen, {.depths = {depth}});
        REQUIRE_FALSE(slices);
        CHECK(has(slices.problems()[0].what, "lies behind a gap: the part's first wall ends 0.01"));
    }
    CHECK(slices_of(*std::get_if<scene::SpecimenShape>(&loaded().walls[0].shape), {.depths = {0.0149}}));
    CHECK(slices_of(specimen, {.depths = {0.001, 0.0005, 0.001}}).problems().at(0).what ==
          "a slice 1 mm beneath 'side' is asked for twice");
}

} // namespace test_study_doubts
