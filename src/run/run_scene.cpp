#include "run/run_scene.h"

#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/run_in_work.h"
#include "run/run_report.h"
#include "scene/to_toml.h"

namespace tumble::run {

Result<RunSummary> run_scene(const scene::Scene& scene, const RunOptions& options, RunListener& listener) {
    Result<std::unique_ptr<RunInWork>> run = RunInWork::prepare(scene, options, listener);
    if (!run)
        return run.problems();
    if ((*run)->done_before())
        return (*run)->as_it_was_left();
    (*run)->step_to_the_end();
    return (*run)->finish();
}

} // namespace tumble::run
