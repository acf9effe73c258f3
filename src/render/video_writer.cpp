#include "render/video_writer.h"

#include "base/child_process.h"
#include "base/ending.h"
#include "base/growing_file.h"
#include "base/text.h"
#include "render/file_swap.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fmt/core.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tumble::render {

using namespace std::chrono_literals;

struct VideoWriter::Inside {
    std::filesystem::path file;
    int width = 0; // as the pictures have it
    int height = 0;
    std::int64_t frames = 0;
    std::vector<std::uint8_t> rows; // one frame without the odd column and row
    std::unique_ptr<ChildProcess> encoder;
    Problems problems;

    Inside() = default;
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    ~Inside() { give_up(); }

    void give_up() {
        if (encoder) {
            encoder.reset();
            ::unlink(growing_name(file).c_str());
        }
    }
    Result<Done> fail(Problem problem) {
        give_up();
        problems = {std::move(problem)};
        return problems;
    }
    Result<Done> encoder_stopped();
};

static Problem missing(const std::filesystem::path& file) {
    return {.file = file.string(),
            .what = "the video cannot be written: there is no program ffmpeg",
            .fix = "install it (apt install ffmpeg), or take the frames as PNG files; those need no ffmpeg"};
}

static std::vector<std::string> encoder_words(const std::filesystem::path& file, int width, int height, double rate,
                                              bool h264) {
    std::vector<std::string> words{"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y"};
    const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
    add({"-f", "rawvideo", "-pixel_format", "rgba", "-video_size", fmt::format("{}x{}", width, height)});
    add({"-framerate", fmt::format("{}", rate), "-i", "pipe:0", "-an"});
    // Without these players guess the matrix from the height and shift the colours of the legend.
    add({"-vf", "scale=in_range=full:out_range=tv:out_color_matrix=bt709:flags=accurate_rnd+full_chroma_int,"
                "format=yuv420p"});
    add({"-color_range", "tv", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"});
    if (h264) {
        add({"-c:v", "libx264", "-preset", "medium", "-crf", "19"});
    } else {
        add({"-c:v", "mpeg4", "-q:v", "3"});
    }
    add({"-movflags", "+faststart", "-f", "mp4", "file:" + file.string()});
    return words;
}

std::optional<Problem> refuse_video_name(const std::filesystem::path& file) {
    if (ending_of(file) == ".mp4") {
        return std::nullopt;
    }
    return Problem{.file = file.string(),
                   .what = "a video is an MP4 file, and this name has another ending",
                   .fix = "call it " + std::filesystem::path(file).replace_extension(".mp4").string()};
}

Result<VideoWriter> VideoWriter::open(const std::filesystem::path& file, int width, int height,
                                      double frames_per_second) {
    if (width < 2 || height < 2 || !(frames_per_second > 0)) {
        return Problem{.file = file.string(),
                       .what = fmt::format("a video of {} x {} pixels at {} frames a second cannot be written", width,
                                           height, frames_per_second),
                       .fix = "take at least 2 x 2 pixels and a positive rate"};
    }
    if (const auto problem = refuse_video_name(file)) {
        return *problem;
    }
    ChildProcess asked({"ffmpeg", "-hide_banner", "-nostdin", "-h", "encoder=libx264"});
    if (asked.error() == ENOENT) {
        return missing(file);
    }
    if (asked.error() != 0) {
        return file_problem(file, "start ffmpeg for the video", asked.error());
    }
    asked.wait(20s);
    const bool h264 = asked.printed().find("Encoder libx264") != std::string::npos;
    const std::filesystem::path growing = growing_name(file);
    const int probe = ::open(growing.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (probe < 0) {
        return file_problem(file, "write the video", errno);
    }
    ::close(probe);
    auto inside = std::make_unique<Inside>();
    inside->file = file;
    inside->width = width;
    inside->height = height;
    inside->encoder =
        std::make_unique<ChildProcess>(encoder_words(growing, width & ~1, height & ~1, frames_per_second, h264));
    if (inside->encoder->error() != 0) {
        return file_problem(file, "start ffmpeg for the video", inside->encoder->error());
    }
    return VideoWriter(std::move(inside));
}

VideoWriter::VideoWriter(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<Done> VideoWriter::Inside::encoder_stopped() {
    encoder->wait(5s);
    const std::string printed = encoder->printed();
    // The first line names the cause, the others what came of it.
    const std::string words = excerpt(split(trimmed(printed), '\n').front(), 300);
    const bool full = printed.find("No space left") != std::string::npos;
    return fail({.file = file.string(),
                 .what = "ffmpeg stopped writing the video" + (words.empty() ? "" : ": " + words),
                 .fix = full ? "free some space, or write to another disk; PNG frames are not touched by this"
                             : "try the frames as PNG files, and ffmpeg on them by hand to see more"});
}

Result<Done> VideoWriter::add(const Picture& picture) {
    Inside& in = *inside_;
    if (!in.problems.empty()) {
        return in.problems;
    }
    const std::size_t row = 4 * static_cast<std::size_t>(in.width);
    if (!in.encoder || picture.width != in.width || picture.height != in.height ||
        picture.rgba.size() != row * static_cast<std::size_t>(in.height)) {
        return in.fail({.file = in.file.string(),
                        .what = fmt::format("a picture of {} x {} pixels does not fit a video of {} x {}",
                                            picture.width, picture.height, in.width, in.height),
                        .fix = "draw all frames of a video in one size"});
    }
    const std::size_t kept = 4 * static_cast<std::size_t>(in.width & ~1);
    in.rows.clear();
    for (int y = 0; y < (in.height & ~1); ++y) {
        const auto begin = picture.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y;
        in.rows.insert(in.rows.end(), begin, begin + static_cast<std::ptrdiff_t>(kept));
    }
    if (!in.encoder->feed(in.rows)) {
        return in.encoder_stopped();
    }
    ++in.frames;
    return Done{};
}

Result<Done> VideoWriter::finish() {
    Inside& in = *inside_;
    if (!in.problems.empty()) {
        return in.problems;
    }
    if (!in.encoder && in.frames > 0) {
        return Done{};
    }
    if (in.frames == 0) {
        return in.fail({.file = in.file.string(),
                        .what = "a video without frames was not written",
                        .fix = "run longer, or take frames more often"});
    }
    if (in.encoder->wait(10min) != 0) {
        return in.encoder_stopped();
    }
    in.encoder.reset();
    const Result<Done> named = finish_file(in.file);
    in.problems = named.problems();
    return named;
}

std::int64_t VideoWriter::frames() const {
    return inside_->frames;
}

} // namespace tumble::render
