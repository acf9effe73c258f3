#include "view/film.h"

#include "render/painter.h"
#include "run/frame_queue.h"
#include "run/picture_files.h"

#include <fmt/format.h>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace tumble::view {

/// How pictures are to look, from that number on: a frame is drawn some time after it was shot.
class FilmLooks {
public:
    void set(std::int64_t shot, const FilmLook& look) {
        const std::lock_guard lock(mutex_);
        looks_[shot] = look;
    }
    /// If another begins with that picture.
    std::optional<FilmLook> take(std::int64_t shot) {
        const std::lock_guard lock(mutex_);
        const auto found = looks_.find(shot);
        if (found == looks_.end())
            return std::nullopt;
        FilmLook look = std::move(found->second);
        looks_.erase(found);
        return look;
    }

private:
    std::mutex mutex_;
    std::map<std::int64_t, FilmLook> looks_;
};

namespace {

class FilmSink final : public run::FrameSink {
public:
    FilmSink(render::Painter painter, run::PictureFiles files, std::shared_ptr<FilmLooks> looks)
        : painter_(std::move(painter)), files_(std::move(files)), looks_(std::move(looks)) {}

    Result<Done> take(const run::Shot& shot) override {
        if (const auto look = looks_->take(shot.number)) {
            painter_.hold_camera(look->held);
            if (Result<Done> styled = painter_.restyle(look->settings); !styled)
                return styled;
        }
        return files_.add(painter_.draw(shot.frame, shot.plot), shot.number);
    }
    Result<Done> finish() override { return files_.finish(); }

private:
    render::Painter painter_;
    run::PictureFiles files_;
    std::shared_ptr<FilmLooks> looks_;
};

} // namespace

struct Film::Inside {
    std::shared_ptr<FilmLooks> looks;
    run::FrameQueue queue;
    Inside(std::shared_ptr<FilmLooks> shared, run::FrameSinks sinks)
        : looks(std::move(shared)), queue(std::move(sinks)) {}
};

Film::Film(std::unique_ptr<Inside> inside, const FilmLook& look, run::Schedule schedule, std::filesystem::path file)
    : inside_(std::move(inside)), look_(look), schedule_(schedule), file_(std::move(file)) {}
Film::~Film() = default;

Result<std::unique_ptr<Film>> Film::open(const FilmLook& look, std::shared_ptr<const observe::FrameLayout> layout,
                                         const std::filesystem::path& file, const Eigen::AlignedBox3d& bounds,
                                         double step) {
    Result<render::Painter> painter = render::Painter::open(look.settings, std::move(layout));
    if (!painter)
        return painter.problems();
    painter->fit(bounds);
    painter->hold_camera(look.held);
    Result<run::PictureFiles> files = run::PictureFiles::open(look.settings, {.folder = {}, .video = file});
    if (!files)
        return files.problems();
    auto looks = std::make_shared<FilmLooks>();
    run::FrameSinks sinks;
    sinks.push_back(std::make_unique<FilmSink>(std::move(*painter), std::move(*files), looks));
    auto inside = std::make_unique<Inside>(std::move(looks), std::move(sinks));
    return std::unique_ptr<Film>(new Film(std::move(inside), look, run::Schedule(look.settings.every, step), file));
}

void Film::restyle(const FilmLook& look) {
    look_ = look;
    inside_->looks->set(shots_, look);
}

bool Film::shoot(std::int64_t step, observe::Frame frame) {
    schedule_.pass(step);
    inside_->queue.push({std::move(frame), shots_++, {}});
    return inside_->queue.problems().empty();
}

std::string Film::close() {
    const Problems problems = inside_->queue.close();
    return problems.empty() ? fmt::format("{} with {} pictures", file_.string(), shots_) : to_string(problems.front());
}

} // namespace tumble::view
