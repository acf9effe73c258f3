#include "run/drawing_sink.h"

#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "render/drafter.h"
#include "run/picture_files.h"

namespace tumble::run {

namespace fs = std::filesystem;

namespace {

class DrawingSink final : public FrameSink {
public:
    DrawingSink(render::Drafter drafter, scene::Render settings, fs::path file, std::int64_t last)
        : drafter_(std::move(drafter)), settings_(std::move(settings)), file_(std::move(file)), last_(last) {}

    Result<Done> take(const Shot& shot) override {
        if (shot.number == last_) {
            render::Drawing drawing = drafter_.draw(shot.frame, shot.plot);
            watch_.take(drawing.bare);
            return save_readable(std::move(drawing), settings_, file_);
        }
        drafter_.pass_over(shot.frame);
        return Done{};
    }
    Result<Done> finish() override { return Done{}; }
    [[nodiscard]] std::vector<std::string> warnings() const override { return watch_.warnings(); }

private:
    render::Drafter drafter_;
    scene::Render settings_;
    fs::path file_;
    std::int64_t last_ = 0;
    BareWatch watch_;
};

} // namespace

Result<std::unique_ptr<FrameSink>> keep_drawing(const scene::Render& settings, const Recording& recording,
                                                const fs::path& file) {
    auto drafter = render::Drafter::open(render::in_fine_pixels(settings), recording.layout);
    if (!drafter)
        return of_run(drafter.problems(), recording.folder.root);
    drafter->fit(recording.bounds);
    if (const auto pace = pace_of(recording.frames))
        drafter->expect_pace(*pace);
    if (settings.marks.arrows == "field")
        for (const RecordedFrame& one : recording.frames)
            if (const Result<observe::Frame> frame = observe::read_frame(one.file, recording.layout))
                drafter->foresee(*frame);
    const std::int64_t last = observe::frame_number(recording.frames.back().file).value_or(0);
    return std::unique_ptr<FrameSink>(std::make_unique<DrawingSink>(std::move(*drafter), settings, file, last));
}

Result<Done> save(const render::Drawing& drawing, const fs::path& file) {
    if (const auto made = make_folder(fs::absolute(file).parent_path()); !made)
        return made.problems();
    return render::write_drawing(drawing, file);
}

Problems of_run(Problems problems, const fs::path& run) {
    for (Problem& problem : problems)
        if (problem.file.empty() && problem.key.empty())
            problem.file = run.string();
    return problems;
}

} // namespace tumble::run
