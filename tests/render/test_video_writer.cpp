#include "../video.h"
#include "base/child_process.h"
#include "fixtures.h"
#include "render/video_writer.h"

#include <chrono>
#include <csignal>
#include <cstdlib>

namespace test_video_writer {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;
using namespace std::chrono_literals;

namespace {

Picture flat(int width, int height, int shade) {
    Picture picture{width, height, {}};
    picture.rgba.assign(4U * static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                        static_cast<std::uint8_t>(shade));
    return picture;
}

/// PATH for as long as it lives.
struct Path {
    std::string before = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
    explicit Path(const std::string& now) { ::setenv("PATH", now.c_str(), 1); }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;
    ~Path() { ::setenv("PATH", before.c_str(), 1); }
};

/// A folder with a program `ffmpeg` of ours in it: a shell script.
void put_ffmpeg(const Folder& folder, const std::string& script) {
    const auto file = folder.path / "ffmpeg";
    std::FILE* out = std::fopen(file.c_str(), "w");
    REQUIRE(out != nullptr);
    std::fputs(("#!/bin/sh\n" + script + "\n").c_str(), out);
    std::fclose(out);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

} // namespace

TEST_CASE("a video has all its frames, even sides and square 4:2:0 pixels") {
    if (!test::can_check_videos()) {
        return;
    }
    const Folder folder;
    const auto file = folder.path / "a.mp4";
    auto video = VideoWriter::open(file, 161, 91, 25);
    REQUIRE(video.ok());
    for (int i = 0; i < 30; ++i) {
        REQUIRE(video->add(flat(161, 91, 8 * i)).ok());
    }
    CHECK(!std::filesystem::exists(file));
    CHECK(video->frames() == 30);
    CHECK(video->finish().ok());
    CHECK(video->finish().ok());
    CHECK(folder.files() == 1);
    CHECK(test::probed(file, "width,height,pix_fmt,nb_read_frames") == "160,90,yuv420p,30");
    CHECK(test::probed(file, "r_frame_rate") == "25/1");
    ChildProcess asked({"ffmpeg", "-hide_banner", "-encoders"});
    CHECK(asked.wait(20s) == 0);
    const bool h264 = asked.printed().find(" libx264 ") != std::string::npos;
    CHECK(test::probed(file, "codec_name") == (h264 ? "h264" : "mpeg4"));
}

TEST_CASE("a missing ffmpeg is reported with how to install it and that PNG frames stay") {
    const Folder folder;
    const Path path(folder.path.string());
    const auto video = VideoWriter::open(folder.path / "a.mp4", 64, 64, 25);
    REQUIRE(!video.ok());
    CHECK(video.problems().front().what == "the video cannot be written: there is no program ffmpeg");
    CHECK(video.problems().front().fix ==
          "install it (apt install ffmpeg), or take the frames as PNG files; those need no ffmpeg");
    CHECK(folder.files() == 0);
}

TEST_CASE("a folder that cannot be written is reported before anything is drawn") {
    const Folder programs;
    put_ffmpeg(programs, "exit 0");
    const Path path(programs.path.string());
    const auto video = VideoWriter::open(programs.path / "nowhere" / "a.mp4", 64, 64, 25);
    REQUIRE(!video.ok());
    CHECK(video.problems().front().what == "cannot write the video: No such file or directory");
}

TEST_CASE("an encoder that stops early is a problem with its words, not a signal and not a wait") {
    const Folder programs;
    const Folder folder;
    put_ffmpeg(programs, "echo 'No space left on device' >&2; exit 1");
    const Path path(programs.path.string());
    auto video = VideoWriter::open(folder.path / "a.mp4", 640, 360, 25);
    REQUIRE(video.ok());
    Result<Done> verdict = Done{};
    for (int i = 0; i < 200 && verdict.ok(); ++i) {
        verdict = video->add(flat(640, 360, i));
    }
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().what == "ffmpeg stopped writing the video: No space left on device");
    CHECK(verdict.problems().front().fix.find("free some space") == 0);
    CHECK(!video->add(flat(640, 360, 0)).ok());
    CHECK(!video->finish().ok());
    CHECK(folder.files() == 0);
}

TEST_CASE("an encoder that fails at the end leaves no file") {
    const Folder programs;
    const Folder folder;
    put_ffmpeg(programs, "/bin/cat > /dev/null; echo 'went wrong'; exit 3");
    const Path path(programs.path.string());
    auto video = VideoWriter::open(folder.path / "a.mp4", 64, 64, 25);
    REQUIRE(video.ok());
    CHECK(video->add(flat(64, 64, 9)).ok());
    const auto verdict = video->finish();
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().what == "ffmpeg stopped writing the video: went wrong");
    CHECK(folder.files() == 0);
}

TEST_CASE("a video that is given up, or has no frames, leaves no file") {
    const Folder programs;
    const Folder folder;
    put_ffmpeg(programs, "/bin/cat > /dev/null");
    const Path path(programs.path.string());
    {
        auto video = VideoWriter::open(folder.path / "a.mp4", 64, 64, 25);
        REQUIRE(video.ok());
        CHECK(video->add(flat(64, 64, 9)).ok());
    }
    CHECK(folder.files() == 0);
    auto video = VideoWriter::open(folder.path / "a.mp4", 64, 64, 25);
    REQUIRE(video.ok());
    const auto verdict = video->finish();
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().what == "a video without frames was not written");
    CHECK(folder.files() == 0);
}

TEST_CASE("a name with another ending than .mp4 is refused, for what is inside would not be what it says") {
    const Folder folder;
    for (const char* name : {"a.avi", "a", "a.mp4.gif"}) {
        const auto video = VideoWriter::open(folder.path / name, 64, 64, 25);
        REQUIRE(!video.ok());
        CHECK(video.problems().front().what == "a video is an MP4 file, and this name has another ending");
    }
    CHECK(VideoWriter::open(folder.path / "a.avi", 64, 64, 25).problems().front().fix ==
          "call it " + (folder.path / "a.mp4").string());
    CHECK(folder.files() == 0);
}

TEST_CASE("a frame of another size is refused") {
    const Folder programs;
    const Folder folder;
    put_ffmpeg(programs, "/bin/cat > /dev/null");
    const Path path(programs.path.string());
    auto video = VideoWriter::open(folder.path / "a.mp4", 64, 64, 25);
    REQUIRE(video.ok());
    const auto verdict = video->add(flat(64, 32, 1));
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().what == "a picture of 64 x 32 pixels does not fit a video of 64 x 64");
}

TEST_CASE("a program that takes nothing and does not end is killed after its time") {
    ChildProcess process({"/bin/sleep", "600"});
    REQUIRE(process.error() == 0);
    CHECK(process.wait(50ms) == -1);
}

} // namespace test_video_writer
