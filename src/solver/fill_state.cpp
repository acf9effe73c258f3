#include "solver/fill_state.h"

#include "scene/written.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::solver {

void FillState::note(std::int64_t more, std::int64_t step, double dt) {
    begun = true;
    placed += more;
    const double again = static_cast<double>(step) * dt + fill.every;
    next_step = static_cast<std::int64_t>(std::ceil(again / dt));
    over = placed >= asked || again > fill.until;
}

PlacedCount::PlacedCount(const std::vector<FillState>& fills, std::int64_t step, const Tally& tally) : tally_(&tally) {
    for (const FillState& fill : fills)
        if (fill.due(step))
            all_ += fill.asked - fill.placed;
}

Result<std::vector<FillState>> begin_fills(const scene::Scene& scene, const std::vector<double>& masses, double dt) {
    std::vector<FillState> fills;
    Problems problems;
    for (const scene::Fill& fill : scene.fills) {
        FillState state{fill, Rng(scene.seed * 0x9e3779b97f4a7c15ULL + fills.size()), 0, 0, 0, false, false};
        const double mass = masses[static_cast<std::size_t>(fill.body)];
        state.asked = fill.count ? *fill.count : std::llround(fill.mass.value_or(0) / mass);
        state.next_step = static_cast<std::int64_t>(std::ceil(fill.start / dt - 1e-9));
        if (state.asked < 1)
            problems.push_back(
                scene::problem_about(scene, fmt::format("fill.{}.mass_kg", fills.size()),
                                     fmt::format("a fill asks for less than one body of {:.4g} kg", mass),
                                     "ask for more mass, or give a count"));
        fills.push_back(std::move(state));
    }
    if (!problems.empty())
        return problems;
    return fills;
}

std::int64_t next_due(const std::vector<FillState>& fills) {
    std::int64_t next = std::numeric_limits<std::int64_t>::max();
    for (const FillState& fill : fills)
        if (!fill.over)
            next = std::min(next, fill.next_step);
    return next;
}

} // namespace tumble::solver
