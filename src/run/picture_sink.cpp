#include "run/picture_sink.h"

#include "render/painter.h"
#include "render/png_writer.h"
#include "render/video_writer.h"

#include <fmt/format.h>
#include <optional>

namespace tumble::run {

namespace {

class PictureSink final : public FrameSink {
public:
    PictureSink(render::Painter painter, std::filesystem::path folder, std::optional<render::VideoWriter> video)
        : painter_(std::move(painter)), folder_(std::move(folder)), video_(std::move(video)) {
        if (!folder_.empty())
            png_.emplace();
    }

    Result<Done> take(const Shot& shot) override {
        // A video cannot be added to and is drawn again from its first frame.
        if (shot.again && !video_ && is_drawn(shot.number)) {
            painter_.pass_over(shot.frame);
            return Done{};
        }
        render::Picture picture = painter_.draw(shot.frame, shot.plot);
        if (video_)
            if (Result<Done> added = video_->add(picture); !added)
                return added;
        if (png_ && !(shot.again && is_drawn(shot.number)))
            return png_->add(file_of(shot.number), std::move(picture));
        return Done{};
    }

    Result<Done> finish() override {
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

private:
    [[nodiscard]] std::filesystem::path file_of(std::int64_t number) const {
        return folder_ / fmt::format("frame_{:06}.png", number);
    }
    [[nodiscard]] bool is_drawn(std::int64_t number) const {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file_of(number), error);
        return !error && size > 0; // a power cut leaves empty files
    }

    render::Painter painter_;
    std::filesystem::path folder_;
    std::optional<render::PngWriter> png_;
    std::optional<render::VideoWriter> video_;
};

} // namespace

Result<std::unique_ptr<FrameSink>> keep_pictures(const scene::Render& settings,
                                                 std::shared_ptr<const observe::FrameLayout> layout,
                                                 const PictureTargets& targets, const Eigen::AlignedBox3d& fit) {
    Result<render::Painter> painter = render::Painter::open(settings, std::move(layout));
    if (!painter)
        return painter.problems();
    if (!fit.isEmpty())
        painter->fit(fit);
    std::error_code error;
    if (!targets.folder.empty())
        std::filesystem::create_directories(targets.folder, error);
    if (error)
        return Problem{.file = targets.folder.string(), .what = "cannot be made: " + error.message()};
    std::optional<render::VideoWriter> video;
    if (!targets.video.empty()) {
        auto opened =
            render::VideoWriter::open(targets.video, settings.width, settings.height, settings.frames_per_second);
        if (!opened)
            return opened.problems();
        video = std::move(*opened);
    }
    return std::unique_ptr<FrameSink>(
        std::make_unique<PictureSink>(std::move(*painter), targets.folder, std::move(video)));
}

} // namespace tumble::run
