#include "about.h"
#include "folder.h"
#include "run/wall_files.h"
#include "scene/extent.h"
#include "scene/read_stl.h"

#include <doctest/doctest.h>
#include <numbers>

namespace test_wall_files {

using namespace tumble;
using Eigen::Vector3d;
using tumble::test::about;

namespace {

scene::Scene bowl_and_disc() {
    scene::Scene scene;
    scene.domain.box = {Vector3d::Constant(-1), Vector3d::Constant(1)};
    const scene::Ribs ribs{3, 0.004, 0.012, 0.006};
    scene::Wall bowl, disc;
    bowl.name = "bowl";
    bowl.shape = scene::BowlShape{Vector3d::Zero(), 0.1665, 0.21, 0.25, ribs};
    disc.name = "disc";
    disc.shape = scene::BowlDiscShape{Vector3d(0, 0.1, 0), 0.16, 0.03, 0.03, 0.25, ribs};
    scene::Rotation turning;
    turning.angular_velocity = std::numbers::pi / 3;
    disc.motion.rotations = {turning};
    scene.walls = {bowl, disc};
    return scene;
}

scene::Box read_box(const std::filesystem::path& file) {
    scene::MeshShape mesh;
    mesh.triangles = scene::read_stl(file).value();
    return scene::extent_of(scene::WallShape(mesh));
}

} // namespace

TEST_CASE("walls written as STL are read back as large as they are and where they stand at that time") {
    const test::Folder folder;
    const auto files = run::write_wall_files(bowl_and_disc(), {}, 0, folder.path, false);
    REQUIRE_MESSAGE(files.ok(), to_string(files.problems()));
    REQUIRE(files->size() == 2);
    const scene::Box bowl = read_box(folder.path / "bowl.stl");
    CHECK(bowl.hi.y() == about(0.21));
    CHECK(bowl.hi.z() == about(0.1665, 0.001));
    // Of three ribs the first points along +x: there the facet's middle lies inside the circle, at -x there is none.
    const scene::Box disc = read_box(folder.path / "disc.stl");
    CHECK(disc.lo.y() == about(0.1));
    // After a second it has turned by 60 degrees, and a rib points along -x.
    REQUIRE(run::write_wall_files(bowl_and_disc(), {"disc"}, 1.0, folder.path / "later", false).ok());
    const scene::Box later = read_box(folder.path / "later" / "disc.stl");
    CHECK(later.lo.x() == about(-disc.hi.x(), 1e-6));
    CHECK(later.hi.x() == about(-disc.lo.x(), 1e-6));
    CHECK(!std::filesystem::exists(folder.path / "later" / "bowl.stl"));
}

TEST_CASE("walls of another name, and files that are there, are refused") {
    const test::Folder folder;
    const auto unknown = run::write_wall_files(bowl_and_disc(), {"dics"}, 0, folder.path, false);
    REQUIRE(!unknown.ok());
    CHECK(unknown.problems()[0].fix == "did you mean 'disc'?");
    REQUIRE(run::write_wall_files(bowl_and_disc(), {"disc"}, 0, folder.path, false).ok());
    CHECK(!run::write_wall_files(bowl_and_disc(), {"disc"}, 0, folder.path, false).ok());
    CHECK(run::write_wall_files(bowl_and_disc(), {"disc"}, 0, folder.path, true).ok());
}

} // namespace test_wall_files
