#include "run/beside.h"

#include "observe/frame_file.h"
#include "render/pair_painter.h"
#include "run/drawing_sink.h"
#include "run/run_folder.h"
#include "run/target.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::run {

namespace {

namespace fs = std::filesystem;

/// Frames are taken at the steps nearest to their times: those of one instant may be a step apart, those of different
/// ones are further apart than this share of their distance.
constexpr double same_instant = 0.4;

using Recordings = std::array<Recording, 2>;

struct Moment {
    fs::path left, right;
};

double spacing_of(const std::vector<RecordedFrame>& frames) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < frames.size(); ++k)
        least = std::min(least, frames[k].time - frames[k - 1].time);
    return least;
}

std::vector<Moment> common(const std::vector<RecordedFrame>& left, const std::vector<RecordedFrame>& right) {
    std::vector<Moment> moments;
    // A single frame goes with whatever stands beside it.
    const double apart = same_instant * std::max(spacing_of(left), spacing_of(right));
    for (const RecordedFrame& frame : left) {
        const auto nearest =
            std::min_element(right.begin(), right.end(), [&](const RecordedFrame& a, const RecordedFrame& b) {
                return std::abs(a.time - frame.time) < std::abs(b.time - frame.time);
            });
        if (nearest != right.end() && std::abs(nearest->time - frame.time) <= apart)
            moments.push_back({frame.file, nearest->file});
    }
    return moments;
}

std::array<std::string, 2> labels_for(const std::array<fs::path, 2>& runs, const Recordings& recordings,
                                      const std::array<std::string, 2>& wanted) {
    std::array<std::string, 2> labels{recordings[0].layout->title, recordings[1].layout->title};
    if (labels[0] == labels[1])
        labels = {folder_name(runs[0]), folder_name(runs[1])};
    for (std::size_t side = 0; side < 2; ++side)
        if (!wanted[side].empty())
            labels[side] = wanted[side];
    return labels;
}

/// What both runs show at the same times.
struct Comparison {
    Recordings recordings;
    std::vector<Moment> moments;
    std::vector<std::string> warnings;
};

Result<Comparison> compare(const std::array<fs::path, 2>& runs, const BesideOptions& options) {
    Result<Recording> left = open_recording(runs[0], options.when), right = open_recording(runs[1], options.when);
    if (!left || !right)
        return (left ? right : left).problems();
    if (left->layout->dimension != right->layout->dimension)
        return Problem{.file = runs[1].string(),
                       .what = fmt::format("is of {} dimensions, and {} of {}: they have no view in common",
                                           right->layout->dimension, runs[0].string(), left->layout->dimension),
                       .fix = "put runs of the same dimension side by side"};
    Comparison found{{std::move(*left), std::move(*right)}, {}, {}};
    found.moments = common(found.recordings[0].frames, found.recordings[1].frames);
    if (found.moments.empty())
        return Problem{.file = runs[1].string(),
                       .what = "no frame of it is of the same time as one of " + runs[0].string(),
                       .fix = "compare runs with the same render.every_s"};
    for (std::size_t side = 0; side < 2; ++side) {
        for (const std::string& warning : found.recordings[side].warnings)
            found.warnings.push_back(runs[side].string() + ": " + warning);
        if (const std::size_t alone = found.recordings[side].frames.size() - found.moments.size(); alone > 0)
            found.warnings.push_back(
                fmt::format("{}: {} of its frames have none beside them", runs[side].string(), alone));
    }
    return found;
}

/// With no frames but the last that both have: those of a drawing, which alone have a say in its scales.
Recordings last_of(const Comparison& shown) {
    Recordings last = shown.recordings;
    for (std::size_t side = 0; side < 2; ++side)
        std::erase_if(last[side].frames, [&](const RecordedFrame& frame) {
            return frame.file != (side == 0 ? shown.moments.back().left : shown.moments.back().right);
        });
    return last;
}

/// Reads both frames of a moment and hands them to show(left, right); a problem where one cannot be read again.
template <class Show>
Result<Done> show_moment(const Moment& moment, const Recordings& recordings, Replayed& done, Show&& show) {
    const Result<observe::Frame> left = observe::read_frame(moment.left, recordings[0].layout);
    const Result<observe::Frame> right = observe::read_frame(moment.right, recordings[1].layout);
    if (!left || !right)
        return (left ? right : left).problems();
    done.first = done.frames == 0 ? left->time : done.first;
    done.last = left->time;
    ++done.frames;
    return show(*left, *right);
}

bool is_stopped(const BesideOptions& options, Replayed& done) {
    return done.stopped = stop_wanted(options.when.stop);
}

/// Until the last moment, a stop or a problem.
void draw_all(const Comparison& shown, const BesideOptions& options, render::PairPainter& painter, PictureFiles& files,
              const TellFrames& tell, Replayed& done) {
    for (const Moment& moment : shown.moments) {
        if (is_stopped(options, done))
            break;
        const std::int64_t number = observe::frame_number(moment.left).value_or(done.frames);
        done.reason = show_moment(moment, shown.recordings, done, [&](const auto& left, const auto& right) {
                          return files.add(painter.draw(left, right), number);
                      }).problems();
        if (!done.reason.empty())
            break;
        tell(done.frames, static_cast<std::int64_t>(shown.moments.size()));
    }
    if (const Problems problems = files.finish().problems(); done.reason.empty())
        done.reason = problems;
    for (std::string& warning : files.warnings())
        done.warnings.push_back(std::move(warning));
}

/// The last moment; trails come from those before it.
void draw_last(const Comparison& shown, const BesideOptions& options, render::PairDrafter& drafter,
               const TellFrames& tell, Replayed& done) {
    if (!options.settings.marks.trails.empty())
        for (auto moment = shown.moments.begin(); moment + 1 != shown.moments.end() && done.reason.empty(); ++moment) {
            if (is_stopped(options, done))
                return;
            done.reason = show_moment(*moment, shown.recordings, done, [&](const auto& left, const auto& right) {
                              drafter.pass_over(0, left);
                              drafter.pass_over(1, right);
                              return Result<Done>(Done{});
                          }).problems();
        }
    done.frames = 0; // that were drawn
    if (!done.reason.empty())
        return;
    done.reason = show_moment(shown.moments.back(), shown.recordings, done, [&](const auto& left, const auto& right) {
                      render::Drawing drawing = drafter.draw(left, right);
                      BareWatch watch;
                      watch.take(drawing.bare);
                      for (std::string& warning : watch.warnings())
                          done.warnings.push_back(std::move(warning));
                      return save_readable(std::move(drawing), options.settings, options.targets.drawing);
                  }).problems();
    tell(1, 1);
}

/// Fitted to both runs, and with their mean fields where those are drawn.
template <class Medium>
Result<render::PairPainterOf<Medium>> open_pair(const Comparison& shown, const scene::Render& settings,
                                                const std::array<std::string, 2>& labels) {
    const Recordings& recordings = shown.recordings;
    auto painter = render::PairPainterOf<Medium>::open(settings, {recordings[0].layout, recordings[1].layout}, labels);
    if (!painter)
        return painter.problems();
    painter->fit(recordings[0].bounds.merged(recordings[1].bounds));
    // Frames that stand beside each other come at the pace of the run that has fewer of them.
    if (const double pace =
            std::max(pace_of(recordings[0].frames).value_or(0), pace_of(recordings[1].frames).value_or(0));
        pace > 0)
        painter->expect_pace(pace);
    for (std::size_t side = 0; settings.marks.arrows == "field" && side < 2; ++side)
        for (const Moment& moment : shown.moments)
            if (const auto frame = observe::read_frame(side == 0 ? moment.left : moment.right, recordings[side].layout))
                painter->foresee(side, *frame);
    return painter;
}

} // namespace

Result<Replayed> draw_beside(const std::array<fs::path, 2>& runs, const BesideOptions& options,
                             const TellFrames& tell) {
    const Result<Comparison> shown = compare(runs, options);
    if (!shown)
        return shown.problems();
    const Recordings& recordings = shown->recordings;
    const bool as_lines = !options.targets.drawing.empty();
    const auto settled = settle_scales(as_lines ? last_of(*shown) : recordings, options.settings);
    if (!settled)
        return settled.problems();
    const scene::Render& settings = *settled;
    const auto labels = labels_for(runs, recordings, options.labels);
    Target pictures(options.targets.folder), video(options.targets.video), drawing(options.targets.drawing);
    for (auto [target, extension] :
         {std::pair{&pictures, ".png"}, std::pair{&video, ".mp4"}, std::pair{&drawing, ".svg"}})
        if (const auto problem = target->claim(options.overwrite, extension))
            return *problem;
    Replayed done;
    done.warnings = shown->warnings;
    if (as_lines) {
        auto drafter = open_pair<render::Lines>(*shown, settings, labels);
        if (!drafter)
            return of_run(drafter.problems(), runs[recordings[0].layout->dimension == 2 ? 1 : 0]);
        draw_last(*shown, options, *drafter, tell, done);
    } else {
        auto painter = open_pair<render::Pixels>(*shown, settings, labels);
        if (!painter)
            return painter.problems();
        Result<PictureFiles> files = PictureFiles::open(settings, options.targets);
        if (!files)
            return files.problems();
        draw_all(*shown, options, *painter, *files, tell, done);
    }
    if (done.reason.empty()) {
        pictures.keep();
        video.keep();
        drawing.keep();
    }
    return done;
}

} // namespace tumble::run
