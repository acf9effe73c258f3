#include "run/run_in_work.h"

#include "base/thrown.h"
#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/fill_plan.h"
#include "run/measure_names.h"
#include "run/picture_sink.h"
#include "run/run_report.h"
#include "run/run_verdict.h"
#include "run/scene_changes.h"
#include "run/scene_check.h"
#include "run/state_sinks.h"
#include "run/tracers.h"
#include "run/view_box.h"
#include "scene/to_toml.h"
#include "scene/written.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::run {

namespace {

constexpr double refresh_every = 1; // s of wall time between versions of run.json
constexpr double keep_every = 60;   // the same between checkpoints, where the run is not told

/// A frame with numbers that are none could not be read again.
bool finite(const observe::Frame& frame) {
    const auto all = [](const std::vector<Eigen::Vector3d>& values) {
        return std::all_of(values.begin(), values.end(), [](const Eigen::Vector3d& v) { return v.allFinite(); });
    };
    return all(frame.position) && all(frame.velocity) && all(frame.angular_velocity);
}

/// What the frames of the whole run will take at least.
std::uintmax_t bytes_of_frames(const scene::Scene& scene, const Simulation& simulation) {
    const auto bodies = static_cast<std::size_t>(all_bodies_wanted(scene, simulation.bodies()));
    const std::int64_t last = std::llround(scene.duration / scene.step());
    const auto count = static_cast<std::size_t>(Schedule(scene.render.every, scene.step()).count_with_last(last));
    return count * observe::frame_bytes(bodies, scene.walls.size());
}

/// Box2D does not give away what it remembers of its contacts.
bool keeps_checkpoints(const scene::Scene& scene) {
    return scene.solver != scene::Solver::box2d;
}

Problems check_options(const scene::Scene& scene, const RunOptions& options) {
    if (keeps_checkpoints(scene))
        return {};
    if (options.resume)
        return {scene::problem_about(scene, "solver", "a run of solver = \"box2d\" keeps no checkpoints to resume from",
                                     "leave out --resume; --force runs it again from the start")};
    if (options.checkpoint_every.value_or(0) > 0)
        return {scene::problem_about(scene, "solver", "a run of solver = \"box2d\" can keep no checkpoints",
                                     "leave out --checkpoint-every, or write solver = \"soft\"")};
    return {};
}

} // namespace

std::filesystem::path folder_for(const scene::Scene& scene, const RunOptions& options) {
    return options.folder.empty() ? std::filesystem::path("out") / scene.file.stem() : options.folder;
}

std::string resolved(scene::Scene scene, const std::vector<MeshCopy>& meshes) {
    if (scene.observe.measures.empty())
        scene.observe.measures = observe::usual_measures();
    return scene::to_toml(scene, names_of(meshes));
}

Problems in_scene(Problems problems, const scene::Scene& scene) {
    for (Problem& problem : problems)
        problem = scene::placed(scene, std::move(problem));
    return problems;
}

RunInWork::RunInWork(const scene::Scene& scene, const RunOptions& options, RunListener& listener,
                     SimulationPtr simulation, FolderInWork folder, std::string toml)
    : scene_(scene), options_(options), listener_(listener), simulation_(std::move(simulation)),
      folder_(std::move(folder)), toml_(std::move(toml)), layout_(simulation_->layout()),
      rows_(scene.observe.every, scene.step()), frames_(scene.render.every, scene.step()),
      all_steps_(std::llround(scene.duration / scene.step())),
      keep_every_(keeps_checkpoints(scene) ? options.checkpoint_every.value_or(keep_every) : 0) {}

Result<std::unique_ptr<RunInWork>> RunInWork::prepare(const scene::Scene& scene, const RunOptions& options,
                                                      RunListener& listener) {
    if (Problems problems = check_options(scene, options); !problems.empty())
        return problems;
    if (const Problems problems = check_measures(scene); !problems.empty())
        return in_scene(problems, scene);
    const Result<std::vector<MeshCopy>> meshes = read_meshes(scene);
    if (!meshes)
        return meshes.problems();
    if (!options.resume)
        return begin(scene, options, listener, *meshes);
    const Found found = look_into(folder_for(scene, options));
    if (found == Found::run)
        return go_on(scene, options, listener, *meshes);
    RunOptions anew = options;
    anew.overwrite = anew.overwrite || found == Found::beginning;
    return begin(scene, anew, listener, *meshes);
}

Result<std::unique_ptr<RunInWork>> RunInWork::begin(const scene::Scene& scene, const RunOptions& options,
                                                    RunListener& listener, const std::vector<MeshCopy>& meshes) {
    Result<SimulationPtr> simulation =
        simulate(scene, options.threads, options.stop, [&](auto... told) { listener.prepares(told...); });
    if (!simulation)
        return simulation.problems();
    Result<FolderInWork> folder =
        FolderInWork::open(folder_for(scene, options), options.overwrite, bytes_of_frames(scene, **simulation));
    if (!folder)
        return folder.problems();
    std::unique_ptr<RunInWork> run(
        new RunInWork(scene, options, listener, std::move(*simulation), std::move(*folder), resolved(scene, meshes)));
    if (const Result<Done> opened = run->open_all(meshes); !opened)
        return in_scene(opened.problems(), scene);
    run->folder_.keep();
    return run;
}

/// What was asked for.
void RunInWork::begin_summary() {
    summary_.folder = folder_.paths().root;
    summary_.scene = scene_.file;
    if (resumed_ && scene_.file == folder_.paths().scene()) // its own copy is not where it came from
        summary_.scene = read_summary(folder_.paths()).value("scene", scene_.file.string());
    summary_.title = scene_.title;
    summary_.duration = scene_.duration;
    summary_.solver = scene_.solver;
    summary_.time_step = scene_.step();
    summary_.seed = scene_.seed;
    summary_.threads = options_.threads;
    summary_.video = options_.video;
    summary_.video_slowdown = scene_.render.slowdown();
    summary_.video_file = video_file();
}

Result<Done> RunInWork::open_all(const std::vector<MeshCopy>& meshes) {
    begin_summary();
    summary_.state = "running";
    meshes_ = marks_of(meshes);
    if (Result<Done> chosen = choose_what_to_see(); !chosen)
        return chosen;
    Result<FrameSinks> sinks = open_sinks();
    if (!sinks)
        return sinks.problems();
    if (Result<Done> written = write_beginnings(meshes); !written)
        return written;
    queue_ = std::make_unique<FrameQueue>(std::move(*sinks));
    return Done{};
}

Result<Done> RunInWork::choose_what_to_see() {
    auto chosen = observe::choose_measures(without_tracers(scene_.observe.measures));
    if (!chosen)
        return chosen.problems();
    measures_ = std::move(*chosen);
    auto tracers = tracers_of(scene_, simulation_->bodies());
    if (!tracers)
        return tracers.problems();
    tracers_ = std::move(*tracers);
    if (resumed_)
        if (Result<Done> recalled = recall_tracers(); !recalled)
            return recalled;
    auto plotted = find_plotted(scene_.render, traced_bodies(scene_.observe.measures));
    if (!plotted)
        return plotted.problems();
    plotted_ = std::move(*plotted);
    plot_.label = plotted_->label;
    plot_.unit = plotted_->unit;
    plot_.until = scene_.duration;
    const std::vector<std::string> heads = heads_of_rows();
    const auto at = std::find(heads.begin(), heads.end(), plotted_->column);
    if (at != heads.end())
        plotted_at_ = static_cast<std::size_t>(at - heads.begin());
    return Done{};
}

std::vector<std::string> RunInWork::heads_of_rows() const {
    std::vector<std::string> heads{"time_s"};
    for (const observe::Measure& measure : measures_)
        heads.push_back(measure.column());
    for (const observe::TracerReader& tracer : tracers_)
        for (std::string& head : tracer.columns())
            heads.push_back(std::move(head));
    return heads;
}

Result<Done> RunInWork::write_beginnings(const std::vector<MeshCopy>& meshes) {
    const RunFolder& paths = folder_.paths();
    const std::vector<std::string> heads = heads_of_rows();
    Problems problems;
    append(problems, write_meshes(meshes, paths).problems());
    append(problems, observe::write_whole(paths.scene(), toml_).problems());
    append(problems, observe::write_layout(observe::layout_path(paths.frames()), *layout_).problems());
    append(problems, observe::write_whole(paths.summary(), to_json(summary_).dump(2) + "\n").problems());
    auto series = resumed_ ? observe::SeriesWriter::go_on(paths.series(), heads, resumed_->series_size)
                           : observe::SeriesWriter::create(paths.series(), heads);
    append(problems, series.problems());
    if (!problems.empty())
        return problems;
    series_ = std::move(*series);
    return Done{};
}

std::filesystem::path RunInWork::video_file() const {
    if (!options_.video)
        return {};
    return options_.video_file.empty() ? folder_.paths().video() : options_.video_file;
}

Result<FrameSinks> RunInWork::open_sinks() {
    const RunFolder& paths = folder_.paths();
    FrameSinks sinks;
    Problems problems;
    const auto add = [&](Result<std::unique_ptr<FrameSink>> sink) {
        append(problems, sink.problems());
        if (sink)
            sinks.push_back(std::move(*sink));
    };
    sinks.push_back(keep_states(paths.frames())); // first: what is drawn of a frame can be drawn again from it
    if (options_.pictures || options_.video)
        add(keep_pictures(scene_.render, layout_,
                          {.folder = options_.pictures ? paths.pictures() : "", .video = video_file()},
                          view_box(scene_, *layout_)));
    if (options_.paraview)
        add(keep_for_paraview(paths.paraview()));
    if (options_.text_dump)
        add(keep_as_text(paths.text_dump()));
    if (!problems.empty())
        return problems;
    return sinks;
}

void RunInWork::step_to_the_end() {
    listener_.started(summary_.folder, progress());
    for (std::string& sentence : check_built(scene_, *simulation_).warnings)
        warn(std::move(sentence));
    if (!resumed_) {
        observe_now();
        keep_checkpoint();
    }
    while (summary_.state == "running") {
        const std::int64_t step = simulation_->steps();
        if (step >= all_steps_) {
            summary_.state = "finished";
            break;
        }
        if (stop_wanted(options_.stop)) {
            summary_.state = "stopped";
            break;
        }
        const std::int64_t next = std::min({rows_.next(), frames_.next(), all_steps_, step + pace_.stretch()});
        pace_.start();
        const std::optional<Problem> problem = simulation_->advance(next - step);
        const std::int64_t done = simulation_->steps() - step;
        pace_.stop(done);
        summary_.body_steps += static_cast<double>(done) * static_cast<double>(simulation_->books().bodies);
        if (problem) {
            summary_.own_fault = summary_.state != "failed";
            fail({*problem});
        } else {
            observe_now();
        }
        if (summary_.state == "running" && pace_.since_made() >= kept_at_ + keep_every_)
            keep_checkpoint();
        refresh_summary();
        listener_.progressed(progress());
    }
    if (summary_.state != "failed")
        keep_checkpoint();
    keep_last_state();
}

void RunInWork::break_off(const std::exception& error) {
    Problem problem = problem_of(error);
    problem.what = fmt::format("the run broke off at t = {:.6g} s: {}", simulation_->time(), problem.what);
    fail({problem});
}

observe::Frame RunInWork::frame_to_keep() const {
    observe::Frame frame = simulation_->frame();
    if (scene_.observe.contacts)
        frame.contacts = simulation_->contacts();
    return frame;
}

void RunInWork::observe_now() {
    const std::int64_t step = simulation_->steps();
    const bool row = rows_.due(step);
    const bool shot = frames_.due(step);
    if (!row && !shot)
        return;
    observe::Frame frame = shot ? frame_to_keep() : simulation_->frame();
    rows_.pass(row ? step : step - 1);
    frames_.pass(shot ? step : step - 1);
    if (row)
        if (const Result<Done> added = add_row(frame, simulation_->books()); !added)
            fail(added.problems());
    if (shot) {
        queue_->push({std::move(frame), shots_++, plot_});
        last_shot_ = step;
    }
    if (const Problems problems = queue_->problems(); !problems.empty())
        fail(problems);
}

/// What the schedule misses: the state at the end, at Ctrl-C or at a failure is what one wants to see.
void RunInWork::keep_last_state() {
    if (last_shot_ == simulation_->steps())
        return;
    observe::Frame frame = frame_to_keep();
    if (finite(frame))
        queue_->push({std::move(frame), shots_++, plot_});
}

/// So that run.json says how far a run came that is killed. A disk that is full is told by the frames.
void RunInWork::refresh_summary() {
    if (pace_.since_made() < refreshed_ + refresh_every)
        return;
    take_stock();
    (void)observe::write_whole(folder_.paths().summary(), to_json(summary_).dump(2) + "\n");
    refreshed_ = pace_.since_made();
}

Result<Done> RunInWork::add_row(const observe::Frame& frame, const Books& books) {
    const observe::Seen seen(frame, books, scene_.observe.axes_turned);
    std::vector<double> row{frame.time};
    for (const observe::Measure& measure : measures_)
        row.push_back(measure.value(seen));
    for (observe::TracerReader& tracer : tracers_)
        for (const double value : tracer.row(frame))
            row.push_back(value);
    plot_.times.push_back(frame.time);
    plot_.values.push_back(plotted_at_ ? row[*plotted_at_] : plotted_->measure->value(seen));
    summary_.overlap_ratio_max = books.overlap_ratio_peak;
    summary_.energy_turnover = std::max(summary_.energy_turnover, turned_over(books));
    ++summary_.rows;
    return series_->write(row);
}

void RunInWork::fail(const Problems& problems) {
    summary_.state = "failed";
    if (summary_.reason.empty())
        summary_.reason = problems;
}

void RunInWork::warn(std::string sentence) {
    listener_.warned(sentence);
    // A run that is resumed has told some of it before.
    if (std::find(summary_.warnings.begin(), summary_.warnings.end(), sentence) == summary_.warnings.end())
        summary_.warnings.push_back(std::move(sentence));
}

Progress RunInWork::progress() const {
    Progress now;
    now.time = simulation_->time();
    now.duration = scene_.duration;
    now.step = simulation_->steps();
    now.steps = all_steps_;
    now.steps_per_s = pace_.steps_per_s();
    now.left_s = pace_.seconds_for(all_steps_ - now.step);
    const double passed = pace_.since_made();
    now.waiting_share = queue_ && passed > 0 ? queue_->waited_s() / passed : 0;
    now.books = simulation_->books();
    return now;
}

void RunInWork::take_stock() {
    summary_.time = simulation_->time();
    summary_.steps = simulation_->steps();
    summary_.books = simulation_->books();
    summary_.bodies = summary_.books.bodies;
    const RunSummary before = resumed_ ? resumed_->summary : RunSummary{};
    summary_.phases = simulation_->phase_times();
    for (std::size_t k = 0; k < std::min(summary_.phases.size(), before.phases.size()); ++k)
        summary_.phases[k].seconds += before.phases[k].seconds;
    summary_.stepping_s = before.stepping_s + pace_.seconds();
    summary_.wall_s = before.wall_s + pace_.since_made();
    summary_.processor_s = before.processor_s + pace_.processor_since_made();
    summary_.frames_s = before.frames_s + queue_->worked_s();
    summary_.waited_s = before.waited_s + queue_->waited_s();
    summary_.frames = queue_->taken() + (resumed_ ? resumed_->shots : 0);
    summary_.pictures = options_.pictures ? summary_.frames : 0;
    summary_.energy_turnover = std::max(summary_.energy_turnover, turned_over(summary_.books));
}

RunSummary RunInWork::finish() {
    if (const Problems problems = queue_->close(); !problems.empty())
        fail(problems);
    take_stock();
    // A sink that failed may have kept a frame that others did not.
    summary_.frames = static_cast<std::int64_t>(observe::list_frames(folder_.paths().frames()).size());
    summary_.pictures = count_pictures(folder_.paths().pictures());
    summary_.unfilled = simulation_->unfilled();
    for (std::string& sentence : verdict(summary_, scene_))
        warn(std::move(sentence));
    folder_.release_reserve();
    const auto written = observe::write_whole(folder_.paths().summary(), to_json(summary_).dump(2) + "\n");
    if (!written)
        fail(written.problems());
    return summary_;
}

} // namespace tumble::run
