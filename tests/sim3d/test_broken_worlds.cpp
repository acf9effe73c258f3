#include "scene/load.h"
#include "sim3d/solver.h"

#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_broken_worlds {

using namespace tumble;

namespace {

const std::filesystem::path folder = TUMBLE_ROOT "/tests/broken_scenes/worlds";

/// What the solver says of it, without the folders that this machine has.
std::string message_of(const scene::Scene& scene) {
    const auto world = sim3d::build_world(scene, 1);
    std::string text = world.ok() ? "" : to_string(world.problems());
    for (const std::string& prefix : {folder.string() + "/", folder.parent_path().string() + "/"})
        for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
            text.erase(at, prefix.size());
    return text;
}

std::string text_of(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("each scene that no world can be made of loads, and gets exactly the message that stands beside it") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml")
            continue;
        ++count;
        CAPTURE(entry.path().filename());
        const auto scene = scene::load_scene(entry.path());
        REQUIRE_MESSAGE(scene, to_string(scene.problems()));
        const std::string message = message_of(*scene);
        CHECK(!message.empty());
        CHECK(message == text_of(std::filesystem::path(entry.path()).replace_extension(".expected")));
    }
    CHECK(count >= 6);
}

} // namespace test_broken_worlds
