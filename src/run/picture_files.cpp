#include "run/picture_files.h"

#include "base/make_folder.h"
#include "render/paper.h"

#include <fmt/format.h>

namespace tumble::run {

Result<Done> save(render::Picture picture, const std::filesystem::path& file) {
    if (const auto made = make_folder(std::filesystem::absolute(file).parent_path()); !made)
        return made.problems();
    render::PngWriter writer;
    if (auto added = writer.add(file, std::move(picture)); !added)
        return added;
    return writer.finish();
}

std::vector<std::string> BareWatch::warnings() const {
    if (pictures_ == 0 || seen_)
        return {};
    return {render::bare_words(first_, pictures_ == 1 ? "this picture" : "any of these pictures")};
}

Result<PictureFiles> PictureFiles::open(const scene::Render& settings, const PictureTargets& targets) {
    PictureFiles files;
    files.settings_ = settings;
    files.folder_ = targets.folder;
    if (!targets.folder.empty()) {
        if (const auto made = make_folder(targets.folder); !made)
            return made.problems();
        files.png_.emplace();
    }
    if (!targets.video.empty()) {
        auto opened =
            render::VideoWriter::open(targets.video, settings.width, settings.height, settings.frames_per_second);
        if (!opened)
            return opened.problems();
        files.video_ = std::move(*opened);
    }
    return files;
}

Result<Done> PictureFiles::add(render::Picture picture, std::int64_t number, bool again) {
    if (auto room = render::check_room(picture.crowded, settings_); !room)
        return room;
    watch_.take(picture.bare);
    if (video_)
        if (Result<Done> added = video_->add(picture); !added)
            return added;
    if (png_ && !(again && is_drawn(number)))
        return png_->add(file_of(number), std::move(picture));
    return Done{};
}

std::filesystem::path PictureFiles::file_of(std::int64_t number) const {
    return folder_ / fmt::format("frame_{:06}.png", number);
}

bool PictureFiles::is_drawn(std::int64_t number) const {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file_of(number), error);
    return !error && size > 0; // a power cut leaves empty files
}

Result<Done> PictureFiles::finish() {
    Problems problems;
    if (png_)
        problems = png_->finish().problems();
    if (video_ && video_->frames() > 0)
        for (const Problem& problem : video_->finish().problems())
            problems.push_back(problem);
    if (problems.empty())
        return Done{};
    return problems;
}

} // namespace tumble::run
