#include "process.h"

#include <nlohmann/json.hpp>
#include <regex>

namespace test_gallery {

using namespace tumble::test;
namespace fs = std::filesystem;

/// Pixels across and upright, as the head of the file has them.
std::pair<unsigned long, unsigned long> size_of_png(const fs::path& file) {
    const std::string head = content_of(file).substr(16, 8);
    REQUIRE(head.size() == 8);
    const auto number = [&](std::size_t from) {
        unsigned long value = 0;
        for (std::size_t k = from; k < from + 4; ++k)
            value = 256 * value + static_cast<unsigned char>(head[k]);
        return value;
    };
    return {number(0), number(4)};
}

TEST_CASE("the gallery makes what it can, names what failed, and leaves no runs behind") {
    const Folder folder;
    fs::create_directory(folder.path / "scenes");
    put(folder.path / "scenes/drum-2d.toml", lying_disc); // and no other scene
    const Outcome made = tumble_in(folder, {"gallery", "--out", "pictures", "arrows.png", "sections.png"});
    CHECK(made.code == 1);
    CHECK_MESSAGE(made.out == "1 picture in pictures; failed: sections.png\n", (made.out + made.err));
    CHECK(contains(made.err, "arrows.png: done after"));
    CHECK(fs::exists(folder.path / "pictures/arrows.png"));
    CHECK(!fs::exists(folder.path / "pictures/.runs"));
    CHECK(tumble_in(folder, {"gallery", "--out", "pictures", "--only", "nothing.png"}).code == 2);
    CHECK(tumble_in(folder, {"gallery", "--out", "pictures", "--quick", "--only", "arrows.png"}).code == 2);
    CHECK(contains(tumble_in(folder, {"gallery"}).err, "write --out docs/gallery"));
}

TEST_CASE("a picture that a command leaves in a folder of its own is taken from there") {
    const Folder folder;
    fs::create_directory(folder.path / "scenes");
    put(folder.path / "scenes/drum-2d.toml", lying_disc);
    const Outcome made = tumble_in(folder, {"gallery", "--out", "pictures", "--only", "pair.png", "drum-2d.png"});
    CHECK_MESSAGE(made.code == 0, made.err);
    CHECK(contains(made.err, "run smooth: done after")); // the second run that pair.png needs
    for (const char* file : {"pair.png", "drum-2d.png"})
        CHECK(fs::exists(folder.path / "pictures" / file));
}

TEST_CASE("a run that is there already is taken as it is, and costs no minutes") {
    const Folder folder;
    fs::create_directory(folder.path / "scenes");
    put(folder.path / "disc.toml", lying_disc);
    REQUIRE(tumble_in(folder, {"run", "disc.toml", "--out", "there", "--quiet"}).code == 0);
    const auto before = content_of(folder.path / "there/run.json");
    const Outcome made =
        tumble_in(folder, {"gallery", "--out", "pictures", "--only", "arrows.png", "--run", "drum=there"});
    CHECK_MESSAGE(made.code == 0, made.err);
    CHECK(made.err.find("run drum") == std::string::npos);
    CHECK(fs::exists(folder.path / "pictures/arrows.png"));
    CHECK(content_of(folder.path / "there/run.json") == before);
    for (const auto& [wrong, words] :
         {std::pair{"drum", "--run drum: there is no = between a name and a folder"},
          {"drum=", "--run drum=: no folder is named"},
          {"drums=there", "--run drums=there: the gallery has no run 'drums'; did you mean"},
          {"=there", "the gallery has no run ''"}}) {
        const Outcome refused = tumble_in(folder, {"gallery", "--out", "pictures", "--run", wrong});
        CHECK(refused.code == 2);
        CHECK(contains(refused.err, words));
        CHECK(contains(refused.err, "write --run NAME=DIR with one of drum, "));
    }
    const Outcome twice =
        tumble_in(folder, {"gallery", "--out", "pictures", "--run", "drum=there", "--run", "drum=there"});
    CHECK(twice.code == 2);
    CHECK(contains(twice.err, "given twice"));
    fs::create_directory(folder.path / "empty");
    CHECK(contains(tumble_in(folder, {"gallery", "--out", "pictures", "--run", "drum=empty"}).err,
                   "is no folder that the run drum has filled"));
    // What follows the one value of --run is a picture.
    const Outcome named = tumble_in(folder, {"gallery", "--out", "more", "--run", "drum=there", "arrows.png"});
    CHECK_MESSAGE(named.code == 0, named.err);
    CHECK(named.out == "1 picture in more\n");
    const Outcome listed = tumble_in(folder, {"gallery", "--list"});
    CHECK(contains(listed.out, "run drum, smooth"));
    const Outcome missing = tumble_in(folder, {"gallery", "--out", "pictures", "--run", "bowl-full=nowhere"});
    CHECK(missing.code == 2);
    CHECK(contains(missing.err, "is no folder that the run bowl-full has filled"));
}

TEST_CASE("a gallery that is killed leaves whole pictures, and the same call goes on to the same bits") {
    const Folder folder;
    fs::create_directory(folder.path / "scenes");
    put(folder.path / "scenes/drum-2d.toml", lying_disc);
    const std::vector<std::string> files{"arrows.png", "chains-2d.png", "paper.png"};
    const auto words_into = [&](const std::string& out) {
        std::vector<std::string> words{"gallery", "--out", out, "--only"};
        words.insert(words.end(), files.begin(), files.end());
        return words;
    };
    REQUIRE(tumble_in(folder, words_into("whole")).code == 0);
    const auto check_names = [&] { // each picture that is there is the whole one, and nothing else is seen
        for (const auto& entry : fs::directory_iterator(folder.path / "parts"))
            if (const std::string name = entry.path().filename(); name != ".runs")
                CHECK_MESSAGE(content_of(entry.path()) == content_of(folder.path / "whole" / name), name);
    };
    const auto kill_once = [&](const char* there) {
        Process process(folder.path, words_into("parts"));
        REQUIRE(eventually([&] { return fs::exists(folder.path / "parts" / there); }));
        process.send(SIGKILL);
        const int code = process.wait().code;
        CHECK((code == 137 || code == 0)); // killed, or quicker than that
        check_names();
    };
    kill_once(".runs/drum/frames/frame_000010.tumble"); // in the run
    kill_once(".runs/drum.over");                       // behind it
    kill_once("arrows.png");                            // between pictures
    const bool ran = fs::exists(folder.path / "parts/.runs/drum.over");
    const Outcome last = tumble_in(folder, words_into("parts"));
    CHECK_MESSAGE(last.code == 0, last.err);
    CHECK(contains(last.err, ran ? "run drum: done before" : "run drum: done after"));
    check_names();
    for (const std::string& file : files)
        CHECK(fs::exists(folder.path / "parts" / file));
    CHECK(!fs::exists(folder.path / "parts/.runs"));
}

TEST_CASE("docs/gallery.md has the commands that make each picture of the gallery") {
    const Folder folder;
    const Outcome listed = tumble_in(folder, {"gallery", "--list", "--json"});
    REQUIRE(listed.code == 0);
    const std::string page = content_of(fs::path(TUMBLE_ROOT) / "docs/gallery.md");
    const auto pictures = nlohmann::json::parse(listed.out);
    CHECK(pictures.size() >= 19);
    for (const auto& picture : pictures) {
        const std::string file = picture["file"], result = picture["result"];
        CAPTURE(file);
        std::string commands;
        for (const auto& command : picture["commands"])
            commands += command.get<std::string>() + "\n";
        if (result != file)
            commands.insert(commands.size() - 1, " # " + result);
        CHECK(contains(page, commands));
        const fs::path made = fs::path(TUMBLE_ROOT) / "docs/gallery" / file;
        REQUIRE(fs::exists(made));
        CHECK(fs::file_size(made) < (picture["minutes"] == 0 ? 300000 : 800000)); // bytes
        std::smatch size;
        if (made.extension() == ".png" && std::regex_search(commands, size, std::regex("--size=([0-9]+)x([0-9]+)"))) {
            const auto [width, height] = size_of_png(made);
            CHECK(width == std::stoul(size[1]));
            CHECK(height <= std::stoul(size[2])); // several frames in one take no more than they need
        }
    }
}

} // namespace test_gallery
