#include "run/picture_sink.h"

#include "observe/frame_file.h"
#include "render/painter.h"

namespace tumble::run {

namespace {

class PictureSink final : public FrameSink {
public:
    PictureSink(render::Painter painter, PictureFiles files) : painter_(std::move(painter)), files_(std::move(files)) {}

    Result<Done> take(const Shot& shot) override {
        if (!files_.wants(shot.number, shot.again)) {
            painter_.pass_over(shot.frame);
            return Done{};
        }
        return files_.add(painter_.draw(shot.frame, shot.plot), shot.number, shot.again);
    }
    Result<Done> finish() override { return files_.finish(); }
    [[nodiscard]] std::vector<std::string> warnings() const override { return files_.warnings(); }

private:
    render::Painter painter_;
    PictureFiles files_;
};

} // namespace

Result<std::unique_ptr<FrameSink>> keep_pictures(const scene::Render& settings,
                                                 std::shared_ptr<const observe::FrameLayout> layout,
                                                 const PictureTargets& targets, const Eigen::AlignedBox3d& fit,
                                                 const Recording* to_come, const std::optional<render::Held>& held) {
    Result<render::Painter> painter = render::Painter::open(settings, std::move(layout));
    if (!painter)
        return painter.problems();
    if (!fit.isEmpty())
        painter->fit(fit);
    if (to_come)
        if (const auto pace = pace_of(to_come->frames))
            painter->expect_pace(*pace);
    painter->hold_camera(held);
    if (to_come && settings.marks.arrows == "field")
        for (const RecordedFrame& recorded : to_come->frames)
            if (const Result<observe::Frame> frame = observe::read_frame(recorded.file, to_come->layout))
                painter->foresee(*frame);
    scene::Render of_files = settings;
    if (!to_come)
        of_files.paper.reset(); // a simulation does not break off because words have no room
    Result<PictureFiles> files = PictureFiles::open(of_files, targets);
    if (!files)
        return files.problems();
    return std::unique_ptr<FrameSink>(std::make_unique<PictureSink>(std::move(*painter), std::move(*files)));
}

} // namespace tumble::run
