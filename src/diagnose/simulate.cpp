#include "diagnose/simulate.h"

namespace tumble::diagnose {

std::vector<Result<observe::Series>> Simulate::all(std::span<const scene::Scene> scenes) const {
    std::vector<Result<observe::Series>> series(scenes.size(), observe::Series{});
    const auto run = [&](int k) { series[static_cast<std::size_t>(k)] = one_(scenes[static_cast<std::size_t>(k)]); };
    const auto count = static_cast<int>(scenes.size());
    if (crew_)
        crew_->share(count, run);
    else
        for (int k = 0; k < count; ++k)
            run(k);
    return series;
}

} // namespace tumble::diagnose
