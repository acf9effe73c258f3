#include "resumed.h"
#include "scenes.h"
#include "through.h"

#include <cerrno>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <mutex>
#include <set>

/// What a disk would still have after the power was cut, told by the order of the calls that reach it.
namespace test_lasting {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

std::string path_of(int file) {
    std::error_code error;
    return fs::read_symlink(fmt::format("/proc/self/fd/{}", file), error).string();
}

/// Contents and names that the system may still hold back: a file written to since it was last waited for, a folder
/// with a name changed since then.
struct Unsure {
    std::set<std::string> files, names;
};

struct Record {
    std::mutex lock; // frames are written beside the steps
    Unsure now;
    std::set<std::string> waited_for;
    std::map<std::string, Unsure> at_name;           // per checkpoint, when it got its name
    std::map<std::string, std::set<std::string>> of; // per checkpoint, what had been waited for by then
    bool state_named = false;                        // the run's folder was waited for with state/ in it
    int checkpoints = 0;

    static Record& self() {
        static Record record;
        return record;
    }

    void wrote(const std::string& file) { now.files.insert(file); }
    void synced(const std::string& place) {
        now.files.erase(place);
        now.names.erase(place);
        waited_for.insert(place);
        state_named = state_named || fs::is_directory(place + "/state");
    }
    void renamed(const std::string& from, const std::string& to) {
        if (to.ends_with(".ckpt")) {
            at_name[to] = now;
            of[to] = waited_for;
            ++checkpoints;
        }
        if (now.files.erase(from) > 0)
            now.files.insert(to);
        now.names.insert(fs::path(to).parent_path().string());
    }
};

DiskCalls recorded() {
    return {.write =
                [](int file, const void* bytes, std::size_t count) {
                    const std::lock_guard guard(Record::self().lock);
                    Record::self().wrote(path_of(file));
                    return ::write(file, bytes, count);
                },
            .sync =
                [](int file) {
                    const std::lock_guard guard(Record::self().lock);
                    Record::self().synced(path_of(file));
                    return ::fsync(file);
                },
            .rename =
                [](const char* from, const char* to) {
                    const std::lock_guard guard(Record::self().lock);
                    Record::self().renamed(from, to);
                    return std::rename(from, to);
                }};
}

std::atomic<int> calls{0}, first_failure{0};
std::atomic<bool> fails_once{false};

/// Whether this call is one that fails: from a number on, or that one alone.
bool fails_now() {
    const int number = calls++;
    errno = EIO;
    return fails_once ? number == first_failure : number >= first_failure;
}

struct Kind {
    const char* name;
    DiskCalls calls;
};

const std::vector<Kind> failing{
    {"fsync", {.sync = [](int file) { return fails_now() ? -1 : ::fsync(file); }}},
    {"rename", {.rename = [](const char* from, const char* to) { return fails_now() ? -1 : std::rename(from, to); }}},
    {"close", {.close = [](int file) {
         ::close(file);
         return fails_now() ? -1 : 0;
     }}}};

/// Rows and frames, which every run has.
std::map<std::string, std::string> seen_in(const fs::path& run) {
    std::map<std::string, std::string> content{{"series.csv", content_of(run / "series.csv")}};
    for (const auto& entry : fs::directory_iterator(run / "frames"))
        content[entry.path().filename().string()] = content_of(entry.path());
    return content;
}

std::ptrdiff_t told_of(const Outcome& outcome, const std::string& words) {
    return std::count_if(outcome.heard.begin(), outcome.heard.end(),
                         [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("when a checkpoint gets its name, the disk has it and all that it counts on; and then it gets the name") {
    const Folder folder;
    const fs::path root = fs::canonical(folder.path);
    put(root / "lid.stl", content_of(TUMBLE_ROOT "/tests/scene/data/tetrahedron.stl"));
    put(root / "pour.toml",
        pouring + "[[wall]]\nname = \"lid\"\nstl = \"lid.stl\"\nscale = 0.001\nmaterial = \"glass\"\n");
    const auto scene = scene::load_scene(root / "pour.toml", {{"duration_s=0.01"}});
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    const fs::path run = root / "made" / "for" / "it";
    run::RunOptions options = in(run);
    options.checkpoint_every = 1e-9;
    Record& record = Record::self();
    {
        const Through recording(recorded());
        REQUIRE(ran(*scene, options, 300).summary.state == "stopped");
        REQUIRE(ran(*scene, going_on_in(run)).summary.state == "finished"); // all of it is waited for again
    }
    CHECK(record.checkpoints > 10);
    for (const auto& [checkpoint, unsure] : record.at_name) {
        CAPTURE(checkpoint);
        for (const std::string& file : unsure.files)
            CHECK_MESSAGE(file.starts_with((run / "run.json").string()), file); // no resume needs it
        for (const std::string& place : unsure.names)
            CHECK_MESSAGE(place == run.string(), place); // of run.json, once a second
        const std::set<std::string>& waited_for = record.of[checkpoint];
        for (const fs::path& place :
             {run / "scene.toml", run / "meshes", run / "meshes/0.stl", run / "frames", run / "frames/layout.tumble",
              run / "frames/frame_000000.tumble", run / "series.csv", fs::path(checkpoint + ".part"), run,
              root / "made/for", root / "made", root})
            CHECK_MESSAGE(waited_for.contains(place.string()), place.string());
    }
    CHECK(record.state_named);
    CHECK_FALSE(record.now.names.contains((run / "state").string())); // the last one's name, too
}

TEST_CASE("whichever fsync, rename or close fails, once or from then on, no run is resumed to other bits") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring, {"duration_s=0.012"});
    run::RunOptions options = in(folder.path / "whole");
    options.checkpoint_every = 1e-9;
    for (const Kind& kind : failing) {
        CAPTURE(kind.name);
        fs::remove_all(folder.path / "whole");
        options.folder = folder.path / "whole";
        calls = 0;
        first_failure = never;
        {
            const Through counted(kind.calls);
            REQUIRE(ran(scene, options).summary.state == "finished");
        }
        const int all = calls;
        REQUIRE(all > 20);
        const auto whole = seen_in(folder.path / "whole");
        for (int k = 0; k < 12; ++k) {
            CAPTURE(k);
            const fs::path place = folder.path / kind.name / std::to_string(k);
            options.folder = place;
            fails_once = k % 2 == 0;
            first_failure = k < 6 ? k : all * (k - 5) / 7; // each of the first, and some of all the others
            calls = 0;
            Outcome broken;
            {
                const Through disk(kind.calls);
                broken = ran(scene, options); // refused, failed, or finished with a warning
            }
            const Outcome resumed = ran(scene, going_on_in(place));
            // Where not even the first checkpoint could be kept, there is nothing to go on from, and the run was told
            // so.
            if (!resumed.problems.empty() && run::list_checkpoints(place / "state").empty()) {
                CHECK(broken.summary.state == "finished");
                CHECK(told_of(broken, "no checkpoint could be written at t = 0 s") == 1);
            } else {
                CHECK_MESSAGE(resumed.summary.state == "finished", to_string(resumed.problems));
            }
            CHECK(seen_in(place) == whole);
        }
    }
}

TEST_CASE("a run whose rows the disk could not be made to keep writes no checkpoint that counts on them") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring, {"duration_s=0.012"});
    run::RunOptions options = in(folder.path / "pour");
    options.checkpoint_every = 1e-9;
    // Of the first checkpoint: the scene, the layout, the folder, the one above it, series, frame and frames, itself
    // and its folder. The second begins with the series.
    calls = 0;
    first_failure = 9;
    fails_once = true;
    {
        const Through disk(failing[0].calls);
        const Outcome outcome = ran(scene, options);
        CHECK(outcome.summary.state == "finished");
        CHECK(outcome.summary.checkpoints == 1);
        CHECK(told_of(outcome, "series.csv cannot be written: Input/output error") == 1);
    }
    CHECK(run::list_checkpoints(options.folder / "state").size() == 1);
}

} // namespace test_lasting
