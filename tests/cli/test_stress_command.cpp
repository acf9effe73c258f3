#include "../run/ball_on_prism.h"
#include "process.h"

#include <csignal>
#include <nlohmann/json.hpp>

namespace test_stress_command {

using namespace tumble::test;
namespace fs = std::filesystem;

TEST_CASE("stress runs a scene, keeps its loads, solves them, and solves them again without running") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    const Outcome first = tumble_in(folder, {"stress", "ball.toml", "--every", "0.05", "--json"});
    REQUIRE_MESSAGE(first.code == 0, first.err);
    const auto facts = nlohmann::json::parse(first.out)["facts"];
    CHECK(facts["cases"]["value"] == 6);
    CHECK(facts["unbalance"]["value"] < 1e-10);
    for (const char* file :
         {"scene.toml", "contacts.csv", "means.csv", "touches.csv", "bulk.csv", "cases.csv", "slices.csv", "worst.vtu",
          "normal-stress.png", "surface-stress.png", "loads.png", "frames/frame_000005.tumble"})
        CHECK_MESSAGE(fs::file_size(folder.path / "out/ball-stress" / file) > 10, file);

    const std::string loads = content_of(folder.path / "out/ball-stress/contacts.csv");
    CHECK(tumble_in(folder, {"stress", "ball.toml"}).code == 2); // it holds loads already
    const Outcome again =
        tumble_in(folder, {"stress", "out/ball-stress", "--element", "standard", "--side", "+x", "--depth", "0.4",
                           "--lower", "0.5", "--edge", "2", "--out", "second", "--json"});
    REQUIRE_MESSAGE(again.code == 0, again.err);
    const auto second = nlohmann::json::parse(again.out)["facts"];
    CHECK(second.contains("normal_+x_0.4mm"));
    CHECK(second.contains("near_edges_+x_0.4mm"));
    CHECK(second["touches"] == facts["touches"]);
    CHECK(content_of(folder.path / "out/ball-stress/contacts.csv") == loads);
    CHECK(fs::exists(folder.path / "second/slices.csv"));
    const Outcome drawn = tumble_in(folder, {"stress", "out/ball-stress", "--side", "+x", "--depth", "0.4", "--out",
                                             "third", "--pictures", "--show", "compression", "--json"});
    REQUIRE_MESSAGE(drawn.code == 0, drawn.err);
    for (const char* file : {"part.png", "cut-along.png", "cut-across.png", "slice-+x-0.4mm.png"})
        CHECK_MESSAGE(fs::file_size(folder.path / "third" / file) > 1000, file);

    const Outcome exported = tumble_in(folder, {"export", "out/ball-stress", "--to", "calculix"});
    REQUIRE_MESSAGE(exported.code == 0, exported.err);
    const std::string model = content_of(folder.path / "out/ball-stress/part.inp");
    CHECK(contains(model, "*ELEMENT, TYPE=C3D8I, ELSET=PART"));
    std::size_t steps = 0;
    for (std::size_t at = model.find("*STEP"); at != std::string::npos; at = model.find("*STEP", at + 1))
        ++steps;
    CHECK(steps == 6);
    CHECK(tumble_in(folder, {"export", "out/ball-stress", "--to", "calculix"}).code == 2); // is there already
    const Outcome one = tumble_in(
        folder, {"export", "out/ball-stress", "--to", "calculix", "--time", "0.09:0.11", "--out", "one.inp", "--json"});
    REQUIRE_MESSAGE(one.code == 0, one.err);
    CHECK(nlohmann::json::parse(one.out)["steps"] == 1);
    const Outcome none =
        tumble_in(folder, {"export", "out/ball-stress", "--to", "calculix", "--time", "7:8", "--out", "none.inp"});
    CHECK(none.code == 2);
    CHECK_MESSAGE(contains(none.err, "no load case within '7:8'"), none.err);

    const Outcome other = tumble_in(folder, {"stress", "out/ball-stress", "--part", "floor", "--out", "other"});
    CHECK(other.code == 2);
    CHECK_MESSAGE(contains(other.err, "holds loads on 'part', not on 'floor'"), other.err);
}

TEST_CASE("stress goes on where it was stopped, and solves the same contacts on another mesh") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    const std::vector<std::string> every{"--every", "0.04"};
    const auto stress = [&](std::vector<std::string> words) {
        if (words.front() == "ball.toml") // a folder with loads has its instants
            words.insert(words.end(), every.begin(), every.end());
        words.insert(words.begin(), "stress");
        words.emplace_back("--json");
        const Outcome outcome = tumble_in(folder, words);
        REQUIRE_MESSAGE(outcome.code == 0, outcome.err);
        return nlohmann::json::parse(outcome.out)["facts"];
    };
    stress({"ball.toml", "--out", "whole"});
    stress({"ball.toml", "--out", "parts", "--set", "duration_s=0.13"});
    const auto rest = stress({"ball.toml", "--out", "parts", "--resume"});
    CHECK(rest["cases"]["value"] == 7);
    for (const char* file : {"contacts.csv", "means.csv", "touches.csv", "bulk.csv", "cases.csv"})
        CHECK_MESSAGE(content_of(folder.path / "parts" / file) == content_of(folder.path / "whole" / file), file);

    const auto finer = stress({"parts", "--out", "finer", "--remesh", "along=20", "--remesh", "middle_cells=8"});
    CHECK(finer["cases"]["value"] == 7);
    CHECK(finer["unbalance"]["value"] < 1e-10);
    const auto means = stress({"parts", "--out", "finer-means", "--remesh", "along=20", "--means"});
    CHECK(means["cases"]["value"] == 7);
    CHECK(means["unbalance"]["value"] < 1e-10);
    CHECK(means["patch_radius"]["value"] > 0);
    const auto kept = content_of(folder.path / "finer/cases.csv");
    for (const std::vector<std::string>& words : {std::vector<std::string>{"parts", "--remesh", "along=5"},
                                                  {"parts", "--remesh", "along=5", "--out", "finer"}}) {
        std::vector<std::string> all{"stress"};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome over = tumble_in(folder, all);
        CHECK(over.code == 2);
        CHECK_MESSAGE(contains(over.err, "--force replaces them"), over.err);
    }
    CHECK(content_of(folder.path / "finer/cases.csv") == kept);
    const Outcome late = tumble_in(folder, {"stress", "parts", "--resume"});
    CHECK(late.code == 2);
    CHECK_MESSAGE(contains(late.err, "--resume changes nothing there"), late.err);
    const Outcome early = tumble_in(folder, {"stress", "ball.toml", "--remesh", "along=20"});
    CHECK(early.code == 2);
    CHECK_MESSAGE(contains(early.err, "--remesh is for a folder with loads"), early.err);
}

TEST_CASE("Ctrl-C in stress is told beside the stresses of what was run, and what goes on from there") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    Process process(folder.path,
                    {"stress", "ball.toml", "--every", "0.01", "--set", "duration_s=60", "--out", "loads"});
    REQUIRE(eventually([&] { return fs::exists(folder.path / "loads/frames/frame_000002.tumble"); }));
    process.send(SIGINT);
    const Outcome stopped = process.wait();
    CHECK(stopped.code == 130);
    CHECK(contains(stopped.err,
                   "warning: stopped early; these are the stresses up to there. The same command with --resume"));
    CHECK(fs::exists(folder.path / "loads/cases.csv"));
    const Outcome again = tumble_in(folder, {"stress", "loads", "--out", "again", "--quiet"});
    CHECK_MESSAGE(again.code == 0, again.err);
    CHECK_MESSAGE(contains(again.err, "warning: the run in loads was stopped at"), again.err);
    CHECK_MESSAGE(contains(again.err, "`tumble stress SCENE --out loads --resume` goes on"), again.err);
}

TEST_CASE("stress says what it replaces, and replaces with --force alone what was solved otherwise") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    const Outcome first = tumble_in(folder, {"stress", "ball.toml", "--every", "0.1", "--out", "ball"});
    REQUIRE_MESSAGE(first.code == 0, first.err);
    CHECK_FALSE(contains(first.err, "replaces"));
    CHECK_FALSE(contains(first.err, "was stopped"));
    const std::string kept = content_of(folder.path / "ball/cases.csv");
    const Outcome same = tumble_in(folder, {"stress", "ball"});
    CHECK_MESSAGE(same.code == 0, same.err);
    CHECK_MESSAGE(contains(same.err, "replaces the stresses in ball: solved again with the same settings"), same.err);
    CHECK_FALSE(contains(same.err, "was stopped"));
    CHECK(content_of(folder.path / "ball/cases.csv") == kept);

    const Outcome other = tumble_in(folder, {"stress", "ball", "--element", "standard"});
    CHECK(other.code == 2);
    CHECK_MESSAGE(contains(other.err, "solved otherwise: element = incompatible, now standard"), other.err);
    CHECK_MESSAGE(contains(other.err, "--out DIR keeps both; --force replaces them"), other.err);
    CHECK(content_of(folder.path / "ball/cases.csv") == kept);
    const Outcome forced = tumble_in(folder, {"stress", "ball", "--element", "standard", "--force"});
    CHECK_MESSAGE(forced.code == 0, forced.err);
    CHECK_MESSAGE(contains(forced.err, "replaces the stresses in ball: element = incompatible, now standard"),
                  forced.err);
    CHECK(content_of(folder.path / "ball/cases.csv") != kept);

    fs::remove(folder.path / "ball/study.txt");
    const Outcome older = tumble_in(folder, {"stress", "ball", "--element", "standard"});
    CHECK(older.code == 2);
    CHECK_MESSAGE(contains(older.err, "solved before settings were kept"), older.err);
}

TEST_CASE("stress refuses scenes without a specimen, folders without loads, and changes to what was run") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    const auto refused = [&](const std::vector<std::string>& words, const std::string& sentence) {
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK_MESSAGE(contains(outcome.err, sentence), outcome.err);
    };
    refused({"stress", TUMBLE_ROOT "/scenes/drop.toml"}, "the scene has no specimen");
    refused({"stress", "."}, "holds no loads on a part");
    refused({"stress", ".", "--set", "seed=2"}, "is solved again as it was run");
    refused({"stress", "ball.toml", "--part", "prat"}, "no specimen is called 'prat'");
    refused({"stress", "ball.toml", "--element", "quadratic"}, "incompatible");
    refused({"stress", "ball.toml", "--side", "north"}, "north"); // before anything is run
    refused({"stress", "ball.toml", "--depth", "100"}, "the part ends");
    CHECK_FALSE(fs::exists(folder.path / "out"));
    refused({"export", ".", "--to", "calculix"}, "holds no loads on a part");
    refused({"export", ".", "--to", "abaqus"}, "calculix");
}

TEST_CASE("a stress run that goes on, or was killed, is not run over: --resume goes on with it") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    const std::vector<std::string> command{"stress", "ball.toml", "--every",       "0.01",  "--checkpoint-every",
                                           "0.01",   "--set",     "duration_s=60", "--out", "loads"};
    const auto with = [&](const std::string& flag) {
        std::vector<std::string> words = command;
        words.push_back(flag);
        return words;
    };
    const auto refused = [&](const std::vector<std::string>& words, const std::string& sentence) {
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK_MESSAGE(contains(outcome.err, sentence), outcome.err);
    };
    Process process(folder.path, command);
    REQUIRE(eventually([&] {
        std::error_code not_there_yet; // a state that is being replaced, say
        return fs::exists(folder.path / "loads/frames/frame_000003.tumble") &&
               !fs::is_empty(folder.path / "loads/state", not_there_yet) && !not_there_yet;
    }));
    for (const auto& words : {command, with("--force"), with("--resume"), {"stress", "loads"}})
        refused(words, "another run is going on in this folder");
    process.send(SIGKILL);
    process.wait();
    for (const char* file : {"scene.toml", "part.txt"}) // what it was
        CHECK_MESSAGE(fs::exists(folder.path / "loads" / file), file);
    refused(command, "holds a run that was killed before it came to its loads");
    refused(command, "--resume goes on with it, with --force replaces it");
    refused({"stress", "loads"}, "`tumble stress SCENE --out loads --resume` goes on with it");
    refused({"export", "loads", "--to", "calculix"}, "--resume` goes on with it");
    const std::string kept = content_of(folder.path / "loads/frames/frame_000003.tumble");
    Process resumed(folder.path, with("--resume"));
    REQUIRE(eventually([&] { return resumed.catches(SIGINT); }));
    const auto frames = count_files(folder.path / "loads/frames", ".tumble");
    REQUIRE(eventually([&] { return count_files(folder.path / "loads/frames", ".tumble") > frames; }));
    resumed.send(SIGINT);
    const Outcome outcome = resumed.wait();
    CHECK_MESSAGE(outcome.code == 130, outcome.err);
    CHECK(content_of(folder.path / "loads/frames/frame_000003.tumble") == kept);
    refused(command, "`tumble stress loads` solves them again, --force replaces them");
    fs::create_directory(folder.path / "notes");
    put(folder.path / "notes/mine.txt", "not of a run");
    refused({"stress", "ball.toml", "--out", "notes"}, "already holds something");
}

TEST_CASE("stress refuses before it runs what would leave no instant, and what cannot be written") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism); // 0.3 s
    const auto refused = [&](const std::vector<std::string>& words, const std::string& sentence) {
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 2);
        CHECK_MESSAGE(contains(outcome.err, sentence), outcome.err);
    };
    refused({"stress", "ball.toml", "--from", "8"}, "the run ends at 0.3 s, before it is to be looked at: --from 8");
    refused({"stress", "ball.toml", "--every", "5"},
            "no instant of --every 5 lies between 0 s and the run's end at 0.3 s");
    refused({"stress", "ball.toml", "--until", "0.2"}, "--until is for a folder with loads");
    refused({"stress", "ball.toml", "--depth", "0.5,1,0.5"}, "a slice 0.5 mm beneath '-x' is asked for twice");
    CHECK_FALSE(fs::exists(folder.path / "out/ball-stress"));
    REQUIRE(tumble_in(folder, {"stress", "ball.toml", "--every", "0.1", "--out", "ball"}).code == 0);
    refused({"stress", "ball", "--out", "/proc/self"}, "cannot be written"); // nobody can make a file there
}

TEST_CASE("a folder is solved again from a later instant on, and keeps its report and which run it is of") {
    const Folder folder;
    put(folder.path / "ball.toml", ball_on_prism);
    REQUIRE(tumble_in(folder, {"stress", "ball.toml", "--every", "0.1", "--out", "ball"}).code == 0);
    const Outcome late =
        tumble_in(folder, {"stress", "ball", "--from", "0.2", "--until", "0.25", "--out", "late", "--pictures"});
    REQUIRE_MESSAGE(late.code == 0, late.err);
    CHECK(contains(late.out, content_of(folder.path / "late/report.txt")));
    CHECK_MESSAGE(contains(late.out, "1 instants of the media, from 0.2 to 0.2 s"), late.out);
    const std::string settings = content_of(folder.path / "late/study.txt");
    CHECK_MESSAGE(contains(settings, "run = ../ball\nfrom_s = 0.2\nuntil_s = 0.25\n"), settings);
    const Outcome none = tumble_in(folder, {"stress", "ball", "--from", "7", "--out", "none"});
    CHECK(none.code == 2);
    CHECK_MESSAGE(contains(none.err, "the run has some from 0.1 to 0.3 s"), none.err);
    CHECK(content_of(folder.path / "ball/report.txt").size() > 100);

    // What --remesh finds wrong is its own, and its file lies where the command is given.
    const auto remeshed = [&](const std::string& set) {
        return tumble_in(folder, {"stress", "ball", "--remesh", set, "--out", "other"}).err;
    };
    CHECK_MESSAGE(contains(remeshed("alnog=20"), "--remesh alnog"), remeshed("alnog=20"));
    CHECK_MESSAGE(contains(remeshed("along"), "write --remesh KEY=VALUE"), remeshed("along"));
    CHECK_MESSAGE(contains(remeshed("inp=finer.inp"), "remesh"), remeshed("inp=finer.inp"));
}

} // namespace test_stress_command
