#include "resumed.h"
#include "scenes.h"
#include "through.h"

#include <cerrno>
#include <doctest/doctest.h>
#include <new>
#include <string_view>
#include <unistd.h>

namespace test_broken_off {

using namespace tumble;
using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

std::atomic<int> writes{0};
std::atomic<int> first_failure{0};
std::atomic<int> error_given{0};

/// Works as write(2) up to a call, and from then on puts down half of what it is given, and then nothing.
ssize_t failing_write(int file, const void* bytes, std::size_t count) {
    const int number = writes++;
    if (number < first_failure)
        return ::write(file, bytes, count);
    if (number == first_failure && count > 1)
        return ::write(file, bytes, count / 2);
    errno = error_given;
    return -1;
}

ssize_t short_write(int file, const void* bytes, std::size_t count) {
    return ::write(file, bytes, std::min<std::size_t>(count, 1000));
}

std::atomic<int> dumps{0};
std::atomic<int> full{-1}; // the file whose disk is full

/// Puts down half of the third frame of spheres.dump, and then nothing more of that file.
ssize_t disk_full_in_third_dump(int file, const void* bytes, std::size_t count) {
    if (file == full) {
        errno = ENOSPC;
        return -1;
    }
    const std::string_view text(static_cast<const char*>(bytes), count);
    if (!text.starts_with("ITEM: TIMESTEP") || ++dumps != 3)
        return ::write(file, bytes, count);
    full = file;
    return ::write(file, bytes, count / 2);
}

} // namespace

TEST_CASE("whichever write fails first, the run is resumed later to the same bits") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    run::RunOptions options = in(folder.path / "whole");
    options.checkpoint_every = 1e-9;
    first_failure = never;
    writes = 0;
    {
        const Through counted({.write = failing_write});
        REQUIRE(ran(scene, options).summary.state == "finished");
    }
    const int all = writes;
    REQUIRE(all > 60);
    for (int k = 0; k < 24; ++k) {
        const fs::path place = folder.path / std::to_string(k);
        options.folder = place;
        error_given = k % 2 == 0 ? ENOSPC : EIO;
        first_failure = k < 12 ? k : all * (k - 11) / 13; // each of the first, and some of all the others
        writes = 0;
        {
            const Through broken({.write = failing_write});
            (void)ran(scene, options); // refused, failed, or finished with a warning
        }
        const Outcome outcome = ran(scene, going_on_in(place));
        CHECK_MESSAGE(outcome.summary.state == "finished", k << ": " << to_string(outcome.problems));
        check_same_run(folder.path / "whole", place);
        fs::remove_all(place);
    }
}

TEST_CASE("writes that the system cuts short change nothing") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    REQUIRE(ran(scene, in(folder.path / "whole")).problems.empty());
    {
        const Through pieces({.write = short_write});
        REQUIRE(ran(scene, in(folder.path / "pieces"), 1000).problems.empty());
        REQUIRE(ran(scene, going_on_in(folder.path / "pieces")).problems.empty());
    }
    check_same_run(folder.path / "whole", folder.path / "pieces");
}

TEST_CASE("a checkpoint that cannot be written is told of once, and the run goes on") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    run::RunOptions options = in(folder.path / "pour");
    options.checkpoint_every = 1e-9;
    struct Spoiler : Stopper {
        Spoiler() : Stopper(never) {}
        fs::path place;
        void progressed(const run::Progress& now) override {
            if (now.step < 1000 || fs::is_regular_file(place / "state"))
                return;
            fs::rename(place / "state", place / "kept");
            put(place / "state", "in the way");
        }
    } spoiler;
    spoiler.place = options.folder;
    const auto summary = run::run_scene(scene, options, spoiler);
    REQUIRE(summary.ok());
    CHECK(summary->state == "finished");
    const std::string told = "no checkpoint could be written at t = 0.02";
    CHECK(std::count_if(spoiler.heard.begin(), spoiler.heard.end(),
                        [&](const std::string& sentence) { return sentence.starts_with(told); }) == 1);
    CHECK(summary->warnings == spoiler.heard);
}

TEST_CASE("a run that an exception breaks off is a failed one with whole files, and is resumed to the same bits") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    REQUIRE(ran(scene, in(folder.path / "whole")).summary.state == "finished");
    struct OutOfMemory : run::RunListener {
        void progressed(const run::Progress& now) override {
            if (now.step >= 1000)
                throw std::bad_alloc();
        }
    } listener;
    const fs::path place = folder.path / "broken";
    const auto summary = run::run_scene(scene, in(place), listener);
    REQUIRE(summary.ok());
    CHECK(summary->state == "failed");
    REQUIRE(summary->reason.size() == 1);
    CHECK(summary->reason[0].what == "the run broke off at t = 0.02 s: there is not enough memory");
    const auto json = summary_in(place);
    CHECK(json["state"] == "failed");
    CHECK(json["reason"].get<std::string>().starts_with(summary->reason[0].what));
    CHECK(json["frames"] == 4); // of the steps 0, 300, 600 and 900
    CHECK_FALSE(fs::exists(place / ".reserve"));
    CHECK(ran(scene, going_on_in(place)).summary.state == "finished");
    check_same_run(folder.path / "whole", place);
}

TEST_CASE("a run that fails again before its next checkpoint names the one that it went on from") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    const fs::path place = folder.path / "broken";
    run::RunOptions options = in(place);
    options.checkpoint_every = 1e-9;
    REQUIRE(ran(scene, options, 1000).summary.state == "stopped");
    REQUIRE(run::list_checkpoints(place / "state").size() == 2);
    struct OutOfMemory : run::RunListener {
        void progressed(const run::Progress&) override { throw std::bad_alloc(); }
    } listener;
    const auto again = run::run_scene(scene, going_on_in(place), listener);
    REQUIRE(again.ok());
    CHECK(again->state == "failed");
    CHECK(again->checkpoint == newest(place).lexically_relative(place));
    CHECK(summary_in(place)["checkpoint"] == again->checkpoint.string());
}

TEST_CASE("of a frame that a full disk cuts off nothing stays in spheres.dump") {
    const Folder folder;
    const scene::Scene scene = loaded(pouring);
    run::RunOptions options = in(folder.path / "whole");
    options.text_dump = true;
    REQUIRE(ran(scene, options).summary.state == "finished");
    options.folder = folder.path / "cut";
    dumps = 0;
    full = -1;
    {
        const Through broken({.write = disk_full_in_third_dump});
        const Outcome outcome = ran(scene, options);
        CHECK(outcome.summary.state == "failed");
        REQUIRE_FALSE(outcome.summary.reason.empty());
        CHECK(outcome.summary.reason[0].what == "cannot be written: No space left on device");
    }
    const std::string whole = content_of(folder.path / "whole" / "spheres.dump");
    const std::size_t second = whole.find("ITEM: TIMESTEP", 1);
    CHECK(content_of(options.folder / "spheres.dump") == whole.substr(0, whole.find("ITEM: TIMESTEP", second + 1)));
}

} // namespace test_broken_off
