#pragma once

#include "base/problem.h"
#include "base/stop.h"
#include "observe/part_loads.h"
#include "observe/series.h"
#include "run/run_scene.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The loads of the media on a specimen, from a run of its scene.
namespace tumble::run {

struct LoadOptions {
    double every = 1.0 / 60; // s, between instants; the thesis' dumps
    double from = 0;         // s, nothing before counts
    int threads = 1;
    /// Folder of a run: frames/ gets a frame an instant, under the instant's number, and state/ checkpoints; empty:
    /// neither is kept.
    std::filesystem::path folder{};
    double checkpoint_every = 60; // s of wall time; 0: no checkpoints
    bool resume = false;          // go on from the folder's last checkpoint where there is one
    StopFlag stop = nullptr;
    /// Called once the run has begun or goes on, before its first step; problems end it.
    std::function<Result<Done>()> begun{};
};

/// All that touches the part at an instant.
struct LoadInstant {
    double time = 0; // s
    std::vector<observe::WallPush> pushes;
};

/// Mean over the window that ends at `time`.
struct MeanLoad {
    double time = 0;                       // s
    double window = 0;                     // s
    std::vector<observe::WallPush> pushes; // of observe::MeanPushes
};

struct PartLoads {
    std::vector<LoadInstant> instants;
    std::vector<MeanLoad> means;
    std::vector<observe::Touching> touches;
    observe::Series bulk; // the scene's measures at the instants
    bool stopped = false;
    double wall_s = 0; // s, it took
};

/// The index of the scene's wall that is a specimen; `name` chooses among several, empty: there is one. Problems: none
/// or several, no such wall, a wall of another shape.
Result<int> find_specimen(const scene::Scene& scene, const std::string& name);

/// Runs the scene and looks at the specimen after every step. Looking changes no bit of the run, nor does going on from
/// a checkpoint. Problems: those of the run; a periodic domain; a body that lies inside the part; contacts that nodal
/// forces cannot bear (solid::nodal_loads); no instant between options.from and the run's end; a folder that cannot be
/// written; with `resume` those of find_checkpoint and other options than the run was begun with.
Result<PartLoads> record_loads(const scene::Scene& scene, int wall, const LoadOptions& options, RunListener& listener);

/// Loads as files of a folder: contacts.csv (all instants), means.csv, touches.csv, bulk.csv; docs/stress.md has the
/// columns. Problems: the system's.
Result<Done> write_loads(const PartLoads& loads, const scene::SpecimenShape& specimen,
                         const std::filesystem::path& folder);

/// Takes away what write_loads left, as it gives way to what a new run will leave.
void remove_loads(const std::filesystem::path& folder);

/// Instants and means of such a folder, to the same bits, and its touches, but for Touching::since; times of their
/// peaks are NaN where the folder is of before they were kept. Problems: files that are missing or damaged, with the
/// line; facets and elements that the part does not have.
Result<PartLoads> read_loads(const std::filesystem::path& folder, const scene::SpecimenShape& specimen);

} // namespace tumble::run
