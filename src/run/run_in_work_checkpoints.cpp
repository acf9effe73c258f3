#include "base/archive.h"
#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"
#include "run/checkpoint_files.h"
#include "run/run_in_work.h"
#include "run/run_report.h"
#include "run/run_verdict.h"
#include "run/scene_changes.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

/// How a run keeps checkpoints, and goes on from one.
namespace tumble::run {

/// After observe_now and before keep_last_state, so that it holds neither more nor less than a run without end would
/// have seen by then.
void RunInWork::keep_checkpoint() {
    if (keep_every_ <= 0 || kept_step_ == simulation_->steps())
        return;
    const double begun = pace_.since_made();
    queue_->settle();
    if (const Problems problems = queue_->problems(); !problems.empty())
        return fail(problems);
    take_stock();
    Result<Done> ready = wait_for_beginnings();
    if (ready)
        ready = wait_for_outputs();
    const Result<std::int64_t> kept = ready ? run::keep_checkpoint(folder_.paths().checkpoints(), checkpoint_now())
                                            : Result<std::int64_t>(ready.problems());
    if (!ready)
        keep_every_ = 0; // a disk that lost what it was given may not say so again when asked once more
    kept_at_ = pace_.since_made();
    if (kept) {
        kept_step_ = simulation_->steps();
        ++summary_.checkpoints;
        summary_.checkpoint = checkpoint_path("state", kept_step_);
        summary_.checkpoint_bytes = *kept;
        summary_.checkpoints_s += kept_at_ - begun;
    } else if (!std::exchange(checkpoint_failed_, true)) {
        warn(fmt::format("no checkpoint could be written at t = {:.6g} s, and earlier ones stay: {} {}",
                         simulation_->time(), kept.problems()[0].file, kept.problems()[0].what));
    }
}

Checkpoint RunInWork::checkpoint_now() const {
    Checkpoint now;
    now.build_mark = build_mark();
    now.scene = toml_;
    now.meshes = meshes_;
    now.summary = summary_;
    now.outputs = {options_.pictures, options_.video, options_.paraview, options_.text_dump, options_.video_file};
    now.step = simulation_->steps();
    now.time = simulation_->time();
    now.shots = shots_;
    now.last_shot = last_shot_;
    now.series_size = series_->size();
    now.plot_measure = scene_.render.plot_measure;
    now.plot_times = plot_.times;
    now.plot_values = plot_.values;
    ArchiveWriter tracers;
    for (const observe::TracerReader& tracer : tracers_)
        tracers(tracer);
    now.tracers = tracers.take();
    now.world = simulation_->state();
    return now;
}

/// Once, before the first checkpoint: what a run that is resumed reads beside it, and the names of all that.
Result<Done> RunInWork::wait_for_beginnings() {
    if (begun_to_last_)
        return Done{};
    const RunFolder& paths = folder_.paths();
    if (Result<Done> made = make_folder(paths.checkpoints()); !made)
        return made;
    std::vector<std::filesystem::path> places{paths.scene(), observe::layout_path(paths.frames())};
    for (const MeshMark& mesh : meshes_)
        places.push_back(paths.root / mesh.name);
    if (!meshes_.empty())
        places.push_back(paths.meshes());
    for (const std::filesystem::path& place : places)
        if (Result<Done> there = observe::wait_for_disk(place); !there)
            return there;
    Result<Done> named = folder_.wait_for_names();
    begun_to_last_ = named.ok();
    return named;
}

/// A checkpoint counts on rows and frames: they must be on the disk before it is.
Result<Done> RunInWork::wait_for_outputs() {
    const RunFolder& paths = folder_.paths();
    if (Result<Done> there = observe::wait_for_disk(paths.series()); !there)
        return there;
    for (; lasting_ < shots_; ++lasting_)
        if (Result<Done> there = observe::wait_for_disk(observe::frame_path(paths.frames(), lasting_)); !there)
            return there;
    return observe::wait_for_disk(paths.frames());
}

Result<std::unique_ptr<RunInWork>> RunInWork::go_on(const scene::Scene& scene, const RunOptions& options,
                                                    RunListener& listener, const std::vector<MeshCopy>& meshes) {
    const RunFolder place{folder_for(scene, options)};
    const std::string toml = resolved(scene, meshes);
    Result<FolderInWork> folder = FolderInWork::go_on(place.root);
    if (!folder)
        return folder.problems();
    Result<Resumable> found = find_checkpoint(scene, toml, marks_of(meshes), place, options);
    if (!found)
        return in_scene(found.problems(), scene);
    std::unique_ptr<RunInWork> run(
        new RunInWork(scene, options, listener, std::move(found->simulation), std::move(*folder), toml));
    run->take_up(*found);
    if (run->nothing_left_to_do()) {
        run->done_before_ = true;
        return run;
    }
    run->summary_.resumed.push_back(
        {found->name, run->resumed_->step, run->resumed_->time, run->resumed_->build_mark, found->changes});
    if (const Result<Done> opened = run->open_all(meshes); !opened)
        return in_scene(opened.problems(), scene);
    const Result<std::vector<std::int64_t>> missing = cut_back(place, *run->resumed_);
    if (!missing)
        return missing.problems();
    if (!missing->empty())
        found->warnings.push_back(frames_in_words(*missing) + " of this run are missing and stay so");
    for (std::string& warning : found->warnings)
        run->warn(std::move(warning));
    run->bring_back_frames();
    return run;
}

/// What the run had been doing goes on: outputs that it kept are kept, sums go on from where they were.
void RunInWork::take_up(Resumable& found) {
    Checkpoint& from = found.from;
    options_.pictures = options_.pictures || from.outputs.pictures;
    options_.video = options_.video || from.outputs.video;
    options_.paraview = options_.paraview || from.outputs.paraview;
    options_.text_dump = options_.text_dump || from.outputs.text_dump;
    if (options_.video_file.empty())
        options_.video_file = from.outputs.video_file;
    rows_.pass(from.step);
    frames_.pass(from.step);
    shots_ = lasting_ = from.shots;
    last_shot_ = from.last_shot;
    kept_step_ = from.step;
    if (from.plot_measure == scene_.render.plot_measure) {
        plot_.times = std::move(from.plot_times);
        plot_.values = std::move(from.plot_values);
    }
    summary_ = from.summary; // which was written into the checkpoint before it was one
    summary_.checkpoint = found.name;
    resumed_ = std::move(from);
}

bool RunInWork::nothing_left_to_do() const {
    const RunFolder& paths = folder_.paths();
    const auto there = [](const std::filesystem::path& place) {
        std::error_code ignored;
        return std::filesystem::exists(place, ignored);
    };
    std::error_code ignored;
    const bool series_whole = std::filesystem::file_size(paths.series(), ignored) == resumed_->series_size;
    const std::size_t frames = observe::list_frames(paths.frames()).size();
    const nlohmann::json left = read_summary(paths);
    return resumed_->step >= all_steps_ && resumed_->scene == toml_ && series_whole &&
           left.value("state", nlohmann::json()) == "finished" && left.value("frames", nlohmann::json()) == frames &&
           (!options_.pictures || count_pictures(paths.pictures()) >= static_cast<std::int64_t>(frames)) &&
           (!options_.video || there(video_file())) && (!options_.paraview || there(paths.paraview())) &&
           (!options_.text_dump || there(paths.text_dump()));
}

RunSummary RunInWork::as_it_was_left() {
    const RunFolder& paths = folder_.paths();
    begin_summary();
    summary_.state = "finished";
    summary_.checkpoint = checkpoint_path("state", resumed_->step);
    summary_.frames = static_cast<std::int64_t>(observe::list_frames(paths.frames()).size());
    summary_.pictures = count_pictures(paths.pictures());
    summary_.unfilled = simulation_->unfilled();
    for (std::string& sentence : verdict(summary_, scene_))
        warn(std::move(sentence));
    listener_.nothing_left_to_do(paths.root);
    return summary_;
}

Result<Done> RunInWork::recall_tracers() {
    ArchiveReader before(resumed_->tracers);
    for (observe::TracerReader& tracer : tracers_)
        before(tracer);
    if (!before.whole())
        return Problem{.file = folder_.paths().checkpoints().string(),
                       .what = "the checkpoint keeps something else of the tracers than this program",
                       .fix = "go on with the program that wrote it, or run the scene again"};
    return Done{};
}

/// What was made of the frames so far and cannot be gone on with, or is missing, is made again.
void RunInWork::bring_back_frames() {
    if (!options_.pictures && !options_.video && !options_.paraview && !options_.text_dump)
        return;
    for (std::int64_t number = 0; number < shots_ && !stop_wanted(options_.stop); ++number) {
        Result<observe::Frame> frame =
            observe::read_frame(observe::frame_path(folder_.paths().frames(), number), layout_);
        if (!frame)
            continue; // told of by cut_back, or by what reads the frames later
        Shot shot{std::move(*frame), number, plot_, true};
        const auto later =
            std::upper_bound(plot_.times.begin(), plot_.times.end(), shot.frame.time) - plot_.times.begin();
        shot.plot.times.resize(static_cast<std::size_t>(later));
        shot.plot.values.resize(static_cast<std::size_t>(later));
        queue_->push(std::move(shot));
        listener_.brought_back(number + 1, shots_);
    }
}

} // namespace tumble::run
