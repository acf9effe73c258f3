#pragma once

#include "base/carried.h"
#include "base/problem.h"
#include "base/rng.h"
#include "base/tally.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

/// How far fills have come, whatever their bodies are.
namespace tumble::solver {

// A region counts as full after this many misses in a row.
constexpr int misses_until_full = 3000;

struct FillState {
    scene::Fill fill;
    Rng rng{0};
    std::int64_t asked = 0;
    std::int64_t placed = 0;
    std::int64_t next_step = 0;
    bool begun = false; // has been tried
    bool over = false;

    [[nodiscard]] bool due(std::int64_t step) const { return !over && next_step <= step; }
    [[nodiscard]] bool owes() const { return begun && placed < asked; }
    /// A fill meant to happen at once that has not placed all.
    [[nodiscard]] bool failed() const { return placed < asked && fill.until <= fill.start; }
    /// It has been tried at the time of that step of `dt` s, and `more` bodies came in.
    void note(std::int64_t more, std::int64_t step, double dt);
};

template <class Archive, As<FillState> F> void carry(Archive& archive, F& state) {
    auto& [fill, rng, asked, placed, next_step, begun, over] = state; // the first is the scene's
    archive(rng, asked, placed, next_step, begun, over);
}

/// Counts for a tally the bodies that the fills due at a step bring in, of all that they still owe.
class PlacedCount {
public:
    PlacedCount(const std::vector<FillState>& fills, std::int64_t step, const Tally& tally);
    void one_more() { tell_tally(*tally_, "bodies placed", ++placed_, all_); }

private:
    const Tally* tally_;
    std::int64_t placed_ = 0;
    std::int64_t all_ = 0;
};

/// kg, of templates.
template <class Shapes> std::vector<double> masses_of(const Shapes& shapes) {
    std::vector<double> masses;
    for (const auto& shape : shapes)
        masses.push_back(shape.mass);
    return masses;
}

/// The scene's fills before their first bodies; `masses` of its bodies' templates, kg, dt in s. Problems: a mass below
/// one body's.
Result<std::vector<FillState>> begin_fills(const scene::Scene& scene, const std::vector<double>& masses, double dt);

/// The first step at which a fill is due; never: the largest number.
std::int64_t next_due(const std::vector<FillState>& fills);

} // namespace tumble::solver
