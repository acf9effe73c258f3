#include "about.h"
#include "folder.h"
#include "run/specimens.h"
#include "stress/fields.h"
#include "stress/pictures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <map>
#include <numbers>

namespace test_pictures {

using namespace tumble;
using namespace tumble::stress;
using Eigen::Vector3d;
using test::about;

namespace {

/// From least to largest, along x and y.
Eigen::Vector2d extent(const render::Field& field) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : field.points)
        box.extend(point);
    return box.sizes().head<2>();
}

double area(const render::Field& field) {
    double sum = 0;
    for (const auto& triangle : field.triangles) {
        const auto at = [&](std::size_t k) { return field.points[static_cast<std::size_t>(triangle[k])]; };
        sum += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    }
    return sum;
}

/// An upright bar of 20 x 50 x 20 mm, 8 x 5 x 8 hexahedra, those columns that are `in`; facets by where they look.
solid::HexMesh bar_of(const std::function<bool(int, int)>& in) {
    constexpr int cells = 8, layers = 5;
    constexpr double cell = 0.0025, layer = 0.01; // m
    solid::HexMesh mesh;
    std::map<std::array<int, 3>, int> numbers;
    const auto node = [&](int i, int j, int k) {
        const auto [found, fresh] = numbers.try_emplace({i, j, k}, static_cast<int>(mesh.nodes.size()));
        if (fresh)
            mesh.nodes.emplace_back(cell * i, layer * j, cell * k);
        return found->second;
    };
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k)
            for (int j = 0; j < layers && in(i, k); ++j)
                mesh.hexes.push_back({node(i, j, k), node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j, k),
                                      node(i, j + 1, k), node(i, j + 1, k + 1), node(i + 1, j + 1, k + 1),
                                      node(i + 1, j + 1, k)});
    solid::HexMesh whole = *solid::finished(std::move(mesh));
    for (int f = 0; f < static_cast<int>(whole.facets.size()); ++f) {
        const double up = whole.area_of(f).normalized().y();
        whole.facet_sets[up > 0.9 ? "top" : up < -0.9 ? "base" : "side"].push_back(f);
    }
    return whole;
}

std::vector<double> zeros(const fem::Slice& slice) {
    return std::vector<double>(slice.points.size(), 0.0);
}

} // namespace

TEST_CASE("components of a stress are those of its tensor") {
    fem::Stress s;
    s << 3, -1, 2, 0, 0, 4; // xx yy zz xy yz zx: the zx block has eigenvalues 2.5 +- sqrt(0.25 + 16)
    const auto value = [&](const char* name) { return fem::find_component(name)->of(s); };
    CHECK(value("mean") == about(4.0 / 3, 1e-14));
    CHECK(value("tension") == about(2.5 + std::sqrt(16.25), 1e-12));
    CHECK(value("compression") == about(2.5 - std::sqrt(16.25), 1e-12));
    CHECK(value("zx") == 4);
    CHECK(value("von_mises") == about(std::sqrt(0.5 * (16 + 9 + 1) + 48), 1e-14));
    CHECK(fem::find_component("von_mizes").problems().at(0).fix.starts_with("did you mean 'von_mises'?"));
}

TEST_CASE("a slice all round a cylinder is rolled out to its circumference, whichever way it is cut open") {
    const solid::BoredCylinder part{.length = 0.1,
                                    .radius = 0.015,
                                    .bore_radius = 0.005,
                                    .shell = 0.0015,
                                    .around = 36,
                                    .along = 4,
                                    .shell_rings = 3,
                                    .inner_rings = 2};
    const solid::Place place{{0.1, 0.2, 0.3}, Vector3d(1, 2, 0.5).normalized()};
    const solid::HexMesh mesh = *solid::mesh_of(part, place);
    const solid::Locator locator(mesh);
    const auto slice = fem::slice_of(mesh, locator, "side", place.axis, 0.001);
    REQUIRE_MESSAGE(slice, to_string(slice.problems()));
    for (const Vector3d& ahead : {Vector3d(1, 0, 0), Vector3d(0, 1, 1), Vector3d(-0.3, 0.1, 2)}) {
        const render::Field field = unrolled_field(mesh, *slice, place.base, ahead, zeros(*slice));
        const double round = 2 * std::numbers::pi * 0.014;
        CHECK(extent(field).x() == about(round, 1e-9));
        CHECK(extent(field).y() == about(0.1, 1e-9));
        CHECK(area(field) == about(round * 0.1, 1e-9));
        CHECK(field.points.size() == 37 * 5); // the nodes of the cut twice
        CHECK(field.values.size() == field.points.size());
    }
}

TEST_CASE("a slice beneath a flat side keeps its shape") {
    const solid::Prism part{
        .length = 0.1, .side = 0.015, .corner = 0.004, .corner_cells = 2, .middle_cells = 2, .along = 5};
    const solid::HexMesh mesh = *solid::mesh_of(part, {});
    const auto slice = fem::slice_of(mesh, solid::Locator(mesh), "+x", Vector3d::UnitY(), 0.001);
    REQUIRE(slice);
    const render::Field field = unrolled_field(mesh, *slice, Vector3d::Zero(), Vector3d::UnitX(), zeros(*slice));
    CHECK(extent(field).x() == about(0.015, 1e-12));
    CHECK(area(field) == about(0.0015, 1e-12));
}

TEST_CASE("a side with corners is rolled out to its perimeter, facet beside facet, wherever the axis stands") {
    // A square of 20 mm has 80 mm about it. Without one of its quarters, an L of three squares of 10 mm, it has as
    // much: eight sides of such a square, two of them about an inner corner.
    for (const bool whole : {true, false}) {
        const solid::HexMesh mesh = bar_of([&](int i, int k) { return whole || i < 4 || k < 4; });
        const auto slice = fem::slice_of(mesh, solid::Locator(mesh), "side", Vector3d::UnitY(), 0.001);
        REQUIRE_MESSAGE(slice, to_string(slice.problems()));
        const std::vector<int>& side = mesh.facet_sets.at("side");
        for (const Vector3d& base : {Vector3d(0.01, 0, 0.01), Vector3d(0.003, 0, 0.004), Vector3d(0.1, 0, -0.3)})
            for (const Vector3d& ahead : {Vector3d(1, 0, 0), Vector3d(1, 0, 1), Vector3d(-0.3, 0, 0.7)}) {
                CAPTURE(whole);
                CAPTURE(base.x());
                CAPTURE(ahead.x());
                const render::Field field = unrolled_field(mesh, *slice, base, ahead, zeros(*slice));
                CHECK(extent(field).x() == about(0.08, 1e-9));
                CHECK(extent(field).y() == about(0.05, 1e-9));
                CHECK(field.points.size() == (32 + 1) * 6); // the nodes of the cut twice
                REQUIRE(field.triangles.size() == 2 * side.size());
                for (std::size_t f = 0; f < side.size(); ++f) {
                    render::Field one = field;
                    one.triangles = {field.triangles[2 * f], field.triangles[2 * f + 1]};
                    CHECK(area(one) == about(mesh.area_of(side[f]).norm(), 1e-9));
                }
            }
    }
}

TEST_CASE("rolled out, a side lies as it is seen from outside: anticlockwise outside, clockwise in a bore, all the "
          "same way") {
    // Values that are linear in place give each point's x and z back. To the right of who looks at a surface against
    // its normal n, y upwards, goes y x n: with (x, z) = r (cos f, -sin f) outside that is growing f, in a bore falling
    // f. An arc or chord of a 36th of the contour has r sin(10 degrees) across its middle, at most r 10 degrees.
    const solid::BoredCylinder part{.length = 0.1,
                                    .radius = 0.015,
                                    .bore_radius = 0.005,
                                    .shell = 0.0015,
                                    .around = 36,
                                    .along = 4,
                                    .shell_rings = 3,
                                    .inner_rings = 2};
    solid::HexMesh mesh = *solid::mesh_of(part, {});
    std::vector<int>& all = mesh.facet_sets["all"]; // in pieces; the other two are round
    for (const char* side : {"side", "bore"})
        all.insert(all.end(), mesh.facet_sets.at(side).begin(), mesh.facet_sets.at(side).end());
    for (const char* side : {"side", "bore", "all"}) {
        CAPTURE(side);
        const auto slice = fem::slice_of(mesh, solid::Locator(mesh), side, Vector3d::UnitY(), 0.0005);
        REQUIRE_MESSAGE(slice, to_string(slice.problems()));
        std::vector<double> x, z;
        for (const fem::SlicePoint& point : slice->points) {
            x.push_back(point.place.x());
            z.push_back(point.place.z());
        }
        const render::Field of_x = unrolled_field(mesh, *slice, Vector3d::Zero(), Vector3d::UnitX(), x),
                            of_z = unrolled_field(mesh, *slice, Vector3d::Zero(), Vector3d::UnitX(), z);
        int seen = 0;
        for (const auto& line : of_x.lines) {
            const auto a = static_cast<std::size_t>(line[0]), b = static_cast<std::size_t>(line[1]);
            const double right = of_x.points[b].x() - of_x.points[a].x();
            if (std::abs(right) < 1e-6)
                continue; // along the axis
            const double radius = std::hypot(of_x.values[a], of_z.values[a]);
            const double turned =
                of_z.values[a] * of_x.values[b] - of_x.values[a] * of_z.values[b]; // r^2 sin of the angle
            CHECK(turned / radius / right * (radius > 0.01 ? 1 : -1) == about(1, 0.11));
            ++seen;
        }
        CHECK(seen == (std::string(side) == "all" ? 2 : 1) * 36 * 5);
    }
}

TEST_CASE("a side in pieces, outside and bore, lies piece beside piece") {
    const solid::BoredCylinder part{.length = 0.1,
                                    .radius = 0.015,
                                    .bore_radius = 0.005,
                                    .shell = 0.0015,
                                    .around = 36,
                                    .along = 4,
                                    .shell_rings = 3,
                                    .inner_rings = 2};
    solid::HexMesh mesh = *solid::mesh_of(part, {});
    std::vector<int>& all = mesh.facet_sets["all"];
    for (const char* side : {"side", "bore"})
        all.insert(all.end(), mesh.facet_sets.at(side).begin(), mesh.facet_sets.at(side).end());
    const auto slice = fem::slice_of(mesh, solid::Locator(mesh), "all", Vector3d::UnitY(), 0.0005);
    REQUIRE_MESSAGE(slice, to_string(slice.problems()));
    const render::Field field = unrolled_field(mesh, *slice, Vector3d::Zero(), Vector3d::UnitX(), zeros(*slice));
    // Polygons of 36 sides, and a tenth of the first between them.
    const double chord = 2 * std::sin(std::numbers::pi / 36);
    CHECK(extent(field).x() == about(36 * chord * (0.015 * 1.1 + 0.005), 1e-9));
    CHECK(area(field) == about(36 * chord * (0.015 + 0.005) * 0.1, 1e-9));
}

TEST_CASE("a slice beneath an end is its outline, seen from outside") {
    const solid::Prism part{
        .length = 0.1, .side = 0.015, .corner = 0.004, .corner_cells = 2, .middle_cells = 2, .along = 5};
    const solid::HexMesh mesh = *solid::mesh_of(part, {});
    const auto slice = fem::slice_of(mesh, solid::Locator(mesh), "top", Vector3d::UnitY(), 0.001);
    REQUIRE_MESSAGE(slice, to_string(slice.problems()));
    std::vector<double> values;
    for (const fem::SlicePoint& point : slice->points)
        values.push_back(2 * point.place.x() - 3 * point.place.z());
    const render::Field field = unrolled_field(mesh, *slice, Vector3d::Zero(), Vector3d::UnitX(), values);
    CHECK((extent(field) - Eigen::Vector2d(0.015, 0.015)).norm() < 1e-12);
    // x to the right, z towards who looks down: across the middle of the field, values are 2 x + 3 y but for a number.
    const Vector3d first = field.points[0];
    for (std::size_t p = 0; p < field.points.size(); ++p) {
        const Vector3d off = field.points[p] - first;
        CHECK(std::abs(field.values[p] - field.values[0] - 2 * off.x() - 3 * off.y()) < 1e-12);
    }
}

TEST_CASE("the same contacts on another mesh load the part and its support alike") {
    const test::Folder folder;
    auto recorded = specimen_in(scene::load_scene_text(test::ball_on_prism, "ball-on-prism.toml", {}).value(), "");
    REQUIRE(recorded);
    recorded->loads = test::recorded(recorded->scene, {.every = 0.1});
    REQUIRE(write_recorded(*recorded, folder.path));
    const auto finer = read_remeshed(folder.path, "", {"middle_cells=8", "along=20"});
    REQUIRE_MESSAGE(finer, to_string(finer.problems()));
    CHECK(finer->specimen().mesh->hexes.size() == 12 * 12 * 20);
    const StudyOptions options{.depths = {0.001}, .sides = {"+x"}};
    const auto coarse_study = stress::study(recorded->scene, recorded->specimen(), recorded->loads, options);
    const auto study = stress::study(finer->scene, finer->specimen(), finer->loads, options);
    REQUIRE_MESSAGE(study, to_string(study.problems()));
    REQUIRE(study->cases.size() == 3);
    Crew crew(1);
    const auto coarse_loads = nodal_cases(recorded->specimen(), recorded->loads, false, 1, crew);
    const auto finer_loads = nodal_cases(finer->specimen(), finer->loads, false, 1, crew);
    REQUIRE((coarse_loads && finer_loads));
    const auto moment = [](const solid::HexMesh& mesh, const Eigen::Matrix3Xd& forces) {
        Vector3d sum = Vector3d::Zero();
        for (Eigen::Index n = 0; n < forces.cols(); ++n)
            sum += mesh.nodes[static_cast<std::size_t>(n)].cross(Vector3d(forces.col(n)));
        return sum;
    };
    // The ball lies at x = 3 mm, z = 2 mm: its weight turns the part about z and x.
    const Vector3d turned = moment(*finer->specimen().mesh, (*finer_loads)[2]);
    CHECK(turned.z() == about(-0.003 * test::weight_of_ball, 0.01));
    CHECK(turned.x() == about(0.002 * test::weight_of_ball, 0.01));
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK((moment(*finer->specimen().mesh, (*finer_loads)[c]) -
               moment(*recorded->specimen().mesh, (*coarse_loads)[c]))
                  .norm() < 1e-14);
        CHECK((study->cases[c].force - coarse_study->cases[c].force).norm() < 1e-12);
        CHECK(study->cases[c].unbalance < 1e-10);
    }
    // What more than the mesh depends on, its place among it, is refused by name.
    for (const char* set :
         {"side_m=0.03", "side_m=0.015", "part_youngs_modulus_Pa=1e9", "held=base", "axis=[1, 0, 0]"}) {
        const auto other = read_remeshed(folder.path, "", {"along=20", set});
        REQUIRE_FALSE(other);
        const std::string key = std::string(set).substr(0, std::string(set).find('='));
        CHECK(other.problems().at(0).what == "--remesh " + key + " makes it another part");
    }
    CHECK(read_remeshed(folder.path, "", {"corner_m=0.004"}));
    CHECK(read_recorded(folder.path, "ball").problems().at(0).what.find("loads on 'part', not on 'ball'") !=
          std::string::npos);
    CHECK(read_remeshed(folder.path, "", {"corner_cell=3"}).problems().at(0).what.find("corner_cell") !=
          std::string::npos);
}

TEST_CASE("the pictures of a study: the part among its media, two cuts, every slice") {
    const test::Folder folder;
    auto scene = scene::load_scene_text(test::ball_on_prism, "ball-on-prism.toml", {});
    REQUIRE(scene);
    scene->render.width = 400;
    scene->render.height = 260;
    auto recorded = specimen_in(std::move(*scene), "");
    REQUIRE(recorded);
    recorded->frames = folder.path / "frames";
    recorded->loads = test::recorded(recorded->scene, {.every = 0.1, .folder = folder.path});
    CHECK(test::count_files(recorded->frames, ".tumble") == recorded->loads.instants.size() + 1); // and the layout
    const auto study = stress::study(recorded->scene, recorded->specimen(), recorded->loads,
                                     {.depths = {0.001}, .sides = {"+x", "-z"}});
    REQUIRE_MESSAGE(study, to_string(study.problems()));
    const auto files = draw_pictures(*recorded, *study, {.component = "yy"}, folder.path);
    REQUIRE_MESSAGE(files, to_string(files.problems()));
    std::vector<std::string> names;
    for (const auto& file : *files) {
        names.push_back(file.filename().string());
        const std::string bytes = test::content_of(file);
        REQUIRE(bytes.size() > 1000);
        CHECK(bytes.substr(1, 3) == "PNG");
        // IHDR: width and height, large end first.
        CHECK(static_cast<unsigned char>(bytes[18]) * 256 + static_cast<unsigned char>(bytes[19]) == 400);
        CHECK(static_cast<unsigned char>(bytes[22]) * 256 + static_cast<unsigned char>(bytes[23]) == 260);
    }
    CHECK(names == std::vector<std::string>{"part.png", "cut-along.png", "cut-across.png", "slice-+x-1mm.png",
                                            "slice--z-1mm.png"});
    CHECK(draw_pictures(*recorded, *study, {.component = "hardness"}, folder.path).problems().at(0).what ==
          "there is no stress component 'hardness'");
}

} // namespace test_pictures
