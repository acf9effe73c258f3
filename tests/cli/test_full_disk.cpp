#include "process.h"

#include <nlohmann/json.hpp>
#include <sys/mount.h>

namespace test_full_disk {

using namespace tumble::test;
namespace fs = std::filesystem;

namespace {

/// A disk of a given size; false where mounting is not allowed.
class SmallDisk {
public:
    SmallDisk(const fs::path& place, const std::string& size) : place_(place) {
        fs::create_directory(place);
        mounted_ = mount("tmpfs", place.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() {
        if (mounted_)
            umount(place_.c_str());
    }
    void grow(const std::string& size) const {
        REQUIRE(mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT, ("size=" + size).c_str()) == 0);
    }
    explicit operator bool() const {
        if (!mounted_)
            MESSAGE("skipped: mounting a small disk needs root");
        return mounted_;
    }

private:
    fs::path place_;
    bool mounted_ = false;
};

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

} // namespace

TEST_CASE("a disk that is too small for the frames is refused before the first step") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "100k");
    if (!disk)
        return;
    put(folder.path / "ball.toml", bouncing_ball(10)); // 1001 frames of more than 200 bytes
    const Outcome outcome = tumble_in(folder, {"run", "ball.toml", "--out", "disk/run"});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "the run will write at least"));
    CHECK(fs::is_empty(folder.path / "disk"));
}

TEST_CASE("a disk that runs full ends the run with code 1, whole files and the reason in run.json") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "400k");
    if (!disk)
        return;
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
        if (!disk)
            return;
        // A row is some 200 bytes; 101 frames of some 600 take a page of 4 KiB each.
        const std::vector<std::string> words{"run", "ball.toml", "--out", "disk/run", "--checkpoint-every", "1e-3"};
        CHECK(tumble_in(folder, words).code == 1);
        disk.grow("4m");
        std::vector<std::string> again = words;
        again.emplace_back("--resume");
        const Outcome outcome = tumble_in(folder, again);
        CHECK_MESSAGE(outcome.code == 0, outcome.err);
        CHECK(content_of(folder.path / "disk/run/series.csv") == content_of(folder.path / "whole/series.csv"));
        CHECK(files_in(folder.path / "disk/run/frames") == files_in(folder.path / "whole/frames"));
        for (const auto& entry : fs::directory_iterator(folder.path / "whole/frames"))
            CHECK(content_of(entry.path()) == content_of(folder.path / "disk/run/frames" / entry.path().filename()));
    }
}

TEST_CASE("a disk that runs full while a run is redrawn or exported has code 1, and advice that the command can take") {
    const Folder folder;
    const SmallDisk disk(folder.path / "disk", "20k");
    if (!disk)
        return;
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

} // namespace test_full_disk
