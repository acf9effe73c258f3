#include "run/strip.h"

#include "base/ending.h"
#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "render/clip.h"
#include "render/painter.h"
#include "render/panels.h"
#include "render/png_writer.h"
#include "run/drawing_sink.h"
#include "run/picture_files.h"
#include "run/target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace tumble::run {

namespace {

namespace fs = std::filesystem;

/// One picture of several.
struct Part {
    fs::path frame;
    std::optional<scene::Box> clip; // another than the settings'
    std::string words;              // empty: the time
    double time = 0;                // s
};

Result<std::vector<Part>> instants(const Recording& recording, int count) {
    const auto frames = recording.frames.size(), wanted = static_cast<std::size_t>(count);
    if (frames < wanted)
        return Problem{
            .file = recording.folder.root.string(),
            .what = fmt::format("{} pictures are asked for, and in that time there are {} frames", count, frames),
            .fix = "ask for fewer, for a longer time, or run the scene with a shorter render.every_s"};
    std::vector<Part> parts;
    for (std::size_t k = 0; k < wanted; ++k) {
        const double share = wanted > 1 ? static_cast<double>(k) / static_cast<double>(wanted - 1) : 1;
        const RecordedFrame& frame =
            recording.frames[static_cast<std::size_t>(std::lround(share * static_cast<double>(frames - 1)))];
        parts.push_back({frame.file, std::nullopt, {}, frame.time});
    }
    return parts;
}

/// The world's axis that the camera looks along most, and whether it looks up it.
std::pair<int, bool> axis_of_view(const scene::Render& settings) {
    const Eigen::AlignedBox3d any(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones());
    const render::Camera camera = *render::make_camera(settings, any, {0, 0, 100, 100});
    const Eigen::Vector3d look = -camera.axes.row(2).transpose();
    int axis = 0;
    look.cwiseAbs().maxCoeff(&axis);
    return {axis, look[axis] > 0};
}

/// Of the bodies' centres; of the clip where there is one.
Eigen::AlignedBox3d reach_of(const observe::Frame& frame, const scene::Render& settings) {
    if (settings.clip)
        return {settings.clip->lo, settings.clip->hi};
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : frame.position)
        if (place.allFinite())
            box.extend(place);
    return box;
}

/// Where cuts lie along the axis between `near`, on the eye's side, and `far` (m).
Result<std::vector<double>> cuts_between(double near, double far, const StripOptions& options, char axis) {
    std::vector<double> cuts = options.places;
    const int count = options.plan.cells;
    for (int k = 1; options.places.empty() && k <= count; ++k)
        cuts.push_back(near + static_cast<double>(k) / (count + 1) * (far - near));
    const auto [lo, hi] = std::minmax(near, far);
    for (const double cut : options.places)
        if (!(cut >= lo && cut <= hi))
            return Problem{.what = fmt::format("a section at {} = {:g} m cuts no bodies", axis, cut),
                           .fix = fmt::format("choose places from {:.4g} to {:.4g} m", lo, hi)};
    return cuts;
}

Result<std::vector<Part>> sections(const Recording& recording, const StripOptions& options) {
    const scene::Render& settings = options.redraw.settings;
    if (recording.layout->dimension == 2)
        return Problem{.file = recording.folder.root.string(),
                       .what = "a scene of two dimensions has no sections",
                       .fix = "leave --sections away"};
    const fs::path& last = recording.frames.back().file;
    const auto frame = observe::read_frame(last, recording.layout);
    if (!frame)
        return frame.problems();
    const Eigen::AlignedBox3d reach = reach_of(*frame, settings);
    if (reach.isEmpty())
        return Problem{.file = recording.folder.root.string(),
                       .what = "there are no bodies to cut through at the end",
                       .fix = "choose another time with --time"};
    const auto [axis, upwards] = axis_of_view(settings);
    const double lo = reach.min()[axis], hi = reach.max()[axis];
    const auto cuts = cuts_between(upwards ? lo : hi, upwards ? hi : lo, options, "xyz"[axis]);
    if (!cuts)
        return cuts.problems();
    std::vector<Part> parts;
    for (const double cut : *cuts) {
        scene::Box clip =
            settings.clip.value_or(scene::Box{Eigen::Vector3d::Constant(-1e4), Eigen::Vector3d::Constant(1e4)});
        (upwards ? clip.lo : clip.hi)[axis] = cut;
        parts.push_back({last, clip, render::section_words(axis, cut, upwards, settings.clip_cuts), frame->time});
    }
    return parts;
}

/// The recording with no frames but those of the parts, which alone have a say in the scales.
Recording only(Recording recording, const std::vector<Part>& parts) {
    std::erase_if(recording.frames, [&](const RecordedFrame& frame) {
        return std::none_of(parts.begin(), parts.end(), [&](const Part& part) { return part.frame == frame.file; });
    });
    return recording;
}

std::string words_of(const Part& part, double time, const scene::Render& settings) {
    return part.words.empty() ? render::time_stamp(time, settings.every) : part.words;
}

/// Hands every frame up to the last that is wanted to show(frame, part) where it is one of the parts, to skip(frame)
/// where it is not and somebody wants to know it all the same.
template <class Show, class Skip>
Problems for_parts(const Recording& recording, const std::vector<Part>& parts, const StripOptions& options,
                   Replayed& done, const TellFrames& tell, Show&& show, Skip&& skip) {
    const bool trails = !options.redraw.settings.marks.trails.empty();
    auto part = parts.begin();
    for (const RecordedFrame& recorded : recording.frames) {
        const fs::path& file = recorded.file;
        const bool wanted = part != parts.end() && part->frame == file;
        if (part == parts.end() || (!wanted && !trails))
            continue;
        const auto frame = observe::read_frame(file, recording.layout);
        if (!frame)
            return frame.problems();
        if (!wanted)
            skip(*frame);
        for (; part != parts.end() && part->frame == file; ++part) {
            if (stop_wanted(options.redraw.when.stop)) {
                done.stopped = true;
                return {};
            }
            if (const Problems problems = show(*frame, *part).problems(); !problems.empty())
                return problems;
            done.first = done.frames == 0 ? frame->time : done.first;
            done.last = frame->time;
            tell(++done.frames, static_cast<std::int64_t>(parts.size()));
        }
    }
    return {};
}

void append_all(std::vector<std::string>& all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

template <class Painter> void foresee_all(const Recording& recording, const scene::Render& settings, Painter& painter) {
    if (settings.marks.arrows == "field")
        for (const RecordedFrame& recorded : recording.frames)
            if (const auto frame = observe::read_frame(recorded.file, recording.layout))
                painter.foresee(*frame);
}

template <class Medium>
Result<Replayed> draw_in_one(const Recording& recording, const std::vector<Part>& parts, const scene::Render& settings,
                             const StripOptions& options, const TellFrames& tell) {
    if (options.sections && settings.marks.arrows == "field" && !settings.marks.arrow_speed)
        return Problem{.key = "render.arrow_m_s",
                       .what = "the mean fields of several sections need one scale of arrows",
                       .fix = "give the speed of the legend's arrow: --arrow M_S"};
    render::StripPlan plan = options.plan;
    if (options.sections)
        plan.note = render::time_stamp(recording.frames.back().time, settings.every);
    for (const Part& part : parts)
        plan.captions.push_back(words_of(part, part.time, settings));
    auto painter = render::StripPainterOf<Medium>::open(
        settings, recording.layout,
        settings.view ? Eigen::AlignedBox3d(settings.view->lo, settings.view->hi) : recording.bounds, plan);
    if (!painter)
        return of_run(painter.problems(), recording.folder.root);
    if (const auto pace = pace_of(recording.frames))
        painter->expect_pace(*pace);
    if (!options.sections) // each of which has a field of its own
        foresee_all(recording, settings, *painter);
    Replayed done;
    done.warnings = recording.warnings;
    done.reason = for_parts(
        recording, parts, options, done, tell,
        [&](const observe::Frame& frame, const Part& part) -> Result<Done> {
            if (part.clip) {
                if (auto cut = painter->cut(*part.clip); !cut)
                    return cut;
                foresee_all(recording, settings, *painter);
            }
            painter->add(frame, words_of(part, frame.time, settings));
            return Done{};
        },
        [&](const observe::Frame& frame) { painter->pass_over(frame); });
    if (done.reason.empty() && !done.stopped) {
        auto work = painter->finish();
        BareWatch watch;
        watch.take(work.bare);
        append_all(done.warnings, watch.warnings());
        done.reason = save_readable(std::move(work), settings, options.out).problems();
    }
    return done;
}

Result<Replayed> draw_apart(const Recording& recording, const std::vector<Part>& parts, const scene::Render& settings,
                            const StripOptions& options, const TellFrames& tell) {
    auto painter = render::Painter::open(settings, recording.layout);
    if (!painter)
        return painter.problems();
    painter->fit(recording.bounds);
    if (const auto pace = pace_of(recording.frames))
        painter->expect_pace(*pace);
    if (!options.sections)
        foresee_all(recording, settings, *painter);
    if (const auto made = make_folder(options.out); !made)
        return made.problems();
    render::PngWriter writer;
    BareWatch watch;
    Replayed done;
    done.warnings = recording.warnings;
    done.reason = for_parts(
        recording, parts, options, done, tell,
        [&](const observe::Frame& frame, const Part& part) -> Result<Done> {
            scene::Render shown = settings;
            if (part.clip)
                shown.clip = part.clip;
            if (auto restyled = painter->restyle(shown); !restyled)
                return restyled;
            if (part.clip)
                foresee_all(recording, settings, *painter);
            const char* kind = part.clip ? "section" : "instant";
            auto picture = painter->draw(frame);
            watch.take(picture.bare);
            if (auto room = render::check_room(picture.crowded, settings); !room)
                return room;
            return writer.add(options.out / fmt::format("{}_{}.png", kind, done.frames + 1), std::move(picture));
        },
        [&](const observe::Frame& frame) { painter->pass_over(frame); });
    if (const Problems problems = writer.finish().problems(); done.reason.empty())
        done.reason = problems;
    append_all(done.warnings, watch.warnings());
    return done;
}

} // namespace

Result<Replayed> draw_strip(const fs::path& run, const StripOptions& options, const TellFrames& tell) {
    Result<Recording> recording = open_recording(run, options.redraw.when);
    if (!recording)
        return recording.problems();
    recording->layout = restyled_layout(*recording->layout, options.redraw);
    const auto parts = options.sections ? sections(*recording, options) : instants(*recording, options.plan.cells);
    if (!parts)
        return parts.problems();
    scene::Render wanted = options.redraw.settings;
    wanted.turn_deg_s = 0; // the parts have one view
    const auto settings = settle_scales(std::array{only(*recording, *parts)}, wanted);
    if (!settings)
        return settings.problems();
    const bool as_lines = render::is_drawing_file(options.out), in_one = ending_of(options.out) == ".png";
    Target target(options.out);
    if (const auto problem = target.claim(options.redraw.overwrite, ".png"))
        return *problem;
    auto done = as_lines ? draw_in_one<render::Lines>(*recording, *parts, *settings, options, tell)
                : in_one ? draw_in_one<render::Pixels>(*recording, *parts, *settings, options, tell)
                         : draw_apart(*recording, *parts, *settings, options, tell);
    if (done && done->reason.empty() && !done->stopped)
        target.keep();
    return done;
}

} // namespace tumble::run
