#include "about.h"
#include "scene/load.h"
#include "scene/written.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <numbers>

namespace test_load {

using namespace tumble;
using namespace tumble::scene;
using tumble::test::about;

namespace {

const std::filesystem::path scenes = TUMBLE_ROOT "/scenes";

/// A complete scene; tests add to it or set keys of it.
const std::string small = R"(
duration_s = 1
time_step_s = 1e-5
[domain]
lo_m = [-1, -1, -1]
hi_m = [1, 1, 1]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 5e10
poisson_ratio = 0.2
[pair.glass-glass]
restitution = 0.9
friction = 0.4
[body.bead]
radius_mm = 2
material = "glass"
)";

Result<Scene> load(const std::string& more, const std::vector<Override>& sets = {}) {
    return load_scene_text(small + more, std::filesystem::path(TUMBLE_ROOT "/tests/scene/data/small.toml"), sets);
}

} // namespace

TEST_CASE("the drop scene loads in SI units with its defaults filled in") {
    const auto scene = load_scene(scenes / "drop.toml");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->bodies.at(0).spheres.at(0).radius == about(0.01275, 1e-15));
    CHECK(scene->materials.at(0).youngs_modulus == 4.6e8);
    CHECK(scene->pair(0, 0).restitution == 0.67);
    CHECK(scene->gravity.y() == -9.81);
    REQUIRE(scene->fills.at(0).position);
    CHECK(scene->fills[0].position->y() == 0.21275);
    CHECK(scene->fills[0].until == scene->fills[0].start);
    CHECK(std::holds_alternative<PlaneShape>(scene->walls.at(0).shape));
}

TEST_CASE("every shipped scene loads and says what it claims") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
        if (entry.path().extension() != ".toml")
            continue;
        ++count;
        const auto scene = load_scene(entry.path());
        CHECK_MESSAGE(scene, to_string(scene.problems()));
        if (scene) {
            CAPTURE(entry.path());
            CHECK(!scene->title.empty());
            CHECK(scene->claim.size() > 80);
        }
    }
    CHECK(count >= 5);
}

TEST_CASE("the trough slice is the thesis' case") {
    const auto scene = load_scene(scenes / "trough-slice.toml");
    REQUIRE(scene);
    CHECK(scene->bodies.at(0).spheres.size() == 65);
    CHECK(scene->fills.at(0).count == 4878);
    CHECK(1 / scene->time_step == about(350000, 1e-14));
    const auto& harmonics = scene->walls.at(0).motion.harmonics;
    REQUIRE(harmonics.size() == 12);
    CHECK(harmonics[9].axis == 1);
    CHECK(harmonics[9].amplitude == 1.949234e-3);
    CHECK(harmonics[9].frequency == about(25));
    CHECK(harmonics[9].active.start == 1.5);
    // a (2 pi f)^2: the vertical acceleration is 4.9 g.
    const double peak = harmonics[9].amplitude * std::pow(2 * std::numbers::pi * harmonics[9].frequency, 2) / 9.81;
    CHECK(peak == about(4.9, 0.01));
    CHECK(scene->domain.periodic == std::array{true, false, false});
}

TEST_CASE("factors and a phase stretch what a motion file says") {
    // A displacement a d(f t): a times as far, f times as often.
    const auto plain = load_scene(scenes / "trough-slice.toml");
    const std::string motion = "wall." + plain->walls.at(0).name + ".motion.0.";
    const auto changed =
        load_scene(scenes / "trough-slice.toml",
                   {{motion + "amplitude_factor=0.5"}, {motion + "frequency_factor=1.2"}, {motion + "phase_deg=90"}});
    REQUIRE_MESSAGE(changed.ok(), to_string(changed.problems()));
    const auto& before = plain->walls.at(0).motion.harmonics;
    const auto& after = changed->walls.at(0).motion.harmonics;
    REQUIRE(after.size() == before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(after[i].amplitude == 0.5 * before[i].amplitude);
        CHECK(after[i].frequency == about(1.2 * before[i].frequency, 1e-14));
        CHECK(after[i].phase == about(before[i].phase + std::numbers::pi / 2, 1e-14));
    }
}

TEST_CASE("the rows of a motion table are stretched by its factors, and its start stays") {
    const auto scene = load(R"(
[[wall]]
name = "floor"
shape = "plane"
point_m = [0, 0, 0]
material = "glass"
[[wall.motion]]
kind = "table"
rows = [[0, 0, 0, 0], [0.1, 0.002, 0, 0], [0.3, 0, 0.001, 0]]
amplitude_factor = 3
frequency_factor = 2
start_s = 0.5
)");
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    const WallPose pose = pose_at(scene->walls.at(0).motion, 0.5 + 0.1 / 2);
    CHECK(pose.translation.x() == about(0.006, 1e-12));
    CHECK(pose_at(scene->walls.at(0).motion, 9).translation.y() == about(0.003, 1e-12));
}

TEST_CASE("the shipped steps stay below a fifth of the smallest sphere's Rayleigh time") {
    // Li, Xu and Thornton 2005: pi R sqrt(rho / G) / (0.1631 nu + 0.8766).
    for (const char* name : {"trough-slice.toml", "trough-quick.toml", "settle-cones.toml"}) {
        CAPTURE(name);
        const auto scene = load_scene(scenes / name);
        REQUIRE(scene);
        const contact::Material& media = scene->materials.at(0);
        double radius = 1;
        for (const Sphere& sphere : scene->bodies.at(0).spheres)
            radius = std::min(radius, sphere.radius);
        const double shear = media.youngs_modulus / (2 * (1 + media.poisson_ratio));
        const double rayleigh =
            std::numbers::pi * radius * std::sqrt(media.density / shear) / (0.1631 * media.poisson_ratio + 0.8766);
        CHECK(scene->time_step < 0.2 * rayleigh);
    }
}

TEST_CASE("units in key names are turned into SI once") {
    const auto scene = load(R"(
[[wall]]
name = "drum"
shape = "cylinder"
material = "glass"
base_m = [0, 0, 0]
axis = [0, 0, 3]
length_m = 0.2
radius_m = 0.1
[[wall.motion]]
kind = "rotation"
centre_m = [0, 0, 0]
about = [0, 0, -2]
speed_rpm = 30
[[wall.motion]]
kind = "rocking"
centre_m = [0, 0, 0]
about = [1, 0, 0]
amplitude_deg = 90
frequency_Hz = 2
phase_deg = -180
)");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    const WallMotion& motion = scene->walls.at(0).motion;
    CHECK(std::get<CylinderShape>(scene->walls[0].shape).axis == Vector3d::UnitZ());
    CHECK(motion.rotations.at(0).angular_velocity == about(std::numbers::pi, 1e-15));
    CHECK(motion.rotations[0].axis == Vector3d(0, 0, -1));
    CHECK(motion.rockings.at(0).amplitude == about(std::numbers::pi / 2, 1e-15));
    CHECK(motion.rockings[0].phase == about(-std::numbers::pi, 1e-15));
    CHECK(scene->bodies.at(0).spheres.at(0).radius == about(0.002, 1e-15));
}

TEST_CASE("open faces of a box are found by their sign and axis") {
    const auto scene = load(R"(
[[wall]]
name = "box"
shape = "box"
material = "glass"
lo_m = [-0.5, -0.5, -0.5]
hi_m = [0.5, 0.5, 0.5]
open = ["-x", "+y", "+z"]
)");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(std::get<BoxShape>(scene->walls.at(0).shape).open == std::array{true, false, false, true, false, true});
}

TEST_CASE("a wall with an STL file is a mesh without saying so, in metres after its scale") {
    const auto scene = load(R"(
[[wall]]
name = "lid"
stl = "tetrahedron.stl"
scale = 0.001
material = "glass"
)");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    const auto& mesh = std::get<MeshShape>(scene->walls.at(0).shape);
    CHECK(mesh.triangles.size() == 4);
    CHECK(mesh.triangles[0][1].cwiseAbs().maxCoeff() == about(0.01)); // 10 mm
}

TEST_CASE("files are found from the scene's folder, wherever the program stands") {
    const auto scene =
        load("[body.cone]\nclump = \"../../../scenes/clumps/cone-65.csv\"\nmaterial = \"glass\"\nscale = 2\n");
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    CHECK(scene->bodies.at(1).spheres.at(0).radius == 2 * 0.00155);
}

TEST_CASE("a single body needs no pair of its own material, two do") {
    std::string alone = small;
    alone.erase(alone.find("[pair"), alone.find("[body") - alone.find("[pair"));
    const std::string one = "[[fill]]\nbody = \"bead\"\ncount = 1\nposition_m = [0, 0, 0]\n";
    CHECK(load_scene_text(alone + one, "a.toml"));
    CHECK(!load_scene_text(alone + one + one, "a.toml"));
}

TEST_CASE("all problems of a scene come at once, in the order of its lines") {
    const auto scene = load("[[wall]]\nname = \"a\"\nshap = \"plane\"\n[observe]\nevery_s = -1\n[colour]\n");
    const Problems problems = scene.problems();
    std::vector<int> lines;
    for (const Problem& problem : problems)
        lines.push_back(problem.line);
    CHECK(lines == std::vector<int>{17, 19, 21, 22}); // no material, 'shap', every_s, [colour]
}

TEST_CASE("a scene that is not there, is a folder or never ends is refused with its name") {
    const auto refusal = [](const char* file) { return to_string(load_scene(file).problems()); };
    CHECK(refusal("no/such.toml") == "no/such.toml: there is no such file\n"
                                     "    check the name; this is where it was looked for\n");
    CHECK(refusal("/") == "/: this is a folder, not a file\n    name a file inside it\n");
    CHECK(refusal("/dev/zero") == "/dev/zero: the file has more than the 16 MiB that are read\n"
                                  "    split it or leave out what is not needed\n");
}

TEST_CASE("bytes that are no text are refused by line, not by a crash") {
    const auto scene = load_scene_text(std::string("title = \"\xff\xfe\"\n\0\1", 14), "odd.toml");
    REQUIRE(!scene);
    CHECK(scene.problems()[0].line == 1);
}

TEST_CASE("a free camera without a place is taken, one with only half of it is not, unless another camera is") {
    const std::string free = "[render]\ncamera = \"free\"\n";
    for (const std::string& more : {free, free + "eye_m = [1, 0, 0]\ntarget_m = [0, 0, 0]",
                                    std::string("[render]\ncamera = \"side\"\neye_m = [1, 0, 0]")}) {
        const auto scene = load(more);
        REQUIRE_MESSAGE(scene, to_string(scene.problems()));
        CHECK(scene->render.target == Vector3d::Zero());
    }
    for (const auto& [half, other] : {std::pair{"eye_m", "give target_m too"}, {"target_m", "give eye_m too"}}) {
        const auto scene = load(free + half + " = [1, 0, 0]");
        REQUIRE(scene.problems().size() == 1);
        CHECK(scene.problems()[0].key == std::string("render.") + half);
        CHECK(scene.problems()[0].fix.starts_with(other));
    }
}

TEST_CASE("a mesh that bodies can reach from inside the domain is taken, though none of it lies in there") {
    // The domain lies inside the tetrahedron, whose face at x = 0 is 1 mm or 100 mm away; a bead's radius is 2 mm.
    const std::string mesh = "[[wall]]\nname = \"t\"\nmaterial = \"glass\"\nstl = \"tetrahedron.stl\"";
    for (const auto& [lo, taken] :
         {std::pair{"domain.lo_m=[0.001, 0.5, 0.5]", true}, std::pair{"domain.lo_m=[0.1, 0.5, 0.5]", false}})
        CHECK(load(mesh, {{lo}, {"domain.hi_m=[1, 1, 1]"}}).ok() == taken);
}

TEST_CASE("a problem that comes up later finds the place of its key, or of the table around it") {
    const auto scene = load("[[fill]]\nbody = \"bead\"\ncount = 3\nregion_lo_m = [0, 0, 0]\nregion_hi_m = [1, 1, 1]\n",
                            {{"time_step_s=2e-5"}});
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    const auto lines = std::count(small.begin(), small.end(), '\n');
    CHECK(problem_about(*scene, "fill.0.count", "", "").line == lines + 3);
    CHECK(problem_about(*scene, "fill.0.position_m", "", "").line == lines + 1);
    CHECK(problem_about(*scene, "body.bead.radius_mm", "", "").column == 13);
    CHECK(problem_about(*scene, "time_step_s", "", "").file == "--set time_step_s");
    CHECK(problem_about(*scene, "contact.normal", "", "").line == 0);
    CHECK(problem_about(*scene, "contact.normal", "", "").file == scene->file.string());
}

TEST_CASE("a wall that comes in during the run stands where it may begin, one that stays outside does not") {
    const auto problems = [](const std::string& shape, double speed) {
        const auto scene =
            load("[[wall]]\nname = \"lid\"\nmaterial = \"glass\"\n" + shape +
                 "\n[[wall.motion]]\nkind = \"linear\"\nvelocity_m_s = [0, " + std::to_string(-speed) + ", 0]\n");
        return scene.ok() ? std::string() : to_string(scene.problems());
    };
    for (const std::string shape :
         {"shape = \"disc\"\ncentre_m = [0, 1.3, 0]\nradius_m = 0.2", "shape = \"plane\"\npoint_m = [0, 1.3, 0]",
          "shape = \"cylinder\"\nbase_m = [0, 1.3, 0]\nlength_m = 1\nradius_m = 0.2",
          "shape = \"box\"\nlo_m = [-1, 1.3, -1]\nhi_m = [1, 1.5, 1]"}) {
        CAPTURE(shape);
        CHECK(problems(shape, 0.6) == "");
        CHECK(problems(shape, 0.2).find("lies outside the domain") != std::string::npos); // 0.2 m in the 1 s of the run
    }
}

} // namespace test_load
