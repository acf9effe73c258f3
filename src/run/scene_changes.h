#pragma once

#include "run/checkpoint.h"
#include "run/mesh_copies.h"

namespace tumble::run {

/// The meshes of a scene by what is in them.
std::vector<MeshMark> marks_of(const std::vector<MeshCopy>& meshes);

/// What was changed between the scene of a checkpoint and the one that shall go on from it, a sentence each, nothing
/// that concerns only how long a run is and what is drawn. Problems: changes that a run cannot take in its midst
/// (bodies, walls, domain, step, columns of series.csv), and, unless `accept` is set, any other.
Result<std::vector<std::string>> judge_changes(const Checkpoint& checkpoint, const std::string& scene,
                                               const std::vector<MeshMark>& meshes, bool accept,
                                               const std::filesystem::path& file);

/// What differs between two scenes that has bodies move otherwise, a sentence each: everything but how long a run is,
/// what it observes and draws, and the seed. Problems: one of them is no TOML.
Result<std::vector<std::string>> changes_of_motion(const std::string& before, const std::string& now);

} // namespace tumble::run
