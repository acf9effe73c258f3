#pragma once

#include "run/checkpoint.h"

/// The checkpoints in a run's folder.
namespace tumble::run {

/// "step_000000001200.ckpt" in the folder.
std::filesystem::path checkpoint_path(const std::filesystem::path& folder, std::int64_t step);

/// Newest first. Files with other names are left out.
std::vector<std::filesystem::path> list_checkpoints(const std::filesystem::path& folder);

/// Writes one, waits until the disk has it, and then removes all but the newest two; makes the folder. Returns its
/// size, bytes. Problems: the system's reason; the ones before are still there then.
Result<std::int64_t> keep_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

} // namespace tumble::run
