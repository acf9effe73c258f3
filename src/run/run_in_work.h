#pragma once

#include "observe/measures.h"
#include "observe/series.h"
#include "observe/tracer.h"
#include "run/frame_queue.h"
#include "run/mesh_copies.h"
#include "run/pace.h"
#include "run/run_folder.h"
#include "run/run_scene.h"
#include "run/schedule.h"
#include "run/simulation.h"

#include <memory>
#include <optional>

namespace tumble::run {

/// A run between its first and its last step: where a simulation and its observers meet.
class RunInWork {
public:
    /// Builds the world, opens the folder and writes all that can be known before the first step. Problems as those of
    /// run_scene; nothing is left behind then.
    static Result<std::unique_ptr<RunInWork>> prepare(const scene::Scene& scene, const RunOptions& options,
                                                      RunListener& listener);

    /// Steps, and hands on rows and frames when they are due, until the duration is reached, the stop flag is set or
    /// something fails.
    void step_to_the_end();

    /// Writes run.json with what became of it.
    RunSummary finish();

private:
    RunInWork(const scene::Scene& scene, const RunOptions& options, RunListener& listener, SimulationPtr simulation,
              FolderInWork folder);

    Result<Done> choose_what_to_see();
    Result<FrameSinks> open_sinks();
    Result<Done> write_beginnings(const std::vector<MeshCopy>& meshes);
    [[nodiscard]] std::filesystem::path video_file() const;
    void observe_now();
    void keep_last_state();
    void refresh_summary();
    Result<Done> add_row(const observe::Frame& frame, const Books& books);
    void fail(const Problems& problems);
    void warn(std::string sentence);
    void take_stock();
    void judge();
    [[nodiscard]] Progress progress() const;
    [[nodiscard]] bool stop_wanted() const;

    const scene::Scene& scene_;
    const RunOptions& options_;
    RunListener& listener_;
    SimulationPtr simulation_;
    FolderInWork folder_;
    std::shared_ptr<const observe::FrameLayout> layout_;
    std::vector<observe::Measure> measures_;
    std::vector<observe::TracerReader> tracers_;
    std::optional<observe::Measure> plotted_;
    std::optional<observe::SeriesWriter> series_;
    render::PlotLine plot_;
    std::unique_ptr<FrameQueue> queue_;
    Schedule rows_;
    Schedule frames_;
    Pace pace_;
    std::int64_t all_steps_ = 0;
    std::int64_t shots_ = 0;
    std::int64_t last_shot_ = -1; // step
    double refreshed_ = 0;        // s of wall time since the run was made
    RunSummary summary_;
};

} // namespace tumble::run
