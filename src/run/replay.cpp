#include "run/replay.h"

#include "observe/frame_file.h"
#include "observe/series.h"
#include "render/camera.h"
#include "render/color_range.h"
#include "render/quantity.h"
#include "run/run_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace tumble::run {

namespace {

/// Of the whole run, so that the axes stand still from picture to picture.
render::PlotLine plot_line(const RunFolder& folder, const Plotted& plotted) {
    render::PlotLine line;
    const Result<observe::Series> series = observe::read_series(folder.series());
    if (!series || series->rows() == 0)
        return line;
    const std::vector<double>* times = series->find("time_s");
    const std::vector<double>* values = series->find(plotted.column);
    if (!times || !values)
        return line;
    line.label = plotted.label;
    line.unit = plotted.unit;
    line.times = *times;
    line.values = *values;
    return line;
}

std::string left_out(const Problems& problems) {
    return problems.empty() ? "" : fmt::format("left out {}: {}", problems[0].file, problems[0].what);
}

/// s, roundings included.
double slack_of(const observe::FrameHead& frame) {
    return frame.step > 0 ? 0.5 * (1 + 1e-9) * frame.time / static_cast<double>(frame.step) : 0;
}

/// s from a frame to a stretch of time.
double away_from(double time, double from, double to) {
    return std::max({from - time, time - to, 0.0});
}

/// Frames and what is wrong with others, read once from first to last.
struct Survey {
    std::vector<RecordedFrame> wanted;
    Eigen::AlignedBox3d bounds; // m, of the wanted
    Problems damaged;
    std::vector<double> times; // s, of all that can be read
};

Survey survey(const RunFolder& folder, const std::shared_ptr<const observe::FrameLayout>& layout,
              const ReplayOptions& options, Reading reading) {
    Survey found;
    render::BoundsOver bounds(layout);
    for (const std::filesystem::path& file : observe::list_frames(folder.frames())) {
        const Result<observe::FrameHead> head = observe::read_frame_head(file);
        if (!head) {
            append(found.damaged, head.problems());
            continue;
        }
        const RecordedFrame recorded{file, head->time, head->contacts, slack_of(*head)};
        const bool wanted = is_within(recorded, options.from, options.to);
        if (wanted && reading == Reading::whole) {
            const Result<observe::Frame> frame = observe::read_frame(file, layout);
            if (!frame) {
                append(found.damaged, frame.problems());
                continue;
            }
            bounds.take_in(*frame);
        }
        found.times.push_back(head->time);
        if (wanted)
            found.wanted.push_back(recorded);
    }
    found.bounds = bounds.box();
    return found;
}

Problems nothing_to_show(const std::filesystem::path& root, const Survey& found, const ReplayOptions& options) {
    Problems problems = found.damaged;
    if (!found.times.empty())
        problems.insert(problems.begin(), refuse_time(root.string(), found.times, options.from, options.to));
    else if (problems.empty())
        problems.push_back({.file = root.string(), .what = "this run has kept no frame", .fix = "run the scene again"});
    return problems;
}

/// Where frames are missing that are not among the damaged ones, which are told of one by one.
std::vector<std::string> gaps_of(const Survey& found) {
    constexpr double longest = 1.5; // of the usual time between frames
    const std::optional<double> pace = pace_of(found.wanted);
    std::set<std::int64_t> damaged;
    for (const Problem& problem : found.damaged)
        damaged.insert(observe::frame_number(problem.file).value_or(-1));
    std::int64_t missing = 0;
    std::string first;
    int places = 0;
    for (std::size_t k = 1; k < found.wanted.size(); ++k) {
        const RecordedFrame &before = found.wanted[k - 1], &after = found.wanted[k];
        const std::int64_t from = observe::frame_number(before.file).value_or(0) + 1;
        const std::int64_t to = observe::frame_number(after.file).value_or(from);
        const auto told = std::distance(damaged.lower_bound(from), damaged.lower_bound(std::max(from, to)));
        if (!pace || after.time - before.time <= longest * *pace || (told > 0 && told == to - from))
            continue;
        missing += std::max(to - from - told, std::int64_t{0});
        if (places++ == 0)
            first = fmt::format("between t = {:.6g} and {:.6g} s", before.time, after.time);
    }
    if (places == 0)
        return {};
    const std::string others =
        places < 2 ? "" : fmt::format(" and in {} other place{}", places - 1, places > 2 ? "s" : "");
    return {fmt::format("frames are missing {}{}{}: trails have gaps there, and means go without them", first, others,
                        missing > 0 ? fmt::format(", {} in all", missing) : "")};
}

} // namespace

std::vector<std::string> how_it_ended(const RunFolder& folder) {
    const nlohmann::json json = read_summary(folder);
    if (!json.contains("state") || !json["state"].is_string())
        return {"run.json cannot be read, so that nobody knows whether the run reached its end"};
    const std::string state = json["state"];
    if (state == "finished")
        return {};
    const std::string became = state == "running" ? "did not end: it was killed, or is still going on"
                                                  : (state == "failed" ? "failed" : "was stopped");
    if (!json.contains("time_s") || !json["time_s"].is_number())
        return {"this run " + became};
    return {fmt::format("this run {}; run.json knows of t = {:.6g} s", became, json["time_s"].get<double>())};
}

std::optional<double> pace_of(const std::vector<RecordedFrame>& frames) {
    std::vector<double> ways;
    for (std::size_t k = 1; k < frames.size(); ++k)
        ways.push_back(frames[k].time - frames[k - 1].time);
    if (ways.empty())
        return std::nullopt;
    if (ways.size() == 1) { // which may be the one where others are missing
        const auto from = observe::frame_number(frames[0].file), to = observe::frame_number(frames[1].file);
        return ways[0] / static_cast<double>(from && to ? std::max(*to - *from, std::int64_t{1}) : 1);
    }
    const auto middle = ways.begin() + static_cast<std::ptrdiff_t>((ways.size() - 1) / 2);
    std::nth_element(ways.begin(), middle, ways.end());
    return *middle;
}

bool is_within(const RecordedFrame& frame, double from, double to) {
    return away_from(frame.time, from, to) <= frame.slack;
}

Problem refuse_time(const std::string& run, const std::vector<double>& times, double from, double to) {
    const auto [first, last] = std::minmax_element(times.begin(), times.end());
    const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
        return away_from(a, from, to) < away_from(b, from, to);
    });
    return {.file = run,
            .what = "there is no readable frame in the time asked for",
            .fix = fmt::format("the nearest is at {:.6g} s; they go from {:.6g} to {:.6g} s", *nearest, *first, *last)};
}

Result<Recording> open_recording(const std::filesystem::path& root, const ReplayOptions& options, Reading reading) {
    const Result<RunFolder> folder = find_run(root);
    if (!folder)
        return folder.problems();
    const auto layout = observe::read_layout(observe::layout_path(folder->frames()));
    if (!layout)
        return layout.problems();
    const Survey found = survey(*folder, *layout, options, reading);
    if (found.wanted.empty())
        return nothing_to_show(root, found, options);
    Recording recording{*folder, *layout, found.wanted, how_it_ended(*folder), found.bounds};
    for (const Problem& problem : found.damaged)
        recording.warnings.push_back(left_out({problem}));
    for (std::string& gap : gaps_of(found))
        recording.warnings.push_back(std::move(gap));
    return recording;
}

Result<std::array<double, 2>> colors_for(std::span<const Recording> recordings, const std::string& color) {
    render::WidestRange widest;
    bool has_sign = false;
    for (const Recording& recording : recordings) {
        const auto quantity = render::find_quantity(color, recording.layout->dimension);
        if (!quantity)
            return quantity.problems();
        has_sign = quantity->has_sign;
        for (const RecordedFrame& recorded : recording.frames)
            if (const Result<observe::Frame> frame = observe::read_frame(recorded.file, recording.layout))
                widest.take_in(render::values_of(*quantity, *frame));
    }
    const render::Span span = widest.span(has_sign);
    return std::array{span.lo, span.hi};
}

Replayed replay(const Recording& recording, const ReplayOptions& options, const FrameSinks& sinks,
                const TellFrames& tell) {
    Replayed replayed;
    replayed.warnings = recording.warnings;
    Shot shot;
    if (options.plotted)
        shot.plot = plot_line(recording.folder, *options.plotted);
    shot.plot.until = options.duration;
    if (shot.plot.times.empty() && options.plotted)
        replayed.warnings.push_back(fmt::format("there is no small plot: the series of this run has no {}; "
                                                "`--plot` takes what observe.measures had it keep",
                                                options.plotted->name));
    Problems& problems = replayed.reason;
    const auto all = static_cast<std::int64_t>(recording.frames.size());
    for (const RecordedFrame& recorded : recording.frames) {
        if (stop_wanted(options.stop)) {
            replayed.stopped = true;
            break;
        }
        Result<observe::Frame> frame = observe::read_frame(recorded.file, recording.layout);
        if (!frame) {
            replayed.warnings.push_back(left_out(frame.problems()));
            continue;
        }
        shot.frame = std::move(*frame);
        shot.number = observe::frame_number(recorded.file).value_or(0);
        for (const auto& sink : sinks)
            if (problems.empty())
                problems = sink->take(shot).problems();
        if (!problems.empty())
            break;
        replayed.first = replayed.frames == 0 ? shot.frame.time : replayed.first;
        replayed.last = shot.frame.time;
        ++replayed.frames;
        tell(replayed.frames, all);
    }
    for (const auto& sink : sinks) {
        if (const Problems more = sink->finish().problems(); problems.empty())
            problems = more;
        for (std::string& warning : sink->warnings())
            replayed.warnings.push_back(std::move(warning));
    }
    return replayed;
}

} // namespace tumble::run
