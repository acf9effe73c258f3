#include "base/checksum.h"
#include "frames.h"
#include "observe/frame_arrays.h"
#include "observe/frame_file.h"

#include <cstdlib>
#include <doctest/doctest.h>

namespace test_frame_file {

using namespace tumble;
using namespace tumble::test;

namespace {

std::shared_ptr<observe::FrameLayout> some_layout() {
    observe::FrameShape pair = ball(0.01, 0.25);
    pair.name = "pair \"of\" balls";
    pair.inertia = {1e-5, 2e-5, 3e-5};
    pair.centres = {Vector3d(0.01, 0, 0), Vector3d(-0.01, 1e-3, 0)};
    pair.radii = {0.01, 0.009};
    auto layout = open_layout(pair);
    layout->shapes.push_back(ball(0.02, 0.5));
    observe::FrameWall floor;
    floor.name = "floor";
    floor.opacity = 0.5;
    floor.vertices = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 0, 1), Vector3d(0, 0, 1)};
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    observe::FrameWall lid = floor;
    lid.name = "lid";
    lid.triangles = {{3, 1, 0}};
    layout->walls = {floor, lid};
    return layout;
}

observe::Frame some_frame(const std::shared_ptr<const observe::FrameLayout>& layout) {
    observe::Frame frame;
    frame.layout = layout;
    frame.time = 0.1 + 0.2;
    frame.step = 123456789012;
    add_body(frame, {1.0 / 3, -2, 3}, {4, 5, 1e-300}, {7, 8, 9});
    add_body(frame, {0.1, 0.2, 0.3}, {-0.4, 0.5, 0.6}, {0.7, 0.8, 0.9});
    frame.id = {5, 17};
    frame.shape = {1, 0};
    frame.orientation[1] = Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
    observe::WallPlace place;
    place.rotation = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    place.translation = {0.1, 0.2, 0.3};
    place.velocity = {1, 2, 3};
    place.angular_velocity = {4, 5, 6};
    frame.walls = {place, {}};
    return frame;
}

void check_same(const observe::Frame& a, const observe::Frame& b) {
    CHECK(a.time == b.time);
    CHECK(a.step == b.step);
    CHECK(a.id == b.id);
    CHECK(a.shape == b.shape);
    CHECK(a.position == b.position);
    CHECK(a.velocity == b.velocity);
    CHECK(a.angular_velocity == b.angular_velocity);
    REQUIRE(a.bodies() == b.bodies());
    for (std::size_t i = 0; i < a.bodies(); ++i)
        CHECK(a.orientation[i].coeffs() == b.orientation[i].coeffs());
    REQUIRE(a.walls.size() == b.walls.size());
    for (std::size_t i = 0; i < a.walls.size(); ++i) {
        CHECK(a.walls[i].rotation == b.walls[i].rotation);
        CHECK(a.walls[i].translation == b.walls[i].translation);
        CHECK(a.walls[i].velocity == b.walls[i].velocity);
        CHECK(a.walls[i].angular_velocity == b.walls[i].angular_velocity);
    }
}

} // namespace

TEST_CASE("the checksum is the one that zip and zlib use") {
    CHECK(crc32("") == 0);
    CHECK(crc32("123456789") == 0xCBF43926u); // the usual check value of CRC-32
    CHECK(crc32("The quick brown fox jumps over the lazy dog") == 0x414FA339u);
}

TEST_CASE("a layout and a frame read back to the same bits") {
    const Folder folder;
    const auto layout = some_layout();
    const observe::Frame frame = some_frame(layout);
    REQUIRE(observe::write_layout(observe::layout_path(folder.path), *layout).ok());
    REQUIRE(observe::write_frame(observe::frame_path(folder.path, 12), frame).ok());
    const auto read = observe::read_layout(observe::layout_path(folder.path));
    REQUIRE(read.ok());
    const observe::FrameLayout& back = **read;
    CHECK(back.title == layout->title);
    CHECK(back.domain_lo == layout->domain_lo);
    CHECK(back.domain_hi == layout->domain_hi);
    CHECK(back.periodic == layout->periodic);
    REQUIRE(back.shapes.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(back.shapes[i].name == layout->shapes[i].name);
        CHECK(back.shapes[i].mass == layout->shapes[i].mass);
        CHECK(back.shapes[i].inertia == layout->shapes[i].inertia);
        CHECK(back.shapes[i].centres == layout->shapes[i].centres);
        CHECK(back.shapes[i].radii == layout->shapes[i].radii);
    }
    REQUIRE(back.walls.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(back.walls[i].name == layout->walls[i].name);
        CHECK(back.walls[i].opacity == layout->walls[i].opacity);
        CHECK(back.walls[i].vertices == layout->walls[i].vertices);
        CHECK(back.walls[i].triangles == layout->walls[i].triangles);
    }
    const auto again = observe::read_frame(observe::frame_path(folder.path, 12), *read);
    REQUIRE(again.ok());
    check_same(*again, frame);
}

TEST_CASE("frames are listed by number, and nothing else with them") {
    const Folder folder;
    for (const char* name : {"frame_000010.tumble", "frame_000002.tumble", "frame_1000000.tumble", "layout.tumble",
                             "frame_000003.tumble.part", "frame_.tumble", "frame_00a.tumble"})
        put(folder.path / name, "");
    std::vector<std::string> names;
    for (const auto& file : observe::list_frames(folder.path))
        names.push_back(file.filename().string());
    CHECK(names == std::vector<std::string>{"frame_000002.tumble", "frame_000010.tumble", "frame_1000000.tumble"});
    CHECK(observe::list_frames(folder.path / "none").empty());
}

TEST_CASE("a frame cut off anywhere, or with any byte changed, is refused") {
    const auto layout = some_layout();
    const std::string bytes = observe::to_bytes(observe::to_arrays(some_frame(layout)));
    const Folder folder;
    const auto file = folder.path / "f.tumble";
    for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 7) {
        put(file, bytes.substr(0, size));
        CHECK_FALSE(observe::read_frame(file, layout).ok());
    }
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 0x10);
        put(file, changed);
        CHECK_FALSE(observe::read_frame(file, layout).ok());
    }
    put(file, bytes.substr(0, bytes.size() / 2));
    const Problems problems = observe::read_frame(file, layout).problems();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].file == file.string());
    CHECK(problems[0].what.find("cut off") != std::string::npos);
    CHECK_FALSE(problems[0].fix.empty());
}

TEST_CASE("a frame's head tells time, step and contacts, and whether the file is as long as it says") {
    const auto layout = some_layout();
    observe::Frame frame = some_frame(layout);
    const Folder folder;
    const auto file = folder.path / "f.tumble";
    REQUIRE(observe::write_frame(file, frame).ok());
    const auto head = observe::read_frame_head(file);
    REQUIRE_MESSAGE(head.ok(), to_string(head.problems()));
    CHECK(head->time == frame.time);
    CHECK(head->step == frame.step);
    CHECK(!head->contacts);
    const std::string bytes = content_of(file);
    for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 7) {
        put(file, bytes.substr(0, size));
        CHECK_FALSE(observe::read_frame_head(file).ok());
    }
    put(file, bytes + "x");
    CHECK_FALSE(observe::read_frame_head(file).ok());
    // What was changed among the arrays only the checksum knows of.
    std::string changed = bytes;
    changed[changed.size() - 20] = static_cast<char>(changed[changed.size() - 20] ^ 0x10);
    put(file, changed);
    CHECK(observe::read_frame_head(file).ok());
    CHECK_FALSE(observe::read_frame(file, layout).ok());
    frame.contacts.emplace();
    REQUIRE(observe::write_frame(file, frame).ok());
    CHECK(observe::read_frame_head(file)->contacts);
    CHECK_FALSE(observe::read_frame_head(folder.path).ok());
    CHECK_FALSE(observe::read_frame_head(folder.path / "none").ok());
    REQUIRE(observe::write_layout(file, *layout).ok());
    CHECK(observe::read_frame_head(file).problems().at(0).what == "holds a 'layout', not a 'frame'");
}

TEST_CASE("a frame that does not fit its layout is refused even when its checksum is right") {
    const auto layout = some_layout();
    const Folder folder;
    const auto file = folder.path / "f.tumble";
    SUBCASE("a shape that the layout does not have") {
        observe::Frame frame = some_frame(layout);
        frame.shape[0] = 2;
        REQUIRE(observe::write_frame(file, frame).ok());
        CHECK(observe::read_frame(file, layout).problems()[0].what == "array 'shape' names 2 where there are 2");
    }
    SUBCASE("walls that the layout does not have") {
        observe::Frame frame = some_frame(layout);
        frame.walls.emplace_back();
        REQUIRE(observe::write_frame(file, frame).ok());
        CHECK(observe::read_frame(file, layout).problems()[0].what == "has 3 walls, its layout has 2");
    }
    SUBCASE("a position that is no number") {
        observe::Frame frame = some_frame(layout);
        frame.position[1].y() = std::nan("");
        REQUIRE(observe::write_frame(file, frame).ok());
        CHECK(observe::read_frame(file, layout).problems()[0].what == "array 'position_m' is not finite in row 1");
    }
    SUBCASE("a layout instead of a frame") {
        REQUIRE(observe::write_layout(file, *layout).ok());
        CHECK(observe::read_frame(file, layout).problems()[0].what == "holds a 'layout', not a 'frame'");
    }
    SUBCASE("arrays of different lengths") {
        observe::Frame frame = some_frame(layout);
        frame.velocity.pop_back();
        REQUIRE(observe::write_frame(file, frame).ok());
        CHECK(observe::read_frame(file, layout).problems()[0].what == "array 'id' has 2 rows and 'velocity_m_s' has 1");
    }
}

TEST_CASE("writing where nothing can be written is a problem and leaves nothing behind") {
    const auto layout = some_layout();
    const Folder folder;
    CHECK_FALSE(observe::write_frame(folder.path / "none" / "f.tumble", some_frame(layout)).ok());
    std::filesystem::create_directory(folder.path / "taken.tumble");
    put(folder.path / "taken.tumble" / "x", "x");
    CHECK_FALSE(observe::write_frame(folder.path / "taken.tumble", some_frame(layout)).ok());
    CHECK_FALSE(std::filesystem::exists(folder.path / "taken.tumble.part"));
}

TEST_CASE("numpy reads a frame in the lines that docs/run-folder.md shows") {
    const std::string python =
        std::system("python3 -c 'import numpy' 2>/dev/null") == 0 ? "python3" : "/usr/bin/python3";
    if (std::system((python + " -c 'import numpy' 2>/dev/null").c_str()) != 0) {
        MESSAGE("skipped: python3 with numpy is not installed (apt install python3-numpy)");
        return;
    }
    const std::string page = content_of(std::filesystem::path(TUMBLE_ROOT) / "docs" / "run-folder.md");
    const std::size_t start = page.find("```python\n");
    REQUIRE(start != std::string::npos);
    const std::size_t end = page.find("```", start + 10);
    REQUIRE(end != std::string::npos);
    const Folder folder;
    const auto layout = some_layout();
    std::filesystem::create_directories(folder.path / "out" / "drop" / "frames");
    REQUIRE(observe::write_frame(folder.path / "out/drop/frames/frame_000000.tumble", some_frame(layout)).ok());
    put(folder.path / "read.py", page.substr(start + 10, end - start - 10) +
                                     "\nassert head['time_s'] == 0.1 + 0.2 and head['step'] == 123456789012\n"
                                     "assert frame['id'].tolist() == [[5], [17]]\n"
                                     "assert frame['position_m'].tolist() == [[1/3, -2, 3], [0.1, 0.2, 0.3]]\n"
                                     "assert frame['orientation_wxyz'][1].tolist() == [0.5, -0.5, 0.5, -0.5]\n"
                                     "assert frame['wall_velocity_m_s'][0].tolist() == [1, 2, 3]\n");
    CHECK(std::system(("cd '" + folder.path.string() + "' && " + python + " read.py > /dev/null").c_str()) == 0);
}

TEST_CASE("a frame's contacts read back to the same bits, and a frame without any is one of a run that kept none") {
    const auto layout = some_layout();
    observe::Frame frame = some_frame(layout);
    const auto again = [&] { return observe::frame_from(observe::to_arrays(frame), layout); };
    CHECK(!again()->contacts);
    frame.contacts.emplace();
    REQUIRE(again()->contacts);
    CHECK(again()->contacts->empty());
    frame.contacts = {{.a = 17, .b = 5, .point = {1.0 / 3, 2, 3}, .normal = {0, 1, 0}, .force = {4, 0.1, -6}},
                      {.a = 5, .wall = 1, .point = {7, 8, 9}, .normal = {1, 0, 0}, .force = {1e-300, 0, 0}}};
    const auto back = again();
    REQUIRE_MESSAGE(back.ok(), to_string(back.problems()));
    REQUIRE(back->contacts->size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const observe::FrameContact &one = (*frame.contacts)[k], &other = (*back->contacts)[k];
        CHECK(std::tuple(one.a, one.b, one.wall) == std::tuple(other.a, other.b, other.wall));
        CHECK(one.point == other.point);
        CHECK(one.normal == other.normal);
        CHECK(one.force == other.force);
    }
    for (const observe::FrameContact& wrong :
         {observe::FrameContact{.a = 6, .b = 5}, observe::FrameContact{.a = 5},
          observe::FrameContact{.a = 5, .wall = 2}, observe::FrameContact{.a = 5, .b = 17, .wall = 0}}) {
        frame.contacts = {wrong};
        REQUIRE(!again().ok());
        CHECK(again().problems()[0].what == "contact 0 names a body or a wall that is not there");
    }
}

} // namespace test_frame_file
