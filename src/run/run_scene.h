#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "base/stop.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::run {

struct RunOptions {
    std::filesystem::path folder;           // empty: out/<name of the scene file>
    int threads = 1;                        // changes the time taken, never the result
    bool overwrite = false;                 // replace what a run left in the folder
    bool resume = false;                    // go on where a run in the folder ended, or begin where there is none
    bool accept_changes = false;            // even when the scene was changed since
    std::optional<double> checkpoint_every; // s of wall time; 0: no checkpoints; 60 without it, where the solver can
    bool pictures = false;                  // PNG frames
    bool video = false;                     // MP4, through ffmpeg
    std::filesystem::path video_file;       // empty: video.mp4 in the folder
    bool paraview = false;                  // VTP and PVD
    bool text_dump = false;                 // one LIGGGHTS-style file
    StopFlag stop = nullptr;                // end between two steps, or before the first
};

/// Where a run stands.
struct Progress {
    double time = 0;     // s
    double duration = 0; // s
    std::int64_t step = 0;
    std::int64_t steps = 0;       // in all
    double steps_per_s = 0;       // of wall time, lately
    double waiting_share = 0;     // of the wall time so far, spent waiting for frames to be drawn and written
    std::optional<double> left_s; // s of wall time, guessed; nothing while too little was seen
    Books books;
};

/// Told what happens, from the thread that called run_scene. The usual listener does nothing.
class RunListener {
public:
    virtual ~RunListener() = default;
    /// Before it starts: so many of so many, of what is counted ("bodies placed").
    virtual void prepares(std::string_view /*what*/, std::int64_t /*done*/, std::int64_t /*all*/) {}
    virtual void started(const std::filesystem::path& /*folder*/, const Progress&) {}
    virtual void progressed(const Progress&) {}
    virtual void warned(const std::string& /*sentence*/) {}
    /// Before a run that is resumed goes on: so many of the frames that it has are drawn and written anew.
    virtual void brought_back(std::int64_t /*frames*/, std::int64_t /*of*/) {}
    /// Where a run is resumed that has come to its end, and all that is asked for lies there: nothing was touched.
    virtual void nothing_left_to_do(const std::filesystem::path& /*folder*/) {}
};

/// From where a run was resumed.
struct Resumption {
    std::string checkpoint; // in the folder of the run
    std::int64_t step = 0;
    double time = 0;                  // s
    std::string build_mark;           // of the program that wrote it (run/build_mark.h)
    std::vector<std::string> changes; // of the scene since then, a sentence each
};

/// What run.json says; docs/run-folder.md explains each value.
struct RunSummary {
    std::string state;      // running, finished, stopped, failed
    Problems reason;        // why it failed
    bool own_fault = false; // it failed by what the scene does, and would again; not by files or memory
    std::filesystem::path folder;
    std::filesystem::path scene;
    std::string title;
    double duration = 0; // s
    scene::Solver solver = scene::Solver::soft;
    double time_step = 0; // s
    std::uint64_t seed = 0;
    int threads = 1;
    double time = 0; // s, reached
    std::int64_t steps = 0;
    std::int64_t bodies = 0;
    std::int64_t rows = 0;
    std::int64_t frames = 0;
    std::int64_t pictures = 0;
    bool video = false;
    std::filesystem::path video_file; // empty without a video
    double video_slowdown = 1;        // s of watching per s of the run
    double wall_s = 0;                // s, all
    double processor_s = 0;           // s, of the program's threads together while it went on
    double stepping_s = 0;            // s, inside the solver
    double frames_s = 0;              // s, drawing and writing frames, beside the steps
    double waited_s = 0;              // s, in which the steps stood still for that
    double body_steps = 0;            // bodies times steps, summed as bodies came in
    std::vector<PhaseTime> phases;
    Books books;                  // at the end
    double energy_turnover = 0;   // J, what closure is to be compared with
    double overlap_ratio_max = 0; // over all steps
    std::vector<std::string> unfilled;
    std::vector<std::string> warnings;
    std::filesystem::path checkpoint;  // the last one written, in the folder; empty: none
    std::int64_t checkpoints = 0;      // written
    std::int64_t checkpoint_bytes = 0; // of the last
    double checkpoints_s = 0;          // s, in which the steps stood still for all of them
    std::vector<Resumption> resumed{}; // in order
};

/// Runs a scene and leaves its folder as docs/run-folder.md says. A value comes back once a folder stands: finished,
/// stopped or failed. Problems: nothing was started and nothing left behind (scene that cannot be built, unknown
/// measure, folder that holds something or cannot be written or is another run's at this moment, too little space,
/// ffmpeg missing; no checkpoint that can be resumed, a scene that was changed since; checkpoints asked of Box2D; a
/// stop before there was a world).
Result<RunSummary> run_scene(const scene::Scene& scene, const RunOptions& options, RunListener& listener);

} // namespace tumble::run
