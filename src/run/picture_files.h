#pragma once

#include "base/problem.h"
#include "render/png_writer.h"
#include "render/video_writer.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>

namespace tumble::run {

/// Where pictures go; an empty path: nowhere.
struct PictureTargets {
    std::filesystem::path folder;    // PNG files frame_000000.png and so on
    std::filesystem::path video;     // MP4
    std::filesystem::path drawing{}; // SVG or PDF, of the last frame, in place of the others
};

/// One picture as a PNG file; makes the folder where it is missing. Problems: what the system says.
Result<Done> save(render::Picture picture, const std::filesystem::path& file);

/// Pictures of the settings' size on their way to PNG files, a video or both.
class PictureFiles {
public:
    /// Problems: a folder or video that cannot be made.
    static Result<PictureFiles> open(const scene::Render& settings, const PictureTargets& targets);

    /// Whether the picture of that number is to be drawn. `again`: for a run that goes on; what it left is not drawn
    /// twice, unless for a video, which cannot be added to and begins anew.
    [[nodiscard]] bool wants(std::int64_t number, bool again) const { return !again || video_ || !is_drawn(number); }
    /// Problems besides those of files: numbers or units that have no room in print.
    Result<Done> add(render::Picture picture, std::int64_t number, bool again = false);
    /// Waits until all is written.
    Result<Done> finish();

private:
    [[nodiscard]] std::filesystem::path file_of(std::int64_t number) const;
    [[nodiscard]] bool is_drawn(std::int64_t number) const;

    scene::Render settings_;
    std::filesystem::path folder_;
    std::optional<render::PngWriter> png_;
    std::optional<render::VideoWriter> video_;
};

} // namespace tumble::run
