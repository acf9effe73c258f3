#include "run/replay.h"

#include "observe/frame_file.h"
#include "observe/measures.h"
#include "observe/series.h"
#include "render/camera.h"

#include <fmt/format.h>

namespace tumble::run {

namespace {

/// The whole run's measure, so that the axes stand still from picture to picture.
render::PlotLine plot_line(const RunFolder& folder, const std::string& measure) {
    render::PlotLine line;
    const Result<observe::Series> series = observe::read_series(folder.series());
    if (measure.empty() || !series || series->rows() == 0)
        return line;
    const auto known = observe::choose_measures({measure});
    const std::vector<double>* times = series->find("time_s");
    const std::vector<double>* values = known && known->size() == 1 ? series->find(known->front().column()) : nullptr;
    if (!times || !values)
        return line;
    line.label = observe::spelled_name(measure);
    line.unit = observe::spelled_unit(known->front().unit);
    line.times = *times;
    line.values = *values;
    return line;
}

std::string left_out(const Problems& problems) {
    return problems.empty() ? "" : fmt::format("left out {}: {}", problems[0].file, problems[0].what);
}

} // namespace

Result<Recording> open_recording(const std::filesystem::path& root, const ReplayOptions& options) {
    const Result<RunFolder> folder = find_run(root);
    if (!folder)
        return folder.problems();
    const auto layout = observe::read_layout(observe::layout_path(folder->frames()));
    if (!layout)
        return layout.problems();
    Recording recording{*folder, *layout, {}, {}, {}};
    double latest = 0;
    for (const std::filesystem::path& file : observe::list_frames(folder->frames())) {
        const Result<observe::Frame> frame = observe::read_frame(file, *layout);
        if (!frame) {
            recording.warnings.push_back(left_out(frame.problems()));
            continue;
        }
        latest = std::max(latest, frame->time);
        if (frame->time < options.from || frame->time > options.to)
            continue;
        recording.frames.push_back(file);
        recording.bounds.extend(render::bounds_of(*frame));
    }
    if (recording.frames.empty())
        return Problem{.file = root.string(),
                       .what = "there is no readable frame in the time asked for",
                       .fix = fmt::format("its last readable frame is at {} s", latest)};
    return recording;
}

Result<Replayed> replay(const Recording& recording, const ReplayOptions& options, const FrameSinks& sinks,
                        const TellFrames& tell) {
    Replayed replayed;
    replayed.warnings = recording.warnings;
    Shot shot;
    shot.plot = plot_line(recording.folder, options.plot_measure);
    shot.plot.until = options.duration;
    Problems problems;
    const auto all = static_cast<std::int64_t>(recording.frames.size());
    for (const std::filesystem::path& file : recording.frames) {
        if (options.stop && options.stop->load(std::memory_order_relaxed)) {
            replayed.stopped = true;
            break;
        }
        Result<observe::Frame> frame = observe::read_frame(file, recording.layout);
        if (!frame) {
            replayed.warnings.push_back(left_out(frame.problems()));
            continue;
        }
        shot.frame = std::move(*frame);
        for (const auto& sink : sinks)
            if (problems.empty())
                problems = sink->take(shot).problems();
        if (!problems.empty())
            break;
        replayed.first = replayed.frames == 0 ? shot.frame.time : replayed.first;
        replayed.last = shot.frame.time;
        shot.number = ++replayed.frames;
        tell(replayed.frames, all);
    }
    for (const auto& sink : sinks)
        if (const Problems more = sink->finish().problems(); problems.empty())
            problems = more;
    if (!problems.empty())
        return problems;
    return replayed;
}

} // namespace tumble::run
