#include "about.h"
#include "base/text.h"
#include "fem/cauchy.h"
#include "folder.h"
#include "run/specimens.h"
#include "sheet/show.h"
#include "solid/facet_load.h"
#include "solid/inp.h"
#include "stress/edges.h"
#include "stress/recorded.h"
#include "stress/study.h"
#include "stress/study_sheet.h"
#include "stress/trim.h"
#include "studies.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace test_study {

using namespace tumble;
using namespace tumble::stress;
using Eigen::Vector3d;
using test::about;
using test::figure_of;
using test::has;
using test::loaded;
using test::said;
using test::specimen_of;
using test::squeezed;
using test::studied;

TEST_CASE("a ball's weight goes through the part into its support, and the books of every case close") {
    const scene::Scene scene = loaded();
    const Study study = studied(scene, test::recorded(scene, {.every = 0.02}), {.sides = {"+x"}, .threads = 2});
    REQUIRE(study.cases.size() == 15);
    for (const Case& now : study.cases) {
        CHECK(now.unbalance < 1e-10);
        CHECK(now.residual < 1e-9);
        CHECK((now.force + now.support_force).norm() < 1e-9 * (now.force.norm() + 1));
    }
    const Case& last = study.cases.back();
    CHECK(last.support_force.y() == about(test::weight_of_ball, 1e-4));
    REQUIRE(last.strongest);
    CHECK(last.strongest->normal == about(test::weight_of_ball, 1e-4));
    // It lies at x = 3 mm, where bricks are 4.8 / 2 mm wide, and at z = 2 mm, where they are 5.4 / 4 mm wide.
    CHECK(last.facet_normal == about(test::weight_of_ball / (0.0024 * 0.00135), 1e-4));
    // A prism of 50 x 15 x 15 mm has 34.5 cm2, one held end included.
    CHECK(last.surface_normal == about(test::weight_of_ball / (4 * 0.05 * 0.015 + 2 * 0.015 * 0.015), 1e-4));
    CHECK(last.surface_shear < 0.01 * last.surface_normal);
    CHECK(study.slices.size() == 3);
    CHECK(study.warnings.empty());
}

TEST_CASE("a part squeezed from all sides is compressed throughout, as much as it is squeezed") {
    // Far from the held end a pressure p on all sides is sigma_x = sigma_z = -p inside, whatever the depth, and no
    // shear. At the held end, one of 11 rings of nodes, the part cannot shrink sideways and is stretched there.
    const scene::Scene scene = loaded();
    const Study study = studied(scene, squeezed(specimen_of(scene), 1e6, 2));
    REQUIRE(study.slices.size() == 12); // four sides, three depths
    for (const fem::SliceFigures& figures : study.cases[1].slices) {
        CHECK(figures.mean_compression == about(-1e6, 0.05));
        CHECK(figures.stretched <= 9); // those of the held ring of nodes, 9 to a side
        CHECK(figures.compressive_share() > 0.9);
        CHECK(figures.contour < 0.1e6);
    }
    const sheet::Sheet sheet = sheet_of(study, {});
    CHECK(sheet.fact("cases") == 2);
    CHECK(sheet.fact("near_edges_+x_1mm") == about(study.cases[0].slices[4].near_edges));
    CHECK(sheet.fact("normal_+x_1mm") == about(std::abs(study.cases[0].slices[4].normal)));
    CHECK(sheet.fact("normal_error_+x_1mm") == 0); // both cases are the same
    CHECK(sheet::to_text("squeezed", sheet).find("Decay with depth") != std::string::npos);
}

TEST_CASE("a part that gives way visibly is warned about with the number") {
    const scene::Scene soft = loaded({{"wall.part.part_youngs_modulus_Pa=1e6"}});
    const Study study = studied(soft, squeezed(specimen_of(soft), 1e5, 1));
    REQUIRE(study.warnings.size() == 1);
    CHECK(study.warnings[0].find("of the smallest sphere's radius") != std::string::npos);
    // A tenth of strain over half a side of 7.5 mm and more.
    CHECK(study.cases[0].deflection > 0.0005);
}

TEST_CASE("a cantilever is warned about from where beam theory has it give way by a hundredth of the smallest sphere") {
    // F L^3 / (3 E I) + F L / (5/6 G A): of 50 x 15 x 15 mm and 100 MPa, 9.87e-5 and 0.69e-5 m a newton. The sphere has
    // 5 mm, a hundredth is 5e-5 m.
    const scene::Scene soft = loaded({{"wall.part.part_youngs_modulus_Pa=1e8"}});
    const solid::HexMesh& mesh = *specimen_of(soft).mesh;
    for (const double force : {0.4, 1.0}) {
        CAPTURE(force);
        run::PartLoads loads;
        loads.instants.push_back({0.1, {}});
        for (const int facet : mesh.facet_sets.at("top")) {
            observe::WallPush push;
            push.triangle = 2 * facet;
            push.foot = mesh.centre_of(facet);
            push.normal = Vector3d::UnitY();
            push.force = Vector3d(force * mesh.area_of(facet).norm() / (0.015 * 0.015), 0, 0);
            loads.instants[0].pushes.push_back(push);
        }
        const Study study = studied(soft, loads);
        CHECK(study.cases[0].deflection == about(force * 1.056e-4, 0.03));
        REQUIRE(study.warnings.size() == (force > 0.5 ? 1u : 0u));
        if (force > 0.5)
            CHECK(study.warnings[0].starts_with(fmt::format(
                "the part gives way by {:.3g} m, 0.021 of the smallest sphere's radius", study.cases[0].deflection)));
    }
}

TEST_CASE("a part of a file with curved facets is run and solved, and its file is kept with the loads") {
    // The prism's layers as y (1 - k (x z)^2), lower at the four edges: on its upper end no facet is flat, where the
    // ball lies (between 2.7 and 5.1 mm, and 0 and 2.7 mm) by 9 micrometres.
    const test::Folder folder;
    solid::HexMesh mesh = *solid::mesh_of(
        solid::Prism{
            .length = 0.05, .side = 0.015, .corner = 0.0048, .corner_cells = 2, .middle_cells = 2, .along = 10},
        {});
    for (Vector3d& node : mesh.nodes)
        node.y() *= 1 - 1.26e6 * std::pow(node.x() * node.z(), 2);
    const std::string written = solid::to_inp(mesh, {2e11, 0.3, "C3D8", {}}, {});
    test::put(folder.path / "part.inp", written);
    std::string text = test::ball_on_prism;
    const auto from = text.find("shape = \"prism\""), to = text.find("material = \"glass\"\n[observe]");
    text.replace(from, to - from,
                 "shape = \"hexahedra\"\ninp = \"" + (folder.path / "part.inp").string() +
                     "\"\naxis = [0, 1, 0]\nheld_set = \"base\"\n");
    auto scene = scene::load_scene_text(text, "ball-on-part.toml", {{"duration_s=0.1"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    auto recorded = specimen_in(std::move(*scene), "");
    REQUIRE(recorded);
    recorded->loads = test::recorded(recorded->scene, {.every = 0.01, .folder = folder.path / "kept"});
    REQUIRE(write_recorded(*recorded, folder.path / "kept"));
    const Study study = studied(recorded->scene, recorded->loads);
    double pressed = 0;
    for (const Case& now : study.cases) {
        CHECK(now.unbalance < 1e-10);
        CHECK((now.force + now.support_force).norm() < 1e-9 * (now.force.norm() + 1));
        pressed = std::max(pressed, -now.force.y());
    }
    CHECK(pressed > 0.5 * test::weight_of_ball);

    std::filesystem::remove(folder.path / "part.inp");
    CHECK(test::content_of(folder.path / "kept/meshes/0.inp") == written);
    const auto again = read_recorded(folder.path / "kept", "");
    REQUIRE_MESSAGE(again, to_string(again.problems()));
    CHECK(again->specimen().mesh->nodes.size() == mesh.nodes.size());
    CHECK(again->loads.instants.size() == recorded->loads.instants.size());
    CHECK(read_remeshed(folder.path / "kept", "", {"scale=2"})
              .problems()
              .at(0)
              .what.starts_with("--remesh makes it another part: 30 x 100 x 30 mm in place of 15 x 50 x 15 mm"));
}

TEST_CASE("the mean of what lies still is its instant: spread over the same patch, with the same stress beneath") {
    // The ball lies at x = 3 mm, z = 2 mm of the upper end from 0.1 s on. Its mean lies on the lattice's points about
    // its foot, no more than half a patch of a tenth of a millimetre away, so that beneath the sides, 4 mm and further
    // off, stresses differ by the square of that over the distance.
    const scene::Scene scene = loaded();
    const run::PartLoads loads = test::recorded(scene, {.every = 0.1});
    StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    const Study instants = studied(scene, loads, options);
    options.means = true;
    const Study means = studied(scene, loads, options);
    REQUIRE(means.cases.size() == 3);
    CHECK(means.patch > 0);
    CHECK(means.patch < 0.0005);
    CHECK(means.patch == about(instants.patch, 0.2)); // the first window has the impact, the first instant not
    const Case &mean = means.cases[2], &instant = instants.cases[2];
    CHECK((mean.force - instant.force).norm() < 1e-4 * test::weight_of_ball);
    CHECK(mean.deflection == about(instant.deflection, 0.02));
    CHECK(mean.slices[0].compression == about(instant.slices[0].compression, 0.02));
    CHECK(mean.slices[0].tension == about(instant.slices[0].tension, 0.02));
}

TEST_CASE("the worst case is named with its instant, node and contact, and what slices do not lie beneath") {
    // The ball lies at x = 3 mm, z = 2 mm of the upper end, of which the facet is 2.4 x 1.35 mm large.
    const scene::Scene scene = loaded();
    const run::PartLoads loads = test::recorded(scene, {.every = 0.1});
    const Study study = studied(scene, loads, {.depths = {0.001}, .sides = {"+x"}});
    const Case& worst = study.cases[study.worst.index];
    const auto node = static_cast<std::size_t>(study.worst_node - 1);
    CHECK(study.worst_place == specimen_of(scene).mesh->nodes[node]);
    CHECK(worst.von_mises == fem::von_mises(study.worst.stress.segment<6>(6 * static_cast<Eigen::Index>(node))));
    REQUIRE(worst.strongest);
    const solid::HexMesh& mesh = *specimen_of(scene).mesh;
    const auto named = std::find_if(mesh.facets.begin(), mesh.facets.end(), [&](const solid::Facet& facet) {
        return mesh.hex_numbers[static_cast<std::size_t>(facet.hex)] == worst.strongest->element &&
               facet.face + 1 == worst.strongest->face;
    });
    REQUIRE(named != mesh.facets.end());
    const Vector3d off = mesh.centre_of(static_cast<int>(named - mesh.facets.begin())) - Vector3d(0.003, 0.05, 0.002);
    CHECK(std::abs(off.x()) < 0.0012);
    CHECK(std::abs(off.y()) < 1e-12);
    CHECK(std::abs(off.z()) < 0.000675);
    const std::string text = said(study);
    CHECK(has(text, fmt::format("at {:.6g} s, at node {}, (", worst.time, study.worst_node)));
    CHECK(has(text, fmt::format("body 0's, on face {} of element {} at (3, 50, 2) mm", worst.strongest->face,
                                worst.strongest->element)));
    CHECK(has(text, "Slices lie beneath '+x', where 0 % of the contacts' force acts. Most of it, 100 %, acts on 'top': "
                    "`--side top` looks beneath that."));

    // Beneath the end that it lies on: compression, and the most of it beneath the ball.
    const Study beneath = studied(scene, loads, {.depths = {0.001}, .sides = {"top"}});
    CHECK(beneath.pressed.at("top") == about(1));
    CHECK_FALSE(has(said(beneath), "`--side"));
    const fem::SliceFigures& figures = beneath.cases.back().slices[0];
    CHECK(figures.normal < 0);
    const Vector3d place = beneath.slices[0].points[static_cast<std::size_t>(figures.worst_point)].place;
    CHECK(place.y() == about(0.049, 1e-9));
    CHECK((place - Vector3d(0.003, 0.049, 0.002)).norm() < 0.0024);
}

TEST_CASE("a slice that keeps no point of the part's lower share is refused before anything is solved") {
    // The upper end lies at the height 1, all of it; the lower end at 0.
    const scene::SpecimenShape specimen = specimen_of(loaded());
    const StudyOptions top{.sides = {"top"}, .counting = {.lower = 0.5}};
    CHECK(slices_of(specimen, top).problems().at(0).what ==
          "beneath side 'top' no point lies in the lower 0.5 of the part's length (--lower)");
    CHECK(slices_of(specimen, {.sides = {"top"}}));
    CHECK(slices_of(specimen, {.sides = {"base"}, .counting = {.lower = 0.5}}));
}

TEST_CASE("what is solved has force and moment of the contacts, whatever they are spread over, or is refused") {
    // At 45 degrees to the edge between +x and +z, sheared by 0.34 of what presses; and on the face of +x.
    const scene::SpecimenShape specimen = specimen_of(loaded());
    const solid::HexMesh& mesh = *specimen.mesh;
    run::PartLoads loads;
    loads.instants.push_back({0.1, {}});
    for (const auto& [foot, normal] : {std::pair{Vector3d(0.0075, 0.0225, 0.0075), Vector3d(1, 0, 1).normalized()},
                                       std::pair{Vector3d(0.0075, 0.02, 0.001), Vector3d(Vector3d::UnitX())}}) {
        const auto placed =
            solid::moved_to(mesh, {0, foot, -3 * normal + 1.02 * Vector3d(1, 0, -1).normalized()}, normal);
        REQUIRE(placed);
        observe::WallPush push;
        push.triangle = 2 * placed->facet;
        push.foot = foot;
        push.normal = normal;
        push.force = placed->force;
        push.patch = 0.0008;
        loads.instants[0].pushes.push_back(push);
    }
    Crew crew(1);
    const auto cases = nodal_cases(specimen, loads, false, 1, crew);
    REQUIRE_MESSAGE(cases, to_string(cases.problems()));
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vector3d load = cases->at(0).col(static_cast<Eigen::Index>(n));
        force += load;
        moment += mesh.nodes[n].cross(load);
    }
    for (const observe::WallPush& push : loads.instants[0].pushes) {
        force -= push.force;
        moment -= push.foot.cross(push.force);
    }
    CHECK(force.norm() < 1e-13);
    CHECK(moment.norm() < 1e-14);
    loads.instants[0].pushes[1].foot.x() += 0.0001; // off the part, as a point
    loads.instants[0].pushes[1].patch = 0;
    const auto off = nodal_cases(specimen, loads, false, 1, crew);
    REQUIRE_FALSE(off);
    CHECK(off.problems().at(0).what.starts_with("load case at 0.1 s: "));
}

TEST_CASE("means are over all instants, and how many of them have contacts is said") {
    const scene::Scene scene = loaded();
    run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 1);
    const auto contacts = static_cast<double>(loads.instants[0].pushes.size());
    loads.instants.push_back({0.1, {}});
    const StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    const Study study = studied(scene, loads, options);
    const sheet::Sheet sheet = sheet_of(study, options);
    CHECK(sheet.fact("contacts") == contacts / 2);
    CHECK(sheet.fact("touched_instants") == 1);
    CHECK(sheet.fact("facet_normal") == about(0.5e6)); // 1 MPa on every facet, and nothing
    const std::string text = said(study, options);
    CHECK(has(text, fmt::format("touches the part at 1 of 2 instants; in the mean of all of them {:.3g} places do",
                                contacts / 2)));
    CHECK(has(text, "At 1 of the 1 instants with contacts the largest normal stress"));
    CHECK(has(text, "Means over all 2 cases of the largest stress of each slice"));
}

TEST_CASE("force over a facet's area is warned about where facets and patches differ, with the number") {
    const scene::Scene scene = loaded();
    const auto with_patches = [&](double patch) {
        run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 1);
        for (observe::WallPush& push : loads.instants[0].pushes)
            push.patch = patch;
        return studied(scene, loads, {.depths = {0.001}, .sides = {"+x"}});
    };
    // Facets are 5 mm long, and 2.4 mm wide on 9.6 of a side's 15 mm, else 1.35 mm; equal pressure weighs them by area.
    const double width = 0.64 * std::sqrt(5 * 2.4) + 0.36 * std::sqrt(5 * 1.35); // mm
    // Of 9.9 mm2; a circle of 4 mm radius has 50 mm2, one of 1.6 mm 8 mm2, one of 0.3 mm 0.28 mm2.
    const std::string wide = said(with_patches(0.004)), alike = said(with_patches(0.0016)),
                      narrow = said(with_patches(0.0003));
    CHECK(has(wide, "Warning: facets are narrower than the circles"));
    CHECK_FALSE(has(alike, "Warning: facets"));
    CHECK(has(narrow, fmt::format("Warning: facets have {:.3g} times the area of the circles",
                                  width * width / (std::acos(-1.0) * 0.09))));
    const Study study = with_patches(0.004);
    CHECK(sheet_of(study, {}).fact("facet_areas_a_patch") == about(std::acos(-1.0) * 16 / (width * width), 1e-6));
}

TEST_CASE("of twelve slices the shallowest of each side are drawn, of three all") {
    const scene::Scene scene = loaded();
    const run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 1);
    const auto labels = [&](const Study& study) {
        std::vector<std::string> found;
        const sheet::Sheet sheet = sheet_of(study, {});
        for (const sheet::Curve& curve : figure_of(sheet, "normal-stress").curves)
            found.push_back(curve.label);
        return found;
    };
    CHECK(labels(studied(scene, loads)) ==
          std::vector<std::string>{"-x, 0.5 mm", "+x, 0.5 mm", "-z, 0.5 mm", "+z, 0.5 mm"});
    CHECK(labels(studied(scene, loads, {.sides = {"+x"}})) ==
          std::vector<std::string>{"+x, 0.5 mm", "+x, 1 mm", "+x, 1.5 mm"});
}

TEST_CASE("touches are drawn at their peaks, and not at all where the peaks' times were not kept") {
    const scene::Scene scene = loaded();
    run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 1);
    observe::Touching touch;
    touch.begin = 0.1;
    touch.duration = 0.02;
    touch.peak_normal = 5;
    touch.peak_shear = 1;
    touch.peak_normal_time = 0.108;
    touch.peak_shear_time = 0.113;
    loads.touches = {touch};
    const sheet::Sheet sheet = sheet_of(studied(scene, loads), {});
    const auto& curves = figure_of(sheet, "impact").curves;
    CHECK(curves[0].x == std::vector<double>{0.108});
    CHECK(curves[1].x == std::vector<double>{0.113});
    loads.touches[0].peak_normal_time = std::numeric_limits<double>::quiet_NaN();
    const sheet::Sheet older = sheet_of(studied(scene, loads), {});
    for (const sheet::Figure* figure : older.figures())
        CHECK(figure->name != "impact");
    CHECK(sheet::to_text("", older).find("There is no impact.png") != std::string::npos);
}

TEST_CASE("settings of two studies are told apart line by line") {
    const scene::Scene scene = loaded();
    const std::string one = settings_of(specimen_of(scene), {}),
                      other =
                          settings_of(specimen_of(scene),
                                      {.formulation = fem::Formulation::standard, .depths = {0.00025}, .means = true});
    CHECK(what_differs(one, one).empty());
    CHECK(what_differs(one, other) == "loads = instants, now means; element = incompatible, now standard; depths_mm = "
                                      "0.5, 1, 1.5, now 0.25");
}

TEST_CASE("threads change no bit of what is laid on and solved") {
    const scene::Scene scene = loaded();
    run::PartLoads loads = squeezed(specimen_of(scene), 1e6, 3);
    for (run::LoadInstant& instant : loads.instants)
        for (observe::WallPush& push : instant.pushes)
            push.patch = 0.001;
    const Study one = studied(scene, loads, {.sides = {"+x"}, .threads = 1}),
                two = studied(scene, loads, {.sides = {"+x"}, .threads = 2});
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK(one.cases[c].von_mises == two.cases[c].von_mises);
        CHECK(one.cases[c].force == two.cases[c].force);
        CHECK(one.cases[c].slices[1].normal == two.cases[c].slices[1].normal);
    }
}

TEST_CASE("the means are solved as well, and what is written can be read") {
    const test::Folder folder;
    const scene::Scene scene = loaded();
    const run::PartLoads loads = test::recorded(scene, {.every = 0.1});
    const Study study = studied(scene, loads, {.depths = {0.001}, .sides = {"-z"}, .means = true});
    REQUIRE(study.cases.size() == 3);
    CHECK(study.cases[2].force.y() == about(-test::weight_of_ball, 1e-4));
    const auto files = write_study(study, specimen_of(scene), loads, folder.path);
    REQUIRE(files);
    CHECK(files->size() == 5);
    const auto cases = test::content_of(folder.path / "cases.csv"),
               slices = test::content_of(folder.path / "slices.csv");
    CHECK(std::count(cases.begin(), cases.end(), '\n') == 4);
    // What contacts alone tell is not known of a mean: their number, the strongest, and stresses of facets.
    const auto heads = split(split(cases, '\n')[0], ','), last = split(split(cases, '\n')[3], ',');
    REQUIRE(heads.size() == last.size());
    for (std::size_t k = 0; k < heads.size(); ++k) {
        const bool of_contacts = heads[k] == "contacts" || heads[k].starts_with("strongest") ||
                                 heads[k].starts_with("facet") || heads[k].starts_with("surface");
        CHECK_MESSAGE((last[k] == "nan") == of_contacts, std::string(heads[k]));
    }
    CHECK(study.cases[2].window == about(0.1, 1e-9));
    const sheet::Sheet sheet = sheet_of(study, {.means = true});
    CHECK(figure_of(sheet, "loads").title == "Force of the media on the part: mean loads of 100 ms");
    CHECK(sheet::to_text("", sheet).find("in the mean of the 100 ms before") != std::string::npos);
    CHECK(kept_settings(folder.path) == study.settings);
    // The part of run/ball_on_prism.h.
    CHECK(has(study.settings, "part = prism: length_m 0.05, side_m 0.015, corner_m 0.0048, corner_cells 2, "
                              "middle_cells 4, along 10\n"));
    CHECK(has(study.settings, "part_youngs_modulus_Pa = 2e+11\npart_poisson_ratio = 0.3\n"));
    CHECK(std::count(slices.begin(), slices.end(), '\n') == 4);
    CHECK(slices.find(",-z,0.001,") != std::string::npos);
    CHECK(stress::study(scene, specimen_of(scene), {}, {}).problems().at(0).what == "there is no load case");
}

} // namespace test_study
