#include "process.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace test_pictures {

using namespace tumble::test;
namespace fs = std::filesystem;

TEST_CASE("render puts instants or sections into one picture, and says what does not go with that") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", "a", "--quiet", "--set", "render.every_s=0.005"}).code ==
            0);
    const Outcome strip = tumble_in(folder, {"render", "a", "--strip", "2x2", "--size", "640x480", "--quiet"});
    CHECK_MESSAGE(strip.code == 0, strip.err);
    CHECK(fs::exists(folder.path / "a/redrawn/front_speed_strip_4.png"));
    const Outcome sections = tumble_in(folder, {"render", "a", "--sections", "2", "--camera", "side", "--size-mm",
                                                "85x60", "--out", "cuts", "--quiet"});
    CHECK_MESSAGE(sections.code == 0, sections.err);
    CHECK(fs::exists(folder.path / "cuts/section_2.png"));
    const Outcome places = tumble_in(folder, {"render", "a", "--sections=-0.01,0,0.02", "--clip-lo=-0.1,-0.1,-0.1",
                                              "--clip-hi=0.1,0.5,0.1", "--size", "640x480", "--quiet"});
    CHECK_MESSAGE(places.code == 0, places.err);
    CHECK(fs::exists(folder.path / "a/redrawn/front_speed_sections_3.png"));
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"--strip", "six"}, "write --strip 6"},
          {{"--strip", "3", "--sections", "3"}, "leave one of them away"},
          {{"--strip", "3", "--video", "a.mp4"}, "leave --beside, --video and --frames away"},
          {{"--sections", "0"}, "write --sections 6"},
          {{"--sections", "0,x"}, "places in m"},
          {{"--sections", "0,27"}, "cuts no bodies"},
          {{"--strip", "90"}, "ask for fewer"},
          {{"--strip", "200"}, "at most 100"},
          {{"--out", "one.png"}, "--strip 1 draws the last frame alone"},
          {{"--size", "1280*720"}, "--size 1280*720: its value is text"},
          {{"--size-mm", "85*60"}, "for example --size-mm 85x60"},
          {{"--arrow", "bodies"}, "for example --arrow 0.5"},
          {{"--clip-hi", "1,1,1"}, "for example --clip-hi 1,1,1 --clip-lo 0,-1,-1"},
          {{"--strip", "5x1", "--size-mm", "85x60"}, "would be cut off"}, // five times "t = 0.000 s"
          {{"--size-mm", "85x60", "--size", "640x480"}, "write width_mm, height_mm and dpi in its place"},
          {{"--force-chains"}, "write contacts = true in [observe]"}}) {
        std::vector<std::string> all{"render", "a"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
    }
    CHECK(tumble_in(folder, {"render", "ball.toml", "--strip", "2"}).code == 2);
}

TEST_CASE(
    "render draws a run of two dimensions as lines where the name ends in .svg or .pdf, and says where it cannot") {
    const Folder folder;
    put(folder.path / "disc.toml", lying_disc);
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    for (const char* scene : {"disc", "ball"})
        REQUIRE(tumble_in(folder, {"run", std::string(scene) + ".toml", "--out", scene, "--quiet"}).code == 0);
    const Outcome svg = tumble_in(folder, {"render", "disc", "--size-mm", "85x60", "--out", "a.svg"});
    CHECK_MESSAGE(svg.code == 0, svg.err);
    CHECK(contains(svg.out, "a.svg: 1 picture from t = "));
    CHECK(contains(content_of(folder.path / "a.svg"), "width=\"85mm\" height=\"60mm\""));
    CHECK(content_of(folder.path / "a.svg").find("kinetic energy") == std::string::npos);
    const Outcome plot = tumble_in(
        folder, {"render", "disc", "--size-mm", "160x100", "--plot", "kinetic_energy", "--out", "plot.svg", "--quiet"});
    CHECK_MESSAGE(plot.code == 0, plot.err);
    CHECK(contains(content_of(folder.path / "plot.svg"), "kinetic energy"));
    const Outcome pdf = tumble_in(folder, {"render", "disc", "--out", "new/a.pdf", "--json"});
    CHECK_MESSAGE(pdf.code == 0, pdf.err);
    CHECK(nlohmann::json::parse(pdf.out)["pictures"] == "new/a.pdf");
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"disc", "--out", "a.svg"}, "--force replaces it"},
          {{"disc", "--out", "b.svg", "--video", "b.mp4"}, "leave --video and --frames away"},
          {{"disc", "--turn", "90", "--out", "b"}, "leave it away"},
          {{"disc", "--beside", "ball", "--out", "b"}, "runs of the same dimension"},
          {{"ball", "--out", "b.svg"}, "SVG and PDF are for scenes in two dimensions"},
          {{"disc.toml", "--out", "b.pdf"}, "run it first"}}) {
        std::vector<std::string> all{"render"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
        CHECK(!fs::exists(folder.path / "b.svg"));
    }
}

TEST_CASE("a picture's name ends as one of the kinds that there are, in whatever letters, and a video's as a video's") {
    const Folder folder;
    put(folder.path / "disc.toml", lying_disc);
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    for (const char* scene : {"disc", "ball"})
        REQUIRE(tumble_in(folder, {"run", std::string(scene) + ".toml", "--out", scene, "--quiet"}).code == 0);
    for (const char* name : {"a.SVG", "a.Pdf"}) {
        const Outcome drawn = tumble_in(folder, {"render", "disc", "--out", name, "--quiet"});
        CHECK_MESSAGE(drawn.code == 0, drawn.err);
        CHECK(fs::is_regular_file(folder.path / name));
    }
    const Outcome one =
        tumble_in(folder, {"render", "ball", "--strip", "1", "--size", "320x240", "--out", "one.PNG", "--quiet"});
    CHECK_MESSAGE(one.code == 0, one.err);
    CHECK(content_of(folder.path / "one.PNG").starts_with("\x89PNG"));
    fs::create_directory(folder.path / "of.txt"); // a folder that is there may be called so
    CHECK(tumble_in(folder, {"render", "disc", "--out", "of.txt", "--quiet"}).code == 0);
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"disc", "--out", "x.jpg"}, "pictures are not written as .jpg"},
          {{"disc", "--strip", "2", "--out", "x.JPG"}, "pictures are not written as .jpg"},
          {{"disc", "--out", "x.txt"}, "in .png with --strip or --sections"},
          {{"disc", "--out", "x.mp4"}, "write --video x.mp4"},
          {{"disc", "--out", "x.PNG"}, "--strip 1 draws the last frame alone"},
          {{"disc", "--video", "x.png"}, "call it x.mp4; --out is for pictures"},
          {{"disc", "--video", "x"}, "call it x.mp4"},
          {{"disc", "--beside", "disc", "--out", "x.png"}, "--time A: leaves the frames from A on"},
          {{"disc", "--beside", "disc", "--out", "x.gif"}, "pictures are not written as .gif"},
          {{"disc.toml", "--out", "x.png"}, "--out names the folder of a scene's run"},
          {{"disc.toml", "--video", "x.avi"}, "call it x.mp4"}}) {
        std::vector<std::string> all{"render"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
        for (const char* name : {"x", "x.jpg", "x.JPG", "x.txt", "x.mp4", "x.PNG", "x.png", "x.gif", "x.avi", "out"})
            CHECK(!fs::exists(folder.path / name));
    }
}

TEST_CASE("trails are of bodies that the run has, each once") {
    const Folder folder;
    put(folder.path / "disc.toml", lying_disc);
    REQUIRE(tumble_in(folder, {"run", "disc.toml", "--out", "disc", "--quiet"}).code == 0);
    for (const auto& [trails, words] : {std::pair{"7", "there is no body '7' whose trail could be drawn"},
                                        {"7", "take an id from 0 to 0, or disc"},
                                        {"0,0", "'0' is given twice"},
                                        {"disc,0", "are those of one body"},
                                        {"dsic", "no body is called 'dsic'"}})
        for (const std::vector<std::string>& more :
             std::vector<std::vector<std::string>>{{"--out", "x"},
                                                   {"--out", "x", "--strip", "2"},
                                                   {"--out", "x.svg"},
                                                   {"--beside", "disc", "--out", "x"}}) {
            std::vector<std::string> all{"render", "disc", "--trails", trails};
            all.insert(all.end(), more.begin(), more.end());
            const Outcome refused = tumble_in(folder, all);
            CAPTURE(words);
            CHECK(refused.code == 2);
            CHECK_MESSAGE(contains(refused.err, words), refused.err);
            CHECK(!fs::exists(folder.path / "x"));
            CHECK(!fs::exists(folder.path / "x.svg"));
        }
}

TEST_CASE("plot says where a file cannot be written, and leaves no part of one" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const Folder folder;
    put(folder.path / "disc.toml", lying_disc);
    REQUIRE(tumble_in(folder, {"run", "disc.toml", "--out", "a", "--quiet"}).code == 0);
    put(folder.path / "file", "");
    fs::create_directory(folder.path / "folder.png");
    fs::create_directory(folder.path / "taken.png.part"); // where the picture would grow
    for (const auto& [file, words] : {std::pair{"file/a.png", "file: cannot be made"},
                                      {"/proc/tumble/a.png", "/proc/tumble: cannot be made"},
                                      {"/proc/a.png", "/proc/a.png: cannot write the file"},
                                      {"folder.png", "folder.png: cannot write the file: Is a directory"},
                                      {"taken.png", "taken.png: cannot write the file: Is a directory"}}) {
        const Outcome refused = tumble_in(folder, {"plot", "a", "--out", file});
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
        CHECK(!fs::is_regular_file(folder.path / file));
    }
    const Outcome large = tumble_in(folder, {"plot", "a", "--out", "a.PDF", "--quiet"});
    CHECK_MESSAGE(large.code == 0, large.err);
    CHECK(content_of(folder.path / "a.PDF").starts_with("%PDF"));
    for (const auto& entry : fs::directory_iterator(folder.path))
        if (entry.path().extension() == ".part")
            CHECK(entry.path().filename() == "taken.png.part");
}

TEST_CASE("a folder that tumble stress filled is no run to draw or plot, and what does is said") {
    const Folder folder;
    fs::create_directories(folder.path / "s");
    put(folder.path / "s/study.txt", "");
    for (const char* command : {"render", "plot"}) {
        const Outcome refused = tumble_in(folder, {command, "s"});
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, "`tumble stress s --pictures` draws them"), refused.err);
    }
}

TEST_CASE("plot draws what runs measured, in a size for print, and says what it cannot" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.02));
    for (const char* run : {"a", "b"})
        REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", run, "--quiet"}).code == 0);
    const Outcome drawn = tumble_in(folder, {"plot", "a", "--measure", "kinetic_energy,centre_of_mass_y", "--json"});
    REQUIRE_MESSAGE(drawn.code == 0, drawn.err);
    const auto json = nlohmann::json::parse(drawn.out);
    CHECK(json["file"] == "a/redrawn/plot.png");
    CHECK(json["panels"].size() == 2);
    CHECK(json["panels"][0]["columns"][0] == "kinetic_energy_J");
    CHECK(content_of(folder.path / "a/redrawn/plot.png").starts_with("\x89PNG"));
    const Outcome both = tumble_in(
        folder, {"plot", "a", "b", "--labels", "first,second", "--size-mm", "85x80", "--out", "both.svg", "--quiet"});
    CHECK_MESSAGE(both.code == 0, both.err);
    const std::string svg = content_of(folder.path / "both.svg");
    CHECK(contains(svg, "width=\"321\"")); // 85 mm at 96 an inch
    CHECK(contains(svg, "second"));
    // A run that is to be made anew in its folder is not hindered by its plot.
    CHECK(tumble_in(folder, {"run", "ball.toml", "--out", "a", "--quiet", "--force"}).code == 0);
    for (const auto& [flags, words] :
         {std::pair{std::vector<std::string>{"a", "--measure", "kinetic_enrgy"}, "did you mean 'kinetic_energy'?"},
          {{"a", "--out", "a.jpg"}, "plots are drawn as .png, .svg or .pdf"},
          {{"a", "--size-mm", "85"}, "write width x height"},
          {{"a", "--size-mm", "85x20"}, "leave no room"},
          {{"a", "--font-pt", "90"}, "--font-pt"},
          {{"a", "--size-mm", "600x100", "--dpi", "1200"}, "choose a lower --dpi"},
          {{"a", "--time", "1:2"}, "has no row in the time asked for"},
          {{"a", "--labels", "x,y"}, "2 labels are given for 1 runs"},
          {{"a", "--out", "both.svg"}, "--force replaces it"},
          {{"nowhere"}, "there is no such folder"}}) {
        std::vector<std::string> all{"plot"};
        all.insert(all.end(), flags.begin(), flags.end());
        const Outcome refused = tumble_in(folder, all);
        CAPTURE(words);
        CHECK(refused.code == 2);
        CHECK_MESSAGE(contains(refused.err, words), refused.err);
    }
    CHECK(contains(content_of(folder.path / "both.svg"), "second")); // what was refused has changed nothing
}

} // namespace test_pictures
