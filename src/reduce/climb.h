#pragma once

#include "base/stop.h"
#include "reduce/ladder.h"
#include "reduce/yardstick.h"
#include "run/run_scene.h"

#include <cstdint>
#include <limits>

/// Runs the rungs of a ladder, cheapest first, so that what the next will cost is known before it is begun and a climb
/// that ends early has a top.
namespace tumble::reduce {

struct ClimbOptions {
    std::filesystem::path folder{};                          // runs go to runs/ in it
    int seeds = 4;                                           // the scene's own and those after it
    std::vector<std::filesystem::path> references{};         // runs of the scene as written that are over, in its place
    double budget = std::numeric_limits<double>::infinity(); // s of wall time for all that is still to run
    int threads = 1;
    StopFlag stop = nullptr;
};

/// One run that is over.
struct Seeded {
    std::uint64_t seed = 0;
    double core_s = 0;               // processor time of all threads
    double overlap = 0;              // deepest of all steps, over the smaller radius
    std::vector<double> values;      // parallel to the yardstick's quantities
    std::vector<std::string> doubts; // what the run warned of
};

enum class Standing {
    waiting,  // interrupted before it was done
    finished, // with all seeds
    refused,  // could not be built
    failed,   // broke down, or not all bodies found room
    left_out  // would have gone beyond the budget
};

struct Climbed {
    Rung rung;
    Standing standing = Standing::waiting;
    std::string reason; // of all but waiting and finished
    double work = 0;    // sphere-steps of one run, about
    double mass = 0;    // kg, of all bodies
    double bodies = 0;
    std::vector<Seeded> runs;

    /// Of one run, mean; NaN without any.
    [[nodiscard]] double core_s() const;
    /// The deepest of all runs, over the smaller radius.
    [[nodiscard]] double overlap() const;
};

struct Climb {
    Yardstick stick;
    std::vector<Climbed> rungs; // as in the ladder
    bool stopped = false;
    int made = 0; // runs that are over, beside references that were given
    int all = 0;  // they and those still to make
};

/// Told where a climb is, beside what its runs tell.
class ClimbListener : public run::RunListener {
public:
    /// `kept`: it was done before, and its folder is taken as it is.
    virtual void begins(const std::string& /*rung*/, std::uint64_t /*seed*/, int /*run*/, int /*of*/, bool /*kept*/) {}
};

/// Runs what is not done yet: a run in the folder counts as done when scene, seed and program are the same, and one
/// that was interrupted goes on from its checkpoint. Problems: a folder that cannot be written; a run's files that
/// cannot be read; a reference that is none (given_run.h), or given twice. A rung that cannot be run is no problem but
/// a standing.
Result<Climb> climb(std::vector<Rung> ladder, const Yardstick& stick, const ClimbOptions& options,
                    ClimbListener& listener);

} // namespace tumble::reduce
