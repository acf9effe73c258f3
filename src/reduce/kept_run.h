#pragma once

#include "base/problem.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What stays of a run of a ladder beside its folder, so that it need not run again.
namespace tumble::reduce {

struct KeptRun {
    double core_s = 0;
    double overlap = 0;  // deepest of all steps, over the smaller radius
    std::string failure; // why it is of no use; empty: it is
    std::vector<std::string> doubts;
};

/// "softening-4-seed-7-0123456789abcdef": the hash is that of the resolved scene, of what is in its meshes, and of the
/// sources that decide bits. Problems: a mesh that cannot be read.
Result<std::string> name_of_run(const std::string& rung, const scene::Scene& scene);

/// Nothing where there is no such file, or one that is damaged: the run then counts as not done.
std::optional<KeptRun> read_kept(const std::filesystem::path& file);
Result<Done> write_kept(const std::filesystem::path& file, const KeptRun& run);

} // namespace tumble::reduce
