#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "scene/scene.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::run {

struct RunOptions {
    std::filesystem::path folder;            // empty: out/<name of the scene file>
    int threads = 1;                         // changes the time taken, never the result
    bool overwrite = false;                  // replace what a run left in the folder
    bool pictures = false;                   // PNG frames
    bool video = false;                      // MP4, through ffmpeg
    std::filesystem::path video_file;        // empty: video.mp4 in the folder
    bool paraview = false;                   // VTP and PVD
    bool text_dump = false;                  // one LIGGGHTS-style file
    const std::atomic<bool>* stop = nullptr; // set from elsewhere: end between two steps
};

/// Where a run stands.
struct Progress {
    double time = 0;     // s
    double duration = 0; // s
    std::int64_t step = 0;
    std::int64_t steps = 0;   // in all
    double steps_per_s = 0;   // of wall time, lately
    double waiting_share = 0; // of the wall time so far, spent waiting for frames to be drawn and written
    double left_s = 0;        // s of wall time, guessed
    Books books;
};

/// Told what happens, from the thread that called run_scene. The usual listener does nothing.
class RunListener {
public:
    virtual ~RunListener() = default;
    virtual void started(const std::filesystem::path& /*folder*/, const Progress&) {}
    virtual void progressed(const Progress&) {}
    virtual void warned(const std::string& /*sentence*/) {}
};

/// What run.json says; docs/run-folder.md explains each value.
struct RunSummary {
    std::string state; // running, finished, stopped, failed
    Problems reason;   // why it failed
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
};

/// Runs a scene and leaves its folder as docs/run-folder.md says. A value comes back once a folder stands: finished,
/// stopped or failed. Problems: nothing was started and nothing left behind (scene that cannot be built, unknown
/// measure, folder that holds something or cannot be written, too little space, ffmpeg missing).
Result<RunSummary> run_scene(const scene::Scene& scene, const RunOptions& options, RunListener& listener);

} // namespace tumble::run
