#include "observe/array_file.h"
#include "observe/frame_file.h"
#include "resumed.h"
#include "run/build_mark.h"
#include "run/scene_changes.h"
#include "scene/to_toml.h"
#include "scenes.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace test_resume {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

TEST_CASE("a run that is stopped and resumed, however often, leaves the folder of one that never was") {
    for (const auto& [text, tracer] : {std::pair{pouring, "tracer:pair"}, std::pair{raining, "tracer:disc"}}) {
        const Folder folder;
        const scene::Scene scene = loaded(text, {fmt::format("observe.measures=[\"kinetic\", \"{}\"]", tracer)});
        run::RunOptions whole = in(folder.path / "whole"), parts = in(folder.path / "parts", 2);
        whole.pictures = whole.paraview = whole.text_dump = true;
        parts.pictures = parts.paraview = parts.text_dump = true;
        const Outcome once = ran(scene, whole);
        REQUIRE(once.summary.state == "finished");
        REQUIRE(once.summary.books.contacts > 20);

        CHECK(ran(scene, parts, 0).summary.state == "stopped"); // before the first step
        int resumed = 0;
        // From the first step, from one between two rows, and from where rows and frames are due.
        for (const std::int64_t step : {1, 3, 300, 1111, 1901, 2000}) {
            const Outcome more = ran(scene, going_on_in(parts.folder, 1 + ++resumed % 2), step);
            CHECK_MESSAGE(more.problems.empty(), to_string(more.problems));
            CHECK(more.summary.state == (step < 2000 ? "stopped" : "finished"));
        }
        check_same_run(whole.folder, parts.folder);
        CHECK(fs::exists(parts.folder / "pictures" / "frame_000007.png"));
        const auto json = summary_in(parts.folder), of_whole = summary_in(whole.folder);
        for (const char* key : {"rows", "frames", "pictures", "steps", "bodies", "energy_closure_J",
                                "energy_turnover_J", "overlap_ratio_max", "warnings"})
            CHECK_MESSAGE(json[key] == of_whole[key], key);
        REQUIRE(json["resumed"].size() == 6);
        CHECK(json["resumed"][0]["checkpoint"] == "state/step_000000000000.ckpt");
        CHECK(json["resumed"][3]["step"] >= 300);
        CHECK(of_whole["resumed"].empty());
    }
}

TEST_CASE("checkpoints at every turn change nothing of a run, and two of them are kept") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    run::RunOptions often = in(folder.path / "often", 2), seldom = in(folder.path / "seldom"),
                    none = in(folder.path / "none");
    often.checkpoint_every = 1e-9;
    none.checkpoint_every = 0;
    CHECK(ran(scene, often).summary.checkpoints > 40);
    CHECK(ran(scene, seldom).summary.checkpoints == 2); // at the start and at the end
    CHECK(ran(scene, none).summary.checkpoints == 0);
    check_same_run(often.folder, seldom.folder);
    CHECK(run::list_checkpoints(often.folder / "state").size() == 2);
    CHECK_FALSE(fs::exists(none.folder / "state"));
    CHECK(content_of(none.folder / "series.csv") == content_of(seldom.folder / "series.csv"));
}

TEST_CASE("a finished run goes on to a longer end, and to the same end without a change") {
    const Folder folder;
    const scene::Scene shorter = loaded(pouring, {"duration_s=0.0203"}), longer = loaded(pouring);
    REQUIRE(ran(longer, in(folder.path / "whole")).summary.state == "finished");
    REQUIRE(ran(shorter, in(folder.path / "parts")).summary.frames == 5); // the last between two multiples
    const auto before = content_of_run(folder.path / "parts");
    CHECK(ran(shorter, going_on_in(folder.path / "parts")).summary.state == "finished");
    CHECK(content_of_run(folder.path / "parts") == before);
    CHECK(ran(longer, going_on_in(folder.path / "parts")).summary.state == "finished");
    check_same_run(folder.path / "whole", folder.path / "parts");

    const Outcome back = ran(shorter, going_on_in(folder.path / "parts"));
    REQUIRE(!back.problems.empty());
    CHECK(back.problems.front().what.find("beyond the end of the run at 0.0203 s") != std::string::npos);
    CHECK(back.problems.front().fix == "give a longer --duration");
    check_same_run(folder.path / "whole", folder.path / "parts");

    // An end at which a frame is due anyway gets no second one.
    const scene::Scene even = loaded(pouring, {"duration_s=0.012"});
    REQUIRE(ran(even, in(folder.path / "even")).summary.frames == 3);
    CHECK(ran(even, going_on_in(folder.path / "even")).summary.frames == 3);
}

TEST_CASE("a finished run is one whose series is whole: rows that it did not write go, lost ones are told of") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    const fs::path place = folder.path / "pour";
    REQUIRE(ran(scene, in(place)).summary.state == "finished");
    const auto before = content_of_run(place);
    const std::string series = content_of(place / "series.csv");
    put(place / "series.csv", series + "0.9,1,2\n");
    CHECK(ran(scene, going_on_in(place)).summary.state == "finished");
    CHECK(content_of_run(place) == before);
    fs::remove(place / "series.csv");
    const Problems problems = ran(scene, going_on_in(place)).problems;
    REQUIRE(problems.size() == 2); // one a checkpoint
    for (const Problem& problem : problems)
        CHECK(problem.what == "counts on rows of series.csv that are not there");
    put(place / "series.csv", series);
    CHECK(content_of_run(place) == before);
}

TEST_CASE("pictures that are missing or stand beyond the checkpoint are put right") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    run::RunOptions whole = in(folder.path / "whole"), parts = in(folder.path / "parts");
    whole.pictures = parts.pictures = true;
    REQUIRE(ran(scene, whole).problems.empty());
    REQUIRE(ran(scene, parts, 700).problems.empty());
    fs::remove(parts.folder / "pictures" / "frame_000001.png");
    for (const char* name : {"pictures/frame_000005.png", "pictures/frame_000006.png.part",
                             "frames/frame_000006.tumble", "frames/frame_000009.tumble.part", "state/x.ckpt.part"})
        put(parts.folder / name, "of a run that was killed");
    put(parts.folder / "series.csv", content_of(parts.folder / "series.csv") + "0.9,1,2\n0.99,");
    CHECK(ran(scene, going_on_in(parts.folder)).problems.empty());
    check_same_run(whole.folder, parts.folder);
}

TEST_CASE("of two checkpoints the older is taken when the newer is damaged, with a word") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    REQUIRE(ran(scene, in(folder.path / "whole")).problems.empty());
    const fs::path parts = folder.path / "parts";
    REQUIRE(ran(scene, in(parts), 1000).problems.empty());
    REQUIRE(run::list_checkpoints(parts / "state").size() == 2);
    const fs::path file = newest(parts);
    const std::string good = content_of(file);
    std::string bad = good, said;
    SUBCASE("cut off") {
        bad.resize(good.size() / 2);
        said = "is cut off or was changed: its checksum does not fit";
    }
    SUBCASE("empty") {
        bad.clear();
        said = "is no tumble file (its first eight bytes differ)";
    }
    SUBCASE("one bit changed") {
        bad[good.size() / 2] = static_cast<char>(bad[good.size() / 2] ^ 4);
        said = "is cut off or was changed: its checksum does not fit";
    }
    SUBCASE("of another version of the format") {
        bad[8] = 2;
        said = "has version 2 of the format, this program reads version 1";
    }
    SUBCASE("something else") {
        bad = content_of(parts / "frames" / "frame_000000.tumble");
        said = "holds a 'frame', not a 'checkpoint'";
    }
    put(file, bad);
    const Outcome outcome = ran(scene, going_on_in(parts));
    CHECK(outcome.summary.state == "finished");
    REQUIRE_FALSE(outcome.heard.empty());
    CHECK(outcome.heard[0] == "a newer checkpoint was left out: " + file.filename().string() + ": " + said);
    check_same_run(folder.path / "whole", parts);
}

TEST_CASE("a checkpoint of another build of the program is gone on from, with a word") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    const fs::path place = folder.path / "pour";
    REQUIRE(ran(scene, in(place), 1000).problems.empty());
    CHECK(summary_in(place)["build_mark"] == run::build_mark());
    for (const std::string& sentence : ran(scene, going_on_in(place), 1200).heard)
        CHECK_FALSE(sentence.starts_with("the checkpoint was written by"));
    const fs::path file = newest(place);
    auto content = observe::from_bytes(content_of(file), "checkpoint", file);
    REQUIRE(content.ok());
    CHECK(content->head["build_mark"] == run::build_mark());
    content->head["build_mark"] = "0123456789abcdef";
    put(file, observe::to_bytes(*content));
    const Outcome outcome = ran(scene, going_on_in(place));
    CHECK(outcome.summary.state == "finished");
    REQUIRE_FALSE(outcome.heard.empty());
    CHECK(outcome.heard[0] == "the checkpoint was written by another build of the program (0123456789abcdef, this is " +
                                  run::build_mark() +
                                  "): the run goes on from it, but need not end in the bits of one that never stopped");
    const auto json = summary_in(place);
    CHECK(std::count(json["warnings"].begin(), json["warnings"].end(), outcome.heard[0]) == 1);
    CHECK(json["resumed"][0]["build_mark"] == run::build_mark());
    CHECK(json["resumed"][1]["build_mark"] == "0123456789abcdef");
}

TEST_CASE("the mark of the build is that of the sources it was made from") {
    // 16 digits: 64 bits of a hash that cmake/build_mark.cmake takes over names and contents.
    CHECK(run::build_mark().size() == 16);
    CHECK(run::build_mark().find_first_not_of("0123456789abcdef") == std::string::npos);
}

TEST_CASE("without a checkpoint that can be used a resume is refused, and the folder stays as it is") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    const fs::path place = folder.path / "pour";
    REQUIRE(ran(scene, in(place), 1000).problems.empty());
    const std::string series = content_of(place / "series.csv");
    SUBCASE("both damaged") {
        for (const fs::path& file : run::list_checkpoints(place / "state"))
            put(file, "x");
        CHECK(ran(scene, going_on_in(place)).problems.size() == 2);
    }
    SUBCASE("of a program that keeps other things") {
        for (const fs::path& file : run::list_checkpoints(place / "state")) {
            auto content = observe::from_bytes(content_of(file), "checkpoint", file);
            REQUIRE(content.ok());
            content->head["layout"] = "0";
            content->head["version"] = "9.9";
            put(file, observe::to_bytes(*content));
        }
        const Problems problems = ran(scene, going_on_in(place)).problems;
        REQUIRE(problems.size() == 2);
        CHECK(problems[0].what.starts_with("was written by version '9.9' of the program, this is version '"));
        CHECK(problems[0].fix == "go on with the program that wrote it, or run the scene again");
    }
    SUBCASE("none at all") {
        fs::remove_all(place / "state");
        const Problems problems = ran(scene, going_on_in(place)).problems;
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "holds no checkpoint to go on from");
    }
    SUBCASE("of the other solver") {
        const Problems problems = ran(loaded(raining), going_on_in(place)).problems;
        REQUIRE_FALSE(problems.empty());
        CHECK(to_string(problems).find("dimension was 3 and is now 2") != std::string::npos);
    }
    SUBCASE("rows of the series are gone") {
        put(place / "series.csv", series.substr(0, 100));
        for (const fs::path& file : run::list_checkpoints(place / "state"))
            if (file != newest(place))
                fs::remove(file);
        const Problems problems = ran(scene, going_on_in(place)).problems;
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "counts on rows of series.csv that are not there");
        put(place / "series.csv", series);
    }
    CHECK(content_of(place / "series.csv") == series);
    CHECK_FALSE(fs::exists(place / ".reserve"));
}

TEST_CASE("a scene that was changed is refused with what changed, unless told to go on") {
    const Folder folder;
    const fs::path place = folder.path / "pour";
    REQUIRE(ran(loaded(pouring), in(place), 500).problems.empty());
    const auto refused = [&](const std::string& set) {
        const Outcome outcome = ran(loaded(pouring, {set}), going_on_in(place));
        REQUIRE(outcome.problems.size() == 1);
        return outcome.problems[0];
    };
    const Problem friction = refused("pair.glass-glass.friction=0.2");
    CHECK(friction.what.starts_with("the scene was changed after t = "));
    CHECK(friction.what.ends_with("s: pair.glass-glass.friction was 0.4 and is now 0.2"));
    CHECK(friction.fix == "put it back, or say --accept-changes to go on with it as it is now");
    for (const char* set : {"time_step_s=1e-5", "material.glass.density_kg_m3=2400", "fill.0.count=50",
                            "observe.measures=[\"kinetic\"]", "seed=6", "wall.left.point_m=[0, 0, -0.019]"})
        CHECK(refused(set).fix ==
              "put it back: this cannot change in the midst of a run; --out DIR runs the new scene elsewhere");

    run::RunOptions told = going_on_in(place);
    told.accept_changes = true;
    const scene::Scene changed = loaded(pouring, {"pair.glass-glass.friction=0.2", "title=\"Other\""});
    CHECK(ran(loaded(pouring, {"seed=6"}), told).problems.size() == 1);
    CHECK(ran(changed, told).summary.state == "finished");
    CHECK(summary_in(place)["resumed"][0]["changes"] ==
          nlohmann::json::array({"pair.glass-glass.friction was 0.4 and is now 0.2"}));
    CHECK(content_of(place / "scene.toml").find("friction = 0.2") != std::string::npos);
}

TEST_CASE("a scene of soft discs is the same one where an older program wrote of it what only hard discs read") {
    const std::string now = scene::to_toml(loaded(raining));
    const std::string before = now + "[box2d]\nvelocity_iterations = 8\n";
    run::Checkpoint checkpoint;
    checkpoint.scene = before;
    const auto judged = run::judge_changes(checkpoint, now, {}, false, "scene.toml");
    REQUIRE_MESSAGE(judged.ok(), to_string(judged.problems()));
    CHECK(judged->empty());
    const auto changes = run::changes_of_motion(before, now);
    REQUIRE(changes.ok());
    CHECK(changes->empty());
    const auto others = run::changes_of_motion(before, now + "[box2d]\nvelocity_iterations = 9\n");
    REQUIRE(others.ok());
    CHECK(*others == std::vector<std::string>{"box2d.velocity_iterations was 8 and is now 9"});
}

TEST_CASE("laws that remember more may be taken up or left in the midst of a run, where changes are accepted") {
    const std::vector<std::string> nothing;
    for (const std::vector<std::string>& added :
         {std::vector<std::string>{"contact.rolling=\"epsd\"", "pair.glass-glass.rolling_friction=0.1"},
          {"contact.adhesion=\"jkr\"", "pair.glass-glass.work_of_adhesion_J_m2=0.1"},
          {"pair.glass-glass.restitution_exponent=0.2", "pair.glass-glass.restitution_speed_m_s=1"}})
        for (const bool taken_up : {true, false}) {
            CAPTURE(added[0]);
            CAPTURE(taken_up);
            const Folder folder;
            run::RunOptions options = in(folder.path / "pour");
            REQUIRE(ran(loaded(pouring, taken_up ? nothing : added), options, 900).problems.empty());
            options = going_on_in(options.folder);
            const scene::Scene changed = loaded(pouring, taken_up ? added : nothing);
            CHECK_FALSE(ran(changed, options).problems.empty());
            options.accept_changes = true;
            const Outcome outcome = ran(changed, options);
            CHECK_MESSAGE(outcome.summary.state == "finished", to_string(outcome.problems));
            CHECK(outcome.summary.resumed.back().changes.size() >= 1);
        }
}

TEST_CASE("how long a run is and what is drawn may change freely") {
    const Folder folder;
    const fs::path place = folder.path / "pour";
    REQUIRE(ran(loaded(pouring), in(place), 500).problems.empty());
    const scene::Scene other = loaded(
        pouring, {"render.every_s=0.002", "render.background=\"white\"", "duration_s=0.03", "observe.every_s=0.0005"});
    const Outcome outcome = ran(other, going_on_in(place));
    CHECK_MESSAGE(outcome.summary.state == "finished", to_string(outcome.problems));
    CHECK(outcome.summary.steps == 1500);
    const auto layout = observe::read_layout(observe::layout_path(place / "frames"));
    REQUIRE(layout.ok());
    double last = -1;
    for (const fs::path& file : observe::list_frames(place / "frames")) {
        const auto frame = observe::read_frame(file, *layout);
        REQUIRE(frame.ok());
        CHECK(frame->time > last);
        last = frame->time;
    }
}

TEST_CASE("a resume begins where there is no run, or one that was killed before its first checkpoint") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    REQUIRE(ran(scene, in(folder.path / "whole")).problems.empty());
    CHECK(ran(scene, going_on_in(folder.path / "fresh")).summary.state == "finished");
    check_same_run(folder.path / "whole", folder.path / "fresh");

    const fs::path killed = folder.path / "killed";
    REQUIRE(ran(scene, in(killed), 0).problems.empty());
    fs::remove_all(killed / "state");
    put(killed / ".reserve", "");
    CHECK(ran(scene, going_on_in(killed)).summary.state == "finished");
    check_same_run(folder.path / "whole", killed);

    fs::create_directory(folder.path / "mine");
    put(folder.path / "mine" / "notes.txt", "mine");
    CHECK(ran(scene, going_on_in(folder.path / "mine")).problems.size() == 1);
    CHECK(content_of(folder.path / "mine" / "notes.txt") == "mine");
}

TEST_CASE("a folder in which a run is going on is refused to a second one") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    struct Second : run::RunListener {
        const scene::Scene* scene = nullptr;
        fs::path place;
        Problems resumed, forced;
        void progressed(const run::Progress& now) override {
            if (now.step < 1000 || !resumed.empty())
                return;
            run::RunListener silent;
            run::RunOptions options = going_on_in(place);
            resumed = run::run_scene(*scene, options, silent).problems();
            options.resume = false;
            options.overwrite = true;
            forced = run::run_scene(*scene, options, silent).problems();
        }
    } second;
    second.scene = &scene;
    second.place = folder.path / "pour";
    const auto first = run::run_scene(scene, in(second.place), second);
    REQUIRE(first.ok());
    CHECK(first->state == "finished");
    for (const Problems& problems : {second.resumed, second.forced}) {
        REQUIRE(problems.size() == 1);
        CHECK(problems[0].what == "another run is going on in this folder");
    }
    REQUIRE(ran(scene, in(folder.path / "alone")).problems.empty());
    check_same_run(folder.path / "alone", second.place);
}

} // namespace test_resume
