#include "run/simulation.h"

namespace tumble::run {

Result<SimulationPtr> simulate(const scene::Scene& scene, int threads) {
    if (scene.solver == scene::Solver::box2d)
        return simulate_hard(scene);
    return scene.dimension == 2 ? simulate_in_2d(scene, threads) : simulate_in_3d(scene, threads);
}

} // namespace tumble::run
