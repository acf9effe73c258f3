#include "scene/load.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace test_broken_scenes {

using namespace tumble;
using namespace tumble::scene;

namespace {

const std::filesystem::path folder = TUMBLE_ROOT "/tests/broken_scenes";

std::string text_of(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Messages without the folder this machine has them in.
std::string message_of(const std::filesystem::path& scene) {
    std::string text = to_string(load_scene(scene).problems());
    const std::string prefix = folder.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
        text.erase(at, prefix.size());
    return text;
}

std::vector<std::filesystem::path> broken_scenes() {
    std::vector<std::filesystem::path> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            all.push_back(entry.path());
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace

TEST_CASE("each broken scene gets exactly the message that stands beside it") {
    const auto all = broken_scenes();
    CHECK(all.size() >= 30);
    for (const auto& scene : all) {
        CAPTURE(scene.filename());
        const std::string message = message_of(scene);
        CHECK(!message.empty());
        CHECK(message == text_of(std::filesystem::path(scene).replace_extension(".expected")));
    }
}

TEST_CASE("each message says where it is, and what to do on the next line") {
    for (const auto& scene : broken_scenes())
        for (const Problem& problem : load_scene(scene).problems()) {
            CAPTURE(scene.filename());
            CHECK(problem.file.find(folder.string()) == 0);
            CHECK(problem.line > 0);
            CHECK(!problem.what.empty());
            CHECK(!problem.fix.empty());
        }
}

} // namespace test_broken_scenes
