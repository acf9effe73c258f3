#define DOCTEST_CONFIG_IMPLEMENT
#include "cli/process.h"

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sys/mount.h>

/// Disks that run full: small ones, which only root may mount. A program of its own, so that ctest tells that it was
/// left out where nobody may.
namespace test_full_disk {

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

bool mount_disk(const fs::path& place, const std::string& size) {
    return mount("tmpfs", place.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
}

bool may_mount() {
    const Folder folder;
    return mount_disk(folder.path, "100k") && umount(folder.path.c_str()) == 0;
}

/// A disk of a given size.
class SmallDisk {
public:
    SmallDisk(const fs::path& place, const std::string& size) : place_(place) {
        fs::create_directory(place);
        REQUIRE(mount_disk(place, size));
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() { umount(place_.c_str()); }
    void grow(const std::string& size) const {
        REQUIRE(mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT, ("size=" + size).c_str()) == 0);
    }

private:
    fs::path place_;
};

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

} // namespace

TEST_CASE("a disk that is too small for the frames is refused before the first step") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "100k");
    put(folder.path / "ball.toml", bouncing_ball(10)); // 1001 frames of more than 200 bytes
    const Outcome outcome = tumble_in(folder, {"run", "ball.toml", "--out", "disk/run"});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "the run will write at least"));
    CHECK(fs::is_empty(folder.path / "disk"));
}

TEST_CASE("a disk that runs full ends the run with code 1, whole files and the reason in run.json") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "400k");
    put(folder.path / "ball.toml", bouncing_ball(1)); // 101 pictures of some 10 kB
    const Outcome outcome = tumble_in(folder, {"run", "ball.toml", "--out", "disk/run", "--frames"});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "No space left on device"));
    const auto summary = nlohmann::json::parse(content_of(folder.path / "disk/run/run.json"));
    CHECK(summary["state"] == "failed");
    CHECK(contains(summary["reason"], "No space left on device"));
    const std::string series = content_of(folder.path / "disk/run/series.csv");
    CHECK(series.ends_with("\n"));
    for (const auto& entry : fs::recursive_directory_iterator(folder.path / "disk"))
        CHECK(entry.path().extension() != ".part");
    CHECK(summary["frames"] == files_in(folder.path / "disk/run/frames") - 1); // the layout is no frame
    CHECK(summary["pictures"] == files_in(folder.path / "disk/run/pictures"));
    const Outcome drawn = tumble_in(folder, {"render", "disk/run", "--out", "drawn", "--time", "0:0.01", "--quiet"});
    CHECK_MESSAGE(drawn.code == 0, drawn.err);
}

TEST_CASE("a run that a full disk ended goes on where there is room again, to the same bits") {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(1));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--out", "whole", "--quiet"}).code == 0);
    for (const char* size : {"120k", "200k", "280k"}) {
        const SmallDisk disk(folder.path / "disk", size);
        // A row is some 200 bytes; 101 frames of some 600 take a page of 4 KiB each.
        const std::vector<std::string> words{"run", "ball.toml", "--out", "disk/run", "--checkpoint-every", "1e-3"};
        CHECK(tumble_in(folder, words).code == 1);
        disk.grow("4m");
        std::vector<std::string> again = words;
        again.emplace_back("--resume");
        const Outcome outcome = tumble_in(folder, again);
        CHECK_MESSAGE(outcome.code == 0, outcome.err);
        const auto summary = nlohmann::json::parse(content_of(folder.path / "disk/run/run.json"));
        REQUIRE(summary["resumed"].size() == 1);
        CHECK(summary["resumed"][0]["step"] > 0);
        CHECK(content_of(folder.path / "disk/run/series.csv") == content_of(folder.path / "whole/series.csv"));
        CHECK(files_in(folder.path / "disk/run/frames") == files_in(folder.path / "whole/frames"));
        for (const auto& entry : fs::directory_iterator(folder.path / "whole/frames"))
            CHECK(content_of(entry.path()) == content_of(folder.path / "disk/run/frames" / entry.path().filename()));
    }
}

TEST_CASE("a disk that runs full while a run is redrawn or exported has code 1, and advice that the command can take") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "20k");
    put(folder.path / "ball.toml", bouncing_ball(2)); // 201 frames, some 200 bytes each as text
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"render", "out/ball", "--out", "disk/drawn"},
                                               {"export", "out/ball", "--vtk", "disk/vtk"},
                                               {"export", "out/ball", "--dump", "disk/all.dump"}}) {
        const Outcome outcome = tumble_in(folder, words);
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.err, "No space left on device"));
        CHECK_FALSE(outcome.err.find("--out") != std::string::npos);
        CHECK(fs::is_empty(folder.path / "disk"));
    }
}

TEST_CASE("a disk that runs full while a plot is drawn has code 1, and leaves no part of it" *
          doctest::skip(std::system("gnuplot --version >/dev/null 2>&1") != 0)) {
    const Folder folder;
    put(folder.path / "ball.toml", bouncing_ball(0.5));
    REQUIRE(tumble_in(folder, {"run", "ball.toml", "--quiet"}).code == 0);
    const SmallDisk disk(folder.path / "disk", "8k");
    for (const char* file : {"disk/a.png", "disk/a.svg", "disk/a.pdf"}) {
        const Outcome plotted = tumble_in(folder, {"plot", "out/ball", "--out", file});
        CHECK(plotted.code == 1);
        CHECK(contains(plotted.err, "as on a disk that is full"));
        CHECK(fs::is_empty(folder.path / "disk"));
    }
}

} // namespace test_full_disk

int main(int argc, char** argv) {
    if (!test_full_disk::may_mount()) {
        std::puts("skipped: mounting a small disk needs root");
        return 77;
    }
    return doctest::Context(argc, argv).run();
}
