#include "run/redraw.h"

#include "run/measure_names.h"
#include "run/picture_sink.h"
#include "run/state_sinks.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::run {

namespace {

namespace fs = std::filesystem;

/// A file or folder to be filled; taken away again when nothing came of it and it was not there before.
class Target {
public:
    explicit Target(fs::path place) : place_(std::move(place)) {}
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target() {
        std::error_code ignored;
        if (fresh_ && !place_.empty())
            fs::remove_all(place_, ignored);
    }

    std::optional<Problem> claim(bool overwrite, const std::string& extension) {
        std::error_code error;
        if (place_.empty())
            return std::nullopt;
        const bool there = fs::exists(place_, error);
        if (there && !(fs::is_directory(place_, error) && fs::is_empty(place_, error))) {
            if (!overwrite)
                return Problem{.file = place_.string(),
                               .what = "is there already, and nothing is overwritten",
                               .fix = "--force replaces it"};
            remove_old(extension);
        }
        fresh_ = !there;
        return std::nullopt;
    }

    void keep() { fresh_ = false; }

private:
    /// Only what such an export writes: pictures of an older, longer run must not mix with new ones.
    void remove_old(const std::string& extension) const {
        std::error_code ignored;
        if (!fs::is_directory(place_, ignored))
            return;
        std::vector<fs::path> old;
        for (const fs::directory_entry& entry : fs::directory_iterator(place_, ignored)) {
            fs::path name = entry.path();
            if (name.extension() == ".part") // of a redrawing that was killed
                name.replace_extension();
            if (name.extension() == extension || name.extension() == ".pvd")
                old.push_back(entry.path());
        }
        for (const fs::path& file : old)
            fs::remove(file, ignored);
    }

    fs::path place_;
    bool fresh_ = false;
};

std::shared_ptr<const observe::FrameLayout> restyled(observe::FrameLayout layout, const RedrawOptions& options) {
    if (!options.title.empty())
        layout.title = options.title;
    for (std::size_t i = 0; i < std::min(layout.walls.size(), options.wall_opacity.size()); ++i)
        layout.walls[i].opacity = options.wall_opacity[i];
    return std::make_shared<const observe::FrameLayout>(std::move(layout));
}

} // namespace

Result<Replayed> redraw(const fs::path& run, const RedrawOptions& options, const TellFrames& tell) {
    if (const Problems problems = check_plot(options.settings); !problems.empty())
        return problems;
    Result<Recording> recording = open_recording(run, options.when);
    if (!recording)
        return recording.problems();
    recording->layout = restyled(*recording->layout, options);
    Target pictures(options.pictures);
    Target video(options.video);
    for (auto [target, extension] : {std::pair{&pictures, ".png"}, std::pair{&video, ".mp4"}})
        if (const auto problem = target->claim(options.overwrite, extension))
            return *problem;
    FrameSinks sinks;
    auto sink =
        keep_pictures(options.settings, recording->layout, {options.pictures, options.video}, recording->bounds);
    if (!sink)
        return sink.problems();
    sinks.push_back(std::move(*sink));
    ReplayOptions when = options.when;
    when.plot_measure = options.settings.plot_measure;
    const Replayed replayed = replay(*recording, when, sinks, tell);
    if (replayed.reason.empty()) {
        pictures.keep();
        video.keep();
    }
    return replayed;
}

Result<Replayed> export_run(const fs::path& run, const ExportOptions& options, const TellFrames& tell) {
    const Result<Recording> recording = open_recording(run, options.when);
    if (!recording)
        return recording.problems();
    Target paraview(options.paraview);
    Target text(options.text_dump);
    for (auto [target, extension] : {std::pair{&paraview, ".vtp"}, std::pair{&text, ".dump"}})
        if (const auto problem = target->claim(options.overwrite, extension))
            return *problem;
    FrameSinks sinks;
    const auto add = [&](Result<std::unique_ptr<FrameSink>> sink) {
        const Problems problems = sink.problems();
        if (sink)
            sinks.push_back(std::move(*sink));
        return problems;
    };
    Problems problems;
    if (!options.paraview.empty())
        problems = add(keep_for_paraview(options.paraview));
    if (problems.empty() && !options.text_dump.empty())
        problems = add(keep_as_text(options.text_dump));
    if (!problems.empty())
        return problems;
    const Replayed replayed = replay(*recording, options.when, sinks, tell);
    if (replayed.reason.empty()) {
        paraview.keep();
        text.keep();
    }
    return replayed;
}

} // namespace tumble::run
