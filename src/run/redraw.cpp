#include "run/redraw.h"

#include "run/drawing_sink.h"
#include "run/measure_names.h"
#include "run/picture_sink.h"
#include "run/state_sinks.h"
#include "run/target.h"

#include <algorithm>

namespace tumble::run {

namespace fs = std::filesystem;

std::shared_ptr<const observe::FrameLayout> restyled_layout(observe::FrameLayout layout, const RedrawOptions& options) {
    if (!options.title.empty())
        layout.title = options.title;
    for (std::size_t i = 0; i < std::min(layout.walls.size(), options.wall_opacity.size()); ++i)
        layout.walls[i].opacity = options.wall_opacity[i];
    return std::make_shared<const observe::FrameLayout>(std::move(layout));
}

Result<Replayed> redraw(const fs::path& run, const RedrawOptions& options, const TellFrames& tell) {
    auto plotted = find_plotted(options.settings, options.traced);
    if (!plotted)
        return plotted.problems();
    Result<Recording> recording = open_recording(run, options.when);
    if (!recording)
        return recording.problems();
    recording->layout = restyled_layout(*recording->layout, options);
    Target pictures(options.targets.folder);
    Target video(options.targets.video);
    Target drawing(options.targets.drawing);
    for (auto [target, extension] :
         {std::pair{&pictures, ".png"}, std::pair{&video, ".mp4"}, std::pair{&drawing, ".svg"}})
        if (const auto problem = target->claim(options.overwrite, extension))
            return *problem;
    Recording seen = *recording;
    if (!options.targets.drawing.empty()) // is of one frame, which alone has a say in its scales
        seen.frames.erase(seen.frames.begin(), seen.frames.end() - 1);
    const auto settings = settle_scales({&seen, 1}, options.settings);
    if (!settings)
        return settings.problems();
    FrameSinks sinks;
    const bool as_lines = !options.targets.drawing.empty();
    auto sink = as_lines ? keep_drawing(*settings, *recording, options.targets.drawing)
                         : keep_pictures(*settings, recording->layout, options.targets, recording->bounds, &*recording,
                                         options.held);
    if (!sink)
        return sink.problems();
    sinks.push_back(std::move(*sink));
    ReplayOptions when = options.when;
    when.plotted = std::move(*plotted);
    Replayed replayed = replay(*recording, when, sinks, tell);
    if (as_lines) {
        replayed.frames = replayed.stopped ? 0 : 1; // that were drawn
        replayed.first = replayed.last;
    }
    if (replayed.reason.empty()) {
        pictures.keep();
        video.keep();
        drawing.keep();
    }
    return replayed;
}

Result<Replayed> export_run(const fs::path& run, const ExportOptions& options, const TellFrames& tell) {
    const Result<Recording> recording = open_recording(run, options.when, Reading::heads);
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
    if (replayed.frames == 0 && replayed.reason.empty() && !replayed.stopped)
        if (const auto whole = open_recording(run, options.when); !whole) // says what is wrong with each
            return whole.problems();
    if (replayed.reason.empty()) {
        paraview.keep();
        text.keep();
    }
    return replayed;
}

} // namespace tumble::run
