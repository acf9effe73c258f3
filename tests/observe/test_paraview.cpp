#include "about.h"
#include "frames.h"
#include "observe/paraview.h"
#include "observe/text_dump.h"
#include "observe/xml_arrays.h"

#include <cstdlib>
#include <cstring>
#include <doctest/doctest.h>
#include <map>

namespace test_paraview {

using namespace tumble;
using namespace tumble::test;

namespace {

std::string decoded(const std::string& text) {
    static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=')
            break;
        group = (group << 6) | static_cast<std::uint32_t>(letters.find(c));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>((group >> bits) & 0xFF);
        }
    }
    return bytes;
}

/// Numbers of the named array as an independent reader finds them: a 64-bit byte count, then the content.
template <class T> std::vector<T> array_in(const std::string& xml, const std::string& name) {
    const std::size_t head = xml.find("Name=\"" + name + "\"");
    REQUIRE_MESSAGE(head != std::string::npos, name);
    const std::size_t start = xml.find('>', head) + 1;
    const std::string bytes = decoded(xml.substr(start, xml.find('<', start) - start));
    REQUIRE(bytes.size() >= 8);
    std::uint64_t count = 0;
    std::memcpy(&count, bytes.data(), 8);
    REQUIRE(bytes.size() == 8 + count);
    std::vector<T> values(count / sizeof(T));
    std::memcpy(values.data(), bytes.data() + 8, count);
    return values;
}

observe::Frame some_frame() {
    observe::FrameShape pair = ball(0.01, 0.25);
    pair.centres = {Vector3d(0.01, 0, 0), Vector3d(-0.01, 0, 0)};
    pair.radii = {0.01, 0.005};
    auto layout = open_layout(pair);
    observe::FrameWall wall;
    wall.name = "a <\"wall\"> & more";
    wall.vertices = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 0, 1)};
    wall.triangles = {{0, 1, 2}};
    layout->walls = {wall, wall};
    observe::Frame frame;
    frame.layout = layout;
    frame.time = 0.25;
    frame.step = 77;
    add_body(frame, {1, 2, 3}, {0, 5, 0}, {0, 0, 2});
    frame.orientation[0] = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ());
    observe::WallPlace moved;
    moved.translation = {0, 10, 0};
    moved.velocity = {0, 3, 0};
    frame.walls = {{}, moved};
    return frame;
}

bool installed(const std::string& test) {
    return std::system((test + " > /dev/null 2>&1").c_str()) == 0;
}

} // namespace

TEST_CASE("base64 gives the test vectors of RFC 4648") {
    const std::map<std::string, std::string> vectors{{"", ""},
                                                     {"f", "Zg=="},
                                                     {"fo", "Zm8="},
                                                     {"foo", "Zm9v"},
                                                     {"foob", "Zm9vYg=="},
                                                     {"fooba", "Zm9vYmE="},
                                                     {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors)
        CHECK(observe::base64(bytes) == text);
}

TEST_CASE("bodies carry their id, motion and orientation") {
    const std::string xml = observe::bodies_vtp(some_frame());
    CHECK(array_in<float>(xml, "Points") == std::vector<float>{1, 2, 3});
    CHECK(array_in<std::int64_t>(xml, "id") == std::vector<std::int64_t>{0});
    CHECK(array_in<float>(xml, "velocity_m_s") == std::vector<float>{0, 5, 0});
    CHECK(array_in<float>(xml, "angular_velocity_rad_s") == std::vector<float>{0, 0, 2});
    CHECK(array_in<float>(xml, "mass_kg") == std::vector<float>{0.25F});
    CHECK(array_in<float>(xml, "orientation_wxyz")[0] == about(std::sqrt(0.5)));
    CHECK(array_in<std::int64_t>(xml, "offsets") == std::vector<std::int64_t>{1});
}

TEST_CASE("spheres stand and move where the turned body has them") {
    const std::string xml = observe::spheres_vtp(some_frame());
    const auto at = array_in<float>(xml, "Points");
    REQUIRE(at.size() == 6);
    CHECK(at[0] == about(1));
    CHECK(at[1] == about(2.01)); // x of the template points to y
    CHECK(at[4] == about(1.99));
    const auto velocity = array_in<float>(xml, "velocity_m_s");
    CHECK(velocity[0] == about(-0.02)); // w x r = 2 z x 0.01 y
    CHECK(velocity[1] == about(5));
    CHECK(array_in<float>(xml, "radius_m") == std::vector<float>{0.01F, 0.005F});
}

TEST_CASE("walls stand where they have moved to, with the indices of their own corners") {
    const std::string xml = observe::walls_vtp(some_frame());
    const auto at = array_in<float>(xml, "Points");
    REQUIRE(at.size() == 18);
    CHECK(at[1] == 0);
    CHECK(at[10] == 10);
    CHECK(array_in<std::int64_t>(xml, "connectivity") == std::vector<std::int64_t>{0, 1, 2, 3, 4, 5});
    CHECK(array_in<std::int64_t>(xml, "offsets") == std::vector<std::int64_t>{3, 6});
    CHECK(array_in<std::int64_t>(xml, "wall") == std::vector<std::int64_t>{0, 1});
    CHECK(array_in<float>(xml, "velocity_m_s")[10] == 3);
}

TEST_CASE("the series lists every frame at its time, and every file is well-formed XML") {
    const Folder folder;
    observe::ParaviewWriter writer(folder.path);
    observe::Frame frame = some_frame();
    REQUIRE(writer.write(frame, 0).ok());
    frame.time = 0.5;
    REQUIRE(writer.write(frame, 1).ok());
    const std::string series = content_of(folder.path / "walls.pvd");
    CHECK(series.find("<DataSet timestep=\"0.25\" part=\"0\" file=\"walls_000000.vtp\"/>") != std::string::npos);
    CHECK(series.find("<DataSet timestep=\"0.5\" part=\"0\" file=\"walls_000001.vtp\"/>") != std::string::npos);
    if (!installed("xmllint --version")) {
        MESSAGE("skipped: xmllint is not installed (apt install libxml2-utils)");
        return;
    }
    CHECK(std::system(
              ("xmllint --noout '" + folder.path.string() + "'/*.vtp '" + folder.path.string() + "'/*.pvd").c_str()) ==
          0);
}

TEST_CASE("VTK's own reader gets the same numbers") {
    if (!installed("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML'")) {
        MESSAGE("skipped: VTK for python3 is not installed (apt install python3-vtk9)");
        return;
    }
    const Folder folder;
    put(folder.path / "walls.vtp", observe::walls_vtp(some_frame()));
    put(folder.path / "spheres.vtp", observe::spheres_vtp(some_frame()));
    put(folder.path / "read.py", R"(
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
def read(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()
walls = read('walls.vtp')
assert walls.GetNumberOfPoints() == 6 and walls.GetNumberOfPolys() == 2, walls
assert walls.GetPoint(3) == (0, 10, 0), walls.GetPoint(3)
assert walls.GetCellData().GetArray('wall').GetValue(1) == 1
assert walls.GetFieldData().GetArray('TimeValue').GetValue(0) == 0.25
spheres = read('spheres.vtp')
assert spheres.GetNumberOfVerts() == 2
assert abs(spheres.GetPointData().GetArray('radius_m').GetValue(1) - 0.005) < 1e-8
)");
    CHECK(std::system(("cd '" + folder.path.string() + "' && /usr/bin/python3 read.py").c_str()) == 0);
}

TEST_CASE("the text dump has one line per sphere below LIGGGHTS' heads") {
    const std::string text = observe::text_dump(some_frame());
    CHECK(text == "ITEM: TIMESTEP\n77\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp ff ff\n-1 1\n-1 1\n-1 1\n"
                  "ITEM: ATOMS id type x y z radius vx vy vz mol\n"
                  "1 1 1 2.01 3 0.01 -0.02 5 0 1\n"
                  "2 1 1 1.99 3 0.005 0.02 5 0 1\n");
}

} // namespace test_paraview
