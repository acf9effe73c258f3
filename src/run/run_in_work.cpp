#include "run/run_in_work.h"

#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/fill_plan.h"
#include "run/picture_sink.h"
#include "run/run_report.h"
#include "run/scene_doubts.h"
#include "run/state_sinks.h"
#include "run/view_box.h"
#include "scene/to_toml.h"
#include "scene/written.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::run {

namespace {

// A percent of energy is more than the step should cost.
constexpr double closure_worth_a_word = 0.01;

std::filesystem::path folder_for(const scene::Scene& scene, const RunOptions& options) {
    return options.folder.empty() ? std::filesystem::path("out") / scene.file.stem() : options.folder;
}

double turned_over(const Books& books) {
    return books.kinetic_translation + books.kinetic_rotation + books.stored_normal + books.stored_tangential +
           books.lost_normal_damping + books.lost_tangential_damping + books.lost_sliding + books.lost_history +
           books.lost_global_damping;
}

Problems in_scene(Problems problems, const scene::Scene& scene) {
    for (Problem& problem : problems)
        problem = scene::placed(scene, std::move(problem));
    return problems;
}

void append(Problems& all, const Problems& more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

RunInWork::RunInWork(const scene::Scene& scene, const RunOptions& options, RunListener& listener,
                     SimulationPtr simulation, FolderInWork folder)
    : scene_(scene), options_(options), listener_(listener), simulation_(std::move(simulation)),
      folder_(std::move(folder)), layout_(simulation_->layout()), rows_(scene.observe.every, scene.time_step),
      frames_(scene.render.every, scene.time_step), all_steps_(std::llround(scene.duration / scene.time_step)) {
    summary_.state = "running";
    summary_.folder = folder_.paths().root;
    summary_.scene = scene.file;
    summary_.title = scene.title;
    summary_.duration = scene.duration;
    summary_.time_step = scene.time_step;
    summary_.seed = scene.seed;
    summary_.threads = options.threads;
    summary_.video = options.video;
    summary_.video_slowdown = scene.render.slowdown();
}

Result<std::unique_ptr<RunInWork>> RunInWork::prepare(const scene::Scene& scene, const RunOptions& options,
                                                      RunListener& listener) {
    Problems problems = observe::choose_measures(scene.observe.measures).problems();
    if (options.pictures || options.video)
        append(problems, check_pictures(scene.render));
    if (!problems.empty())
        return in_scene(problems, scene);
    Result<SimulationPtr> simulation = simulate(scene, options.threads);
    if (!simulation)
        return simulation.problems();
    const auto bodies = static_cast<std::size_t>(all_bodies_wanted(scene, (*simulation)->bodies()));
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    const auto count = static_cast<std::size_t>(Schedule(scene.render.every, scene.time_step).count(last));
    Result<FolderInWork> folder = FolderInWork::open(folder_for(scene, options), options.overwrite,
                                                     count * observe::frame_bytes(bodies, scene.walls.size()));
    if (!folder)
        return folder.problems();
    std::unique_ptr<RunInWork> run(new RunInWork(scene, options, listener, std::move(*simulation), std::move(*folder)));
    for (const auto part : {&RunInWork::choose_what_to_see, &RunInWork::write_beginnings})
        if (const Result<Done> done = (run.get()->*part)(); !done)
            return in_scene(done.problems(), scene);
    Result<FrameSinks> sinks = run->open_sinks();
    if (!sinks)
        return in_scene(sinks.problems(), scene);
    run->queue_ = std::make_unique<FrameQueue>(std::move(*sinks));
    run->folder_.keep();
    for (const std::string& doubt : scene_doubts(scene, run->simulation_->bodies()))
        run->warn(doubt);
    return run;
}

Result<Done> RunInWork::choose_what_to_see() {
    auto chosen = observe::choose_measures(scene_.observe.measures);
    if (!chosen)
        return chosen.problems();
    measures_ = std::move(*chosen);
    const auto plotted = observe::choose_measures({scene_.render.plot_measure});
    if (plotted && plotted->size() == 1) {
        plotted_ = plotted->front();
        plot_.label = observe::spelled_name(plotted_->name);
        plot_.unit = observe::spelled_unit(plotted_->unit);
        plot_.until = scene_.duration;
    }
    return Done{};
}

Result<Done> RunInWork::write_beginnings() {
    const RunFolder& paths = folder_.paths();
    std::vector<std::string> heads{"time_s"};
    for (const observe::Measure& measure : measures_)
        heads.push_back(measure.column());
    Problems problems;
    append(problems, observe::write_whole(paths.scene(), scene::to_toml(scene_)).problems());
    append(problems, observe::write_layout(observe::layout_path(paths.frames()), *layout_).problems());
    append(problems, observe::write_whole(paths.summary(), to_json(summary_).dump(2) + "\n").problems());
    auto series = observe::SeriesWriter::create(paths.series(), heads);
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
    sinks.push_back(keep_states(paths.frames()));
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

bool RunInWork::stop_wanted() const {
    return options_.stop && options_.stop->load(std::memory_order_relaxed);
}

void RunInWork::step_to_the_end() {
    listener_.started(summary_.folder, progress());
    observe_now();
    while (summary_.state == "running") {
        const std::int64_t step = simulation_->steps();
        if (step >= all_steps_) {
            summary_.state = "finished";
            break;
        }
        if (stop_wanted()) {
            summary_.state = "stopped";
            break;
        }
        const std::int64_t next = std::min({rows_.next(), frames_.next(), all_steps_, step + pace_.stretch()});
        pace_.start();
        const std::optional<Problem> problem = simulation_->advance(next - step);
        const std::int64_t done = simulation_->steps() - step;
        pace_.stop(done);
        summary_.body_steps += static_cast<double>(done) * static_cast<double>(simulation_->books().bodies);
        if (problem)
            fail({*problem});
        else
            observe_now();
        listener_.progressed(progress());
    }
}

void RunInWork::observe_now() {
    const std::int64_t step = simulation_->steps();
    const bool row = rows_.due(step);
    const bool shot = frames_.due(step);
    if (!row && !shot)
        return;
    observe::Frame frame = simulation_->frame();
    rows_.pass(row ? step : step - 1);
    frames_.pass(shot ? step : step - 1);
    if (row)
        if (const Result<Done> added = add_row(frame, simulation_->books()); !added)
            fail(added.problems());
    if (shot)
        queue_->push({std::move(frame), shots_++, plot_});
    if (const Problems problems = queue_->problems(); !problems.empty())
        fail(problems);
}

Result<Done> RunInWork::add_row(const observe::Frame& frame, const Books& books) {
    const observe::Seen seen(frame, books);
    std::vector<double> row{frame.time};
    for (const observe::Measure& measure : measures_)
        row.push_back(measure.value(seen));
    if (plotted_) {
        plot_.times.push_back(frame.time);
        plot_.values.push_back(plotted_->value(seen));
    }
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
    summary_.warnings.push_back(std::move(sentence));
}

Progress RunInWork::progress() const {
    Progress now;
    now.time = simulation_->time();
    now.duration = scene_.duration;
    now.step = simulation_->steps();
    now.steps = all_steps_;
    now.steps_per_s = pace_.steps_per_s();
    now.left_s = now.steps_per_s > 0 ? static_cast<double>(all_steps_ - now.step) / now.steps_per_s : 0;
    now.books = simulation_->books();
    return now;
}

void RunInWork::sum_up() {
    summary_.time = simulation_->time();
    summary_.steps = simulation_->steps();
    summary_.books = simulation_->books();
    summary_.bodies = summary_.books.bodies;
    summary_.phases = simulation_->phase_times();
    summary_.stepping_s = pace_.seconds();
    summary_.wall_s = pace_.since_made();
    summary_.frames = queue_->taken();
    summary_.pictures = options_.pictures ? summary_.frames : 0;
    summary_.unfilled = simulation_->unfilled();
    summary_.energy_turnover = std::max(summary_.energy_turnover, turned_over(summary_.books));
    for (const std::string& sentence : summary_.unfilled)
        warn("not all bodies found room: " + sentence);
    if (summary_.overlap_ratio_max > scene_.contact.accepted_overlap)
        warn(fmt::format("bodies overlapped by up to {:.1f} % of the smaller sphere's radius, and the scene expects at "
                         "most {:.3g} %: take stiffer materials or slower impacts, or say contact.accepted_overlap",
                         100 * summary_.overlap_ratio_max, 100 * scene_.contact.accepted_overlap));
    const double missed = std::abs(summary_.books.closure);
    if (missed > closure_worth_a_word * summary_.energy_turnover)
        warn(fmt::format("the energy balance misses {:.3g} J of {:.3g} J: try a smaller time step", missed,
                         summary_.energy_turnover));
}

RunSummary RunInWork::finish() {
    if (const Problems problems = queue_->close(); !problems.empty())
        fail(problems);
    sum_up();
    folder_.release_reserve();
    const auto written = observe::write_whole(folder_.paths().summary(), to_json(summary_).dump(2) + "\n");
    if (!written)
        fail(written.problems());
    return summary_;
}

} // namespace tumble::run
