#pragma once

#include "run/run_scene.h"

#include <string>
#include <vector>

namespace tumble::run {

/// What a run writes beside series.csv and frames/.
struct Outputs {
    bool pictures = false;
    bool video = false;
    bool paraview = false;
    bool text_dump = false;
    std::filesystem::path video_file; // as in RunOptions
};

/// A mesh of the scene by what is in its file.
struct MeshMark {
    std::string name; // in the folder of the run
    std::string hash;
};

/// All of a run between two steps: from it, its scene, and what lies in the folder up to then, the run goes on as if it
/// had never ended.
struct Checkpoint {
    std::string build_mark; // of the program that wrote it
    std::string scene;      // TOML, resolved
    std::vector<MeshMark> meshes;
    RunSummary summary; // so far; its state and reasons are not kept
    Outputs outputs;
    std::int64_t step = 0;
    double time = 0;               // s
    std::int64_t shots = 0;        // frames so far, those that only an end asks for not counted
    std::int64_t last_shot = -1;   // step of the last of them; -1: none
    std::uint64_t series_size = 0; // bytes of series.csv so far
    std::string plot_measure;      // of the two that follow
    std::vector<double> plot_times;
    std::vector<double> plot_values;
    std::string tracers; // what observers with a memory hold, an archive
    std::string world;   // Simulation::state
};

/// The bytes of the file: an array file (observe/array_file.h) of kind "checkpoint".
std::string to_bytes(const Checkpoint& checkpoint);

/// Problems: those of from_bytes in observe/array_file.h; written by a version of the program that kept other things;
/// damaged. `file` only names the file in problems.
Result<Checkpoint> checkpoint_from(const std::string& bytes, const std::filesystem::path& file);

} // namespace tumble::run
