#include "run/part_loads.h"

#include "base/make_folder.h"
#include "observe/frame_file.h"
#include "observe/measures.h"
#include "run/build_mark.h"
#include "run/checkpoint_files.h"
#include "run/load_recorder.h"
#include "run/resume.h"
#include "run/run_in_work.h"
#include "run/scene_changes.h"
#include "run/scene_doubts.h"
#include "run/schedule.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace tumble::run {

namespace {

Progress progress_of(const Simulation& simulation, const scene::Scene& scene, std::int64_t last, double steps_per_s) {
    Progress now;
    now.time = simulation.time();
    now.duration = scene.duration;
    now.step = simulation.steps();
    now.steps = last;
    now.steps_per_s = steps_per_s;
    if (steps_per_s > 0)
        now.left_s = static_cast<double>(last - now.step) / steps_per_s;
    now.books = simulation.books();
    return now;
}

/// Before hours are spent: a run that no instant falls into. `last`: its last step.
std::optional<Problem> refuse_without_instants(const scene::Scene& scene, const LoadOptions& options,
                                               std::int64_t first, std::int64_t last) {
    Schedule instants(options.every, scene.time_step);
    instants.pass(first - 1);
    if (instants.next() <= last)
        return std::nullopt;
    if (first > last)
        return Problem{.file = scene.file.string(),
                       .what = fmt::format("the run ends at {:.6g} s, before it is to be looked at: --from {:.6g}",
                                           scene.duration, options.from),
                       .fix = "begin earlier: --from; or run longer: --duration"};
    return Problem{.file = scene.file.string(),
                   .what =
                       fmt::format("no instant of --every {:.6g} lies between {:.6g} s and the run's end at {:.6g} s",
                                   options.every, options.from, scene.duration),
                   .fix = "look more often: --every; or run longer: --duration"};
}

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// What a run of loads leaves in its folder while it goes.
class LoadFolder {
public:
    static Result<LoadFolder> open(const scene::Scene& scene, const LoadOptions& options) {
        LoadFolder folder(options);
        if (options.folder.empty())
            return folder;
        const auto meshes = read_meshes(scene);
        if (!meshes)
            return meshes.problems();
        folder.toml_ = resolved(scene, *meshes);
        folder.meshes_ = marks_of(*meshes);
        if (const auto made = make_folder(folder.paths_.frames()); !made)
            return made.problems();
        return folder;
    }

    [[nodiscard]] bool can_resume() const { return options_.resume && !list_checkpoints(paths_.checkpoints()).empty(); }

    Result<SimulationPtr> begin(const scene::Scene& scene, RunListener& listener) const {
        auto simulation =
            simulate(scene, options_.threads, options_.stop, [&](auto... told) { listener.prepares(told...); });
        if (!simulation || options_.folder.empty())
            return simulation;
        std::error_code ignored;
        for (const auto& old : {observe::list_frames(paths_.frames()), list_checkpoints(paths_.checkpoints())})
            for (const std::filesystem::path& file : old)
                std::filesystem::remove(file, ignored);
        if (const auto written = observe::write_layout(observe::layout_path(paths_.frames()), *(*simulation)->layout());
            !written)
            return written.problems();
        return simulation;
    }

    Result<SimulationPtr> go_on(const scene::Scene& scene, LoadRecorder& recorder, RunListener& listener) const {
        RunOptions as_run;
        as_run.threads = options_.threads;
        as_run.stop = options_.stop;
        auto found = find_checkpoint(scene, toml_, meshes_, paths_, as_run);
        if (!found)
            return found.problems();
        if (const auto recalled = recorder.recall(found->from.tracers); !recalled)
            return recalled.problems();
        for (const std::string& warning : found->warnings)
            listener.warned(warning);
        return std::move(found->simulation);
    }

    /// At the end of the run, and where the last one is older than wanted; `now`: s of wall time.
    void keep(const Simulation& simulation, const LoadRecorder& recorder, double now, bool last,
              RunListener& listener) {
        if (options_.folder.empty() || !(options_.checkpoint_every > 0) ||
            (!last && now < kept_ + options_.checkpoint_every))
            return;
        Checkpoint checkpoint;
        checkpoint.build_mark = build_mark();
        checkpoint.scene = toml_;
        checkpoint.meshes = meshes_;
        checkpoint.step = simulation.steps();
        checkpoint.time = simulation.time();
        checkpoint.tracers = recorder.state();
        checkpoint.world = simulation.state();
        kept_ = now;
        if (const auto written = keep_checkpoint(paths_.checkpoints(), checkpoint); !written)
            listener.warned(fmt::format("no checkpoint could be written at t = {:.6g} s: {}", checkpoint.time,
                                        written.problems()[0].what));
    }

private:
    explicit LoadFolder(const LoadOptions& options) : options_(options), paths_{options.folder} {}

    const LoadOptions& options_;
    RunFolder paths_;
    std::string toml_;
    std::vector<MeshMark> meshes_;
    double kept_ = 0; // s of wall time
};

} // namespace

Result<int> find_specimen(const scene::Scene& scene, const std::string& name) {
    std::vector<int> found;
    std::string names;
    for (int w = 0; w < static_cast<int>(scene.walls.size()); ++w) {
        const scene::Wall& wall = scene.walls[static_cast<std::size_t>(w)];
        if (scene.dimension == 2 || !std::holds_alternative<scene::SpecimenShape>(wall.shape))
            continue;
        names += (names.empty() ? "" : ", ") + wall.name;
        if (name.empty() || wall.name == name)
            found.push_back(w);
    }
    if (found.size() == 1)
        return found[0];
    if (names.empty())
        return Problem{.file = scene.file.string(),
                       .what = "the scene has no specimen",
                       .fix = "add a [[wall]] with shape = \"bored-cylinder\", \"prism\" or \"hexahedra\""};
    return Problem{.file = scene.file.string(),
                   .what = found.empty() ? fmt::format("no specimen is called '{}'", name)
                                         : fmt::format("the scene has {} specimens", found.size()),
                   .fix = "name one of " + names};
}

Result<PartLoads> record_loads(const scene::Scene& scene, int wall, const LoadOptions& options, RunListener& listener) {
    const auto begun = std::chrono::steady_clock::now();
    for (const bool periodic : scene.domain.periodic)
        if (periodic)
            return Problem{
                .file = scene.file.string(),
                .key = "domain.periodic",
                .what = "loads on a specimen are not kept in a periodic domain, where its facets are there twice",
                .fix = "close the domain, or let `tumble run` run it"};
    if (const auto doubt = doubt_of_size(scene, scene.walls[static_cast<std::size_t>(wall)]))
        listener.warned(*doubt);
    auto measures = observe::choose_measures(scene.observe.measures);
    if (!measures)
        return measures.problems();
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    const std::int64_t first = std::max<std::int64_t>(1, std::llround(options.from / scene.time_step));
    if (const auto problem = refuse_without_instants(scene, options, first, last))
        return *problem;
    auto folder = LoadFolder::open(scene, options);
    if (!folder)
        return folder.problems();
    LoadRecorder recorder(scene, wall, options, std::move(*measures));
    auto simulation = folder->can_resume() ? folder->go_on(scene, recorder, listener) : folder->begin(scene, listener);
    if (!simulation)
        return simulation.problems();
    if (options.begun)
        if (const auto ready = options.begun(); !ready)
            return ready.problems();
    Schedule instants(options.every, scene.time_step);
    bool stopped = false;
    double told = 0;
    instants.pass(std::max(first - 1, (*simulation)->steps()));
    while ((*simulation)->steps() < last && !stopped) {
        // Until then nobody looks, and what comes is forgotten.
        const std::int64_t ahead =
            (*simulation)->steps() < first - 1 ? std::min<std::int64_t>(first - 1 - (*simulation)->steps(), 1000) : 1;
        if (const auto problem = (*simulation)->advance(ahead))
            return *problem;
        stopped = stop_wanted(options.stop);
        if ((*simulation)->steps() >= first)
            recorder.take(**simulation);
        if (instants.due((*simulation)->steps())) {
            if (const auto problem = recorder.keep(**simulation))
                return *problem;
            instants.pass((*simulation)->steps());
        }
        folder->keep(**simulation, recorder, seconds_since(begun), stopped || (*simulation)->steps() >= last, listener);
        if (const double now = seconds_since(begun); now > told + 0.2) {
            told = now;
            listener.progressed(
                progress_of(**simulation, scene, last, static_cast<double>((*simulation)->steps()) / now));
        }
    }
    PartLoads loads = recorder.finish();
    loads.stopped = stopped;
    loads.wall_s = seconds_since(begun);
    return loads;
}

} // namespace tumble::run
