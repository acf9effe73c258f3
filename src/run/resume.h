#pragma once

#include "run/checkpoint.h"
#include "run/mesh_copies.h"
#include "run/run_folder.h"
#include "run/simulation.h"

namespace tumble::run {

/// What `--resume` finds in a folder.
enum class Found {
    nothing,   // no folder, or an empty one
    beginning, // of a run that was killed before its first checkpoint, and so before its first step
    run
};
Found look_into(const std::filesystem::path& root);

/// A run that can go on.
struct Resumable {
    Checkpoint from;
    SimulationPtr simulation;
    std::string name;                  // of the checkpoint, seen from the folder
    std::vector<std::string> changes;  // of the scene since then
    std::vector<std::string> warnings; // of newer checkpoints that could not be used, of another build of the program
};

/// The newest checkpoint that is whole and fits the scene and the folder. Problems: there is none (with what is wrong
/// with each), or the scene was changed (scene_changes.h). Nothing in the folder is touched.
Result<Resumable> find_checkpoint(const scene::Scene& scene, const std::string& toml,
                                  const std::vector<MeshMark>& meshes, const RunFolder& folder,
                                  const RunOptions& options);

/// Takes away what the folder holds beyond a checkpoint: frames and what was made of them, half-written files, newer
/// checkpoints. series.csv is left to SeriesWriter::go_on. Returns the numbers of frames that should be there and are
/// not. Problems: the system's reason.
Result<std::vector<std::int64_t>> cut_back(const RunFolder& folder, const Checkpoint& to);

/// "frame 3", "frames 3, 4, 5", "18 frames from 0 to 17".
std::string frames_in_words(const std::vector<std::int64_t>& numbers);

} // namespace tumble::run
