#include "run/simulation.h"

namespace tumble::run {

Result<SimulationPtr> simulate(const scene::Scene& scene, int threads, StopFlag stop, const Tally& tally) {
    if (scene.solver == scene::Solver::box2d)
        return simulate_hard(scene, stop, tally);
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, stop, nullptr, tally)
                                : simulate_in_3d(scene, threads, stop, nullptr, tally);
}

Result<SimulationPtr> restore(const scene::Scene& scene, int threads, const std::string& state, StopFlag stop) {
    if (scene.solver == scene::Solver::box2d)
        return Problem{.key = "solver",
                       .what = "a run of Box2D cannot go on: what it remembers of its contacts cannot be kept",
                       .fix = "run it again from the start"};
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, stop, &state)
                                : simulate_in_3d(scene, threads, stop, &state);
}

} // namespace tumble::run
