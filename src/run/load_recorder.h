#pragma once

#include "observe/mean_pushes.h"
#include "observe/measures.h"
#include "observe/part_loads.h"
#include "run/part_loads.h"
#include "run/simulation.h"
#include "solid/locate.h"

#include <optional>
#include <string>
#include <vector>

namespace tumble::run {

/// Steps of a run and what they show of a specimen's loads, gathered.
class LoadRecorder {
public:
    /// `measures`: the columns of PartLoads::bulk. Scene, wall and options outlive it.
    LoadRecorder(const scene::Scene& scene, int wall, const LoadOptions& options,
                 std::vector<observe::Measure> measures);

    /// After one step.
    void take(const Simulation& simulation);
    /// At an instant, after its step was taken. Problems: those of record_loads.
    std::optional<Problem> keep(const Simulation& simulation);
    PartLoads finish();

    /// All that was gathered so far, an archive.
    [[nodiscard]] std::string state() const;
    /// Goes on from it. Problem: it is of other options or another mesh, or damaged.
    Result<Done> recall(const std::string& state);

private:
    [[nodiscard]] std::optional<Problem> keep_frame(const observe::Frame& frame) const;
    [[nodiscard]] std::optional<Problem> body_inside(const observe::Frame& frame) const;

    const scene::Scene& scene_;
    int wall_;
    const solid::HexMesh& mesh_;
    solid::Locator locator_;
    const LoadOptions& options_;
    std::vector<observe::Measure> measures_;
    observe::TouchHistory history_;
    std::vector<observe::WallPush> pushes_; // of the last step
    observe::MeanPushes means_;             // since the last instant
    PartLoads loads_;
};

} // namespace tumble::run
