#include "run/simulation.h"

namespace tumble::run {

Result<SimulationPtr> simulate(const scene::Scene& scene, int threads) {
    return scene.dimension == 2 ? simulate_in_2d(scene, threads) : simulate_in_3d(scene, threads);
}

} // namespace tumble::run
