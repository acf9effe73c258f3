#pragma once

#include "base/problem.h"
#include "render/picture.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace tumble::render {

/// Why a video cannot have that name: it does not end in .mp4.
std::optional<Problem> refuse_video_name(const std::filesystem::path& file);

/// Turns pictures into an MP4 through the program ffmpeg: H.264 where it has libx264, MPEG-4 part 2 otherwise, 4:2:0,
/// colours marked as BT.709. The file appears under its name at finish(), never half-written.
class VideoWriter {
public:
    /// Sizes in pixels; an odd last column or row is left out, as 4:2:0 wants even sizes. Problems: ffmpeg is missing
    /// (pictures can be kept as PNG), the folder cannot be written, a size below 2 pixels.
    static Result<VideoWriter> open(const std::filesystem::path& file, int width, int height, double frames_per_second);
    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;
    /// Without finish() nothing of the video stays.
    ~VideoWriter();

    /// A picture of another size than opened with, and whatever made ffmpeg stop, is a problem.
    Result<Done> add(const Picture& picture);

    /// Waits for ffmpeg and names the file. A video without pictures is a problem, and no file.
    Result<Done> finish();

    [[nodiscard]] std::int64_t frames() const;

private:
    struct Inside;
    explicit VideoWriter(std::unique_ptr<Inside> inside);
    std::unique_ptr<Inside> inside_;
};

} // namespace tumble::render
