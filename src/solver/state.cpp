#include "solver/state.h"

#include <algorithm>

namespace tumble::solver {

Problem unusable_state(const scene::Scene& scene, const std::string& what) {
    return {.file = scene.file.string(), .what = what, .fix = "go on from another state, or run the scene again"};
}

std::string flaw_of_bodies(const std::vector<std::int64_t>& id, const std::vector<int>& shape, std::size_t shapes) {
    std::vector<bool> seen(id.size(), false);
    for (const std::int64_t one : id) {
        if (one < 0 || static_cast<std::size_t>(one) >= seen.size() || seen[static_cast<std::size_t>(one)])
            return "two bodies have one number";
        seen[static_cast<std::size_t>(one)] = true;
    }
    if (!std::all_of(shape.begin(), shape.end(), [&](int one) { return below(one, shapes); }))
        return "a body has a shape that the scene lacks";
    return "";
}

} // namespace tumble::solver
