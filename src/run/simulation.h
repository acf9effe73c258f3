#pragma once

#include "base/books.h"
#include "base/phases.h"
#include "base/problem.h"
#include "base/stop.h"
#include "base/tally.h"
#include "observe/frame.h"
#include "observe/part_loads.h"
#include "scene/scene.h"
#include "scene/time_step.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tumble::run {

/// A body template as its solver uses it.
struct SimulatedBody {
    std::string name;
    std::size_t parts = 0;                                    // spheres or discs
    double volume = 0;                                        // m3, of their union
    double mass = 0;                                          // kg
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero();        // kg m2, principal; in two dimensions the third counts
    double bounding_radius = 0;                               // m
    Eigen::Vector3d written_centre = Eigen::Vector3d::Zero(); // m, centre of mass in the template's frame
    Eigen::Quaterniond written_from_principal = Eigen::Quaterniond::Identity();
};

/// A solver at work on a scene, as runs and checks see it: whichever it is, it steps, keeps its books, and shows
/// frames.
class Simulation {
public:
    virtual ~Simulation() = default;

    /// Takes `steps` steps. A state that stopped being sane ends it early with a problem; a stop that is wanted may end
    /// it early without one.
    virtual std::optional<Problem> advance(std::int64_t steps) = 0;

    [[nodiscard]] virtual double time() const = 0; // s
    [[nodiscard]] virtual std::int64_t steps() const = 0;
    [[nodiscard]] virtual Books books() const = 0;
    /// What its frames have in common.
    [[nodiscard]] virtual std::shared_ptr<const observe::FrameLayout> layout() const = 0;
    /// The world now.
    [[nodiscard]] virtual observe::Frame frame() const = 0;
    /// Who touches whom, for Frame::contacts; one step before frame(). Costs about as much as a step.
    [[nodiscard]] virtual std::vector<observe::FrameContact> contacts() const = 0;
    /// What touched that wall in the last step taken; nothing where the solver cannot tell (two dimensions).
    [[nodiscard]] virtual std::vector<observe::WallPush> wall_pushes(int /*wall*/) const { return {}; }
    /// Parallel to the scene's bodies.
    [[nodiscard]] virtual std::vector<SimulatedBody> bodies() const = 0;
    [[nodiscard]] virtual scene::TimeStepReport time_step() const = 0;
    /// What fills still owe, a sentence each.
    [[nodiscard]] virtual std::vector<std::string> unfilled() const = 0;
    [[nodiscard]] virtual std::vector<PhaseTime> phase_times() const = 0;
    /// All that the steps to come depend on beside the scene; restore() goes on from it by the same
    /// bits. Empty where the solver cannot (Box2D).
    [[nodiscard]] virtual std::string state() const = 0;
};

using SimulationPtr = std::unique_ptr<Simulation>;

/// The solver that the scene asks for, ready to step at t = 0. `threads` >= 1 changes the time taken, never the result;
/// `tally` hears of each body that found its place. Problems: those of the solver's build_world, and that a stop was
/// wanted meanwhile.
Result<SimulationPtr> simulate(const scene::Scene& scene, int threads, StopFlag stop = nullptr,
                               const Tally& tally = {});

/// The same in a state that state() gave. Problems: those of the solver's restore_world; a scene of Box2D.
Result<SimulationPtr> restore(const scene::Scene& scene, int threads, const std::string& state,
                              StopFlag stop = nullptr);

/// The solvers to choose from, one file each. Without a state they begin at t = 0, and tell a tally.
Result<SimulationPtr> simulate_in_2d(const scene::Scene& scene, int threads, StopFlag stop, const std::string* state,
                                     const Tally& tally = {});
Result<SimulationPtr> simulate_hard(const scene::Scene& scene, StopFlag stop, const Tally& tally); // hard contacts
Result<SimulationPtr> simulate_in_3d(const scene::Scene& scene, int threads, StopFlag stop, const std::string* state,
                                     const Tally& tally = {});

} // namespace tumble::run
