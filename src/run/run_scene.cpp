#include "run/run_scene.h"

#include "run/run_in_work.h"

namespace tumble::run {

Result<RunSummary> run_scene(const scene::Scene& scene, const RunOptions& options, RunListener& listener) {
    Result<std::unique_ptr<RunInWork>> run = RunInWork::prepare(scene, options, listener);
    if (!run)
        return run.problems();
    if ((*run)->done_before())
        return (*run)->as_it_was_left();
    try {
        (*run)->step_to_the_end();
    } catch (const std::exception& error) { // from whichever thread
        (*run)->break_off(error);
    }
    return (*run)->finish();
}

} // namespace tumble::run
