#pragma once

#include "observe/measures.h"
#include "observe/series.h"
#include "observe/tracer.h"
#include "run/checkpoint.h"
#include "run/frame_queue.h"
#include "run/measure_names.h"
#include "run/mesh_copies.h"
#include "run/pace.h"
#include "run/resume.h"
#include "run/run_folder.h"
#include "run/run_scene.h"
#include "run/schedule.h"
#include "run/simulation.h"

#include <exception>
#include <memory>
#include <optional>

namespace tumble::run {

/// options.folder, or out/<name of the scene file>.
std::filesystem::path folder_for(const scene::Scene& scene, const RunOptions& options);

/// The scene as TOML with every default filled in and meshes by their names in the folder.
std::string resolved(scene::Scene scene, const std::vector<MeshCopy>& meshes);

/// Problems with the places at which their keys were written.
Problems in_scene(Problems problems, const scene::Scene& scene);

/// A run between its first and its last step: where a simulation and its observers meet.
class RunInWork {
public:
    /// Builds the world, opens the folder and writes all that can be known before the first step; or takes all this up
    /// again where a run in the folder ended. Problems as those of run_scene; nothing is left behind then.
    static Result<std::unique_ptr<RunInWork>> prepare(const scene::Scene& scene, const RunOptions& options,
                                                      RunListener& listener);

    /// Whether it was resumed when nothing was left to do: it had come to this end with this scene, and all that is
    /// asked for lies in its folder. Then nothing is opened, and this is the end of it:
    [[nodiscard]] bool done_before() const { return done_before_; }
    RunSummary as_it_was_left();

    /// Steps, and hands on rows and frames when they are due, until the duration is reached, the stop flag is set or
    /// something fails.
    void step_to_the_end();

    /// What came out of step_to_the_end as an exception makes the run a failed one. The world may be half a step on: no
    /// frame or checkpoint is made of it.
    void break_off(const std::exception& error);

    /// Writes run.json with what became of it.
    RunSummary finish();

private:
    RunInWork(const scene::Scene& scene, const RunOptions& options, RunListener& listener, SimulationPtr simulation,
              FolderInWork folder, std::string toml);

    static Result<std::unique_ptr<RunInWork>> begin(const scene::Scene& scene, const RunOptions& options,
                                                    RunListener& listener, const std::vector<MeshCopy>& meshes);
    static Result<std::unique_ptr<RunInWork>> go_on(const scene::Scene& scene, const RunOptions& options,
                                                    RunListener& listener, const std::vector<MeshCopy>& meshes);

    void take_up(Resumable& found);
    [[nodiscard]] bool nothing_left_to_do() const;
    Result<Done> recall_tracers();
    Result<Done> choose_what_to_see();
    [[nodiscard]] std::vector<std::string> heads_of_rows() const;
    void begin_summary();
    Result<Done> open_all(const std::vector<MeshCopy>& meshes);
    Result<FrameSinks> open_sinks();
    Result<Done> write_beginnings(const std::vector<MeshCopy>& meshes);
    [[nodiscard]] std::filesystem::path video_file() const;
    void bring_back_frames();
    [[nodiscard]] observe::Frame frame_to_keep() const;
    void observe_now();
    void keep_checkpoint();
    [[nodiscard]] Checkpoint checkpoint_now() const;
    Result<Done> wait_for_beginnings();
    Result<Done> wait_for_outputs();
    void keep_last_state();
    void refresh_summary();
    Result<Done> add_row(const observe::Frame& frame, const Books& books);
    void fail(const Problems& problems);
    void warn(std::string sentence);
    void take_stock();
    [[nodiscard]] Progress progress() const;

    const scene::Scene& scene_;
    RunOptions options_;
    RunListener& listener_;
    SimulationPtr simulation_;
    FolderInWork folder_;
    std::string toml_; // of the scene, resolved
    std::vector<MeshMark> meshes_;
    std::shared_ptr<const observe::FrameLayout> layout_;
    std::vector<observe::Measure> measures_;
    std::vector<observe::TracerReader> tracers_;
    std::optional<Plotted> plotted_;
    std::optional<std::size_t> plotted_at_; // in the rows; nothing where they do not hold it
    std::optional<observe::SeriesWriter> series_;
    render::PlotLine plot_;
    std::unique_ptr<FrameQueue> queue_;
    Schedule rows_;
    Schedule frames_;
    Pace pace_;
    std::int64_t all_steps_ = 0;
    double keep_every_ = 0; // s of wall time between checkpoints; 0: none
    std::int64_t shots_ = 0;
    std::int64_t last_shot_ = -1; // step
    double refreshed_ = 0;        // s of wall time since the run was made
    std::int64_t kept_step_ = -1; // of the last checkpoint
    double kept_at_ = 0;          // s of wall time since the run was made
    bool begun_to_last_ = false;  // what write_beginnings wrote: the disk is known to have it
    std::int64_t lasting_ = 0;    // frames that it is known to have
    bool checkpoint_failed_ = false;
    bool done_before_ = false;
    std::optional<Checkpoint> resumed_; // from where; what was added up before goes on from its summary
    RunSummary summary_;
};

} // namespace tumble::run
