#pragma once

#include "base/problem.h"
#include "render/png_writer.h"
#include "render/video_writer.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tumble::run {

/// Where pictures go; an empty path: nowhere.
struct PictureTargets {
    std::filesystem::path folder;    // PNG files frame_000000.png and so on
    std::filesystem::path video;     // MP4
    std::filesystem::path drawing{}; // SVG or PDF, of the last frame, in place of the others
};

/// Looks whether bodies are to be seen in any of the pictures that belong together.
class BareWatch {
public:
    void take(render::Bare bare) {
        seen_ = seen_ || bare == render::Bare::no;
        first_ = pictures_++ == 0 ? bare : first_;
    }
    /// One where there are pictures, and none of them shows a body.
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    std::int64_t pictures_ = 0;
    bool seen_ = false;
    render::Bare first_ = render::Bare::no;
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
    [[nodiscard]] std::vector<std::string> warnings() const { return watch_.warnings(); }

private:
    [[nodiscard]] std::filesystem::path file_of(std::int64_t number) const;
    [[nodiscard]] bool is_drawn(std::int64_t number) const;

    scene::Render settings_;
    BareWatch watch_;
    std::filesystem::path folder_;
    std::optional<render::PngWriter> png_;
    std::optional<render::VideoWriter> video_;
};

} // namespace tumble::run
