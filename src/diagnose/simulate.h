#pragma once

#include "base/parallel_for.h"
#include "observe/series.h"
#include "scene/scene.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace tumble::diagnose {

/// Runs scenes and gives what their [observe] names, row by row. The one way in which a diagnosis reaches a simulator.
class Simulate {
public:
    using One = std::function<Result<observe::Series>(const scene::Scene&)>;

    Simulate() = default;
    /// `threads`: how many scenes may run at once; `one` is then called on any of them, several times at once.
    template <class F>
    requires std::is_convertible_v<F, One> Simulate(F one, int threads = 1)
        : one_(std::move(one)), crew_(threads > 1 ? std::make_shared<Crew>(threads) : nullptr) {}

    Result<observe::Series> operator()(const scene::Scene& scene) const { return one_(scene); }

    /// Of every scene, in their order, side by side.
    [[nodiscard]] std::vector<Result<observe::Series>> all(std::span<const scene::Scene> scenes) const;

    [[nodiscard]] int threads() const { return crew_ ? crew_->threads() : 1; }

private:
    One one_;
    std::shared_ptr<Crew> crew_;
};

} // namespace tumble::diagnose
