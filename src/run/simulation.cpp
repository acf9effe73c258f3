#include "run/simulation.h"

namespace tumble::run {

Result<SimulationPtr> simulate(const scene::Scene& scene, int threads, StopFlag stop) {
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, stop, nullptr)
                                : simulate_in_3d(scene, threads, stop, nullptr);
}

Result<SimulationPtr> restore(const scene::Scene& scene, int threads, const std::string& state, StopFlag stop) {
    return scene.dimension == 2 ? simulate_in_2d(scene, threads, stop, &state)
                                : simulate_in_3d(scene, threads, stop, &state);
}

} // namespace tumble::run
