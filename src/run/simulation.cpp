#include "run/simulation.h"

namespace tumble::run {

Result<SimulationPtr> simulate(const scene::Scene& scene, int threads) {
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, nullptr) : simulate_in_3d(scene, threads, nullptr);
}

Result<SimulationPtr> restore(const scene::Scene& scene, int threads, const std::string& state) {
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, &state) : simulate_in_3d(scene, threads, &state);
}

} // namespace tumble::run
