#pragma once

#include "diagnose/ensemble.h"
#include "diagnose/model.h"
#include "diagnose/response_table.h"
#include "scene/settled.h"

#include <set>

namespace tumble::diagnose {

struct BedOptions {
    std::filesystem::path table; // what was run is kept there; empty: nowhere
    int seeds = 4;               // runs of each bed, from the scene's seed on
    std::string version{};       // of the program that runs
    bool any_date = false;       // runs count whatever program made them, of the same scene
    bool plan = false;           // propose experiments also where the answer is not ambiguous, and run them for that
};

/// Causes at amplitudes; none: the baseline.
struct Push {
    const Cause* cause = nullptr;
    double amplitude = 0;
};
using Pushes = std::vector<Push>;

/// Runs that are still to be made.
struct Budget {
    int runs = 0;
    int kept = 0;         // those that the table has
    double simulated = 0; // s
    double wall = 0;      // s, by those that the table has; 0: it has none
};

/// The beds of a measurement: runs them with causes in them, and remembers what came out.
class Beds {
public:
    /// Problems: a scene that cannot be read or set, a stretch of time without rows, a table that is none.
    static Result<Beds> make(SceneText scene, std::vector<Bulk> conditions, Simulate simulate, BedOptions options);

    /// One more condition, of which no number outside measures() is asked; its number. Problems: as those of make().
    Result<int> add(Bulk condition);

    /// Runs of a condition with these causes in it, those that are not kept. A row each; NaN where the run broke down
    /// or a number has no meaning. Problems: the scene cannot be built; the table cannot be written.
    Result<Ensemble> ensemble(int condition, const Pushes& pushes, std::uint64_t later_seeds = 0);

    /// Adds what ensemble() would have to run.
    void charge(Budget& budget, int condition, const Pushes& pushes) const;

    /// The extension does not change this scene.
    [[nodiscard]] bool idle(int condition, const Pushes& pushes) const;

    /// What every run gives, by name: the numbers measured under any condition, and others that may be worth measuring.
    [[nodiscard]] const std::vector<std::string>& measures() const { return measures_; }
    [[nodiscard]] int column_of(const std::string& measure) const;
    [[nodiscard]] scene::Stretch stretch(int condition) const;
    [[nodiscard]] int seeds() const { return options_.seeds; }
    [[nodiscard]] int runs() const { return runs_; }
    [[nodiscard]] double simulated() const { return simulated_; } // s
    /// Runs that counted though another program made them, and those that were run anew because of their scene.
    [[nodiscard]] int old_runs() const { return static_cast<int>(old_.size()); }
    [[nodiscard]] int left_aside() const { return left_aside_; }
    /// Why the last run broke down that did.
    [[nodiscard]] const Problems& failure() const { return failure_; }

private:
    Beds() = default;
    [[nodiscard]] scene::Scene scene_of(int condition, const Pushes& pushes, std::uint64_t seed) const;
    [[nodiscard]] BedRun plan(int condition, const Pushes& pushes, std::uint64_t seed) const;
    [[nodiscard]] const BedRun* kept(const BedRun& run) const;
    void note_means(BedRun& run, const Result<observe::Series>& series, const scene::Scene& scene);
    /// Runs those of a condition, side by side, and writes them into the table.
    Result<Done> perform(std::vector<BedRun*>& missing, int condition, const Pushes& pushes);

    SceneText text_;
    std::vector<Bulk> conditions_;
    std::vector<scene::Scene> scenes_; // resolved, of each condition
    std::vector<scene::Stretch> stretches_;
    std::vector<std::string> measures_, columns_;
    Simulate simulate_;
    BedOptions options_;
    ResponseTable table_;
    Problems failure_;
    std::set<std::string> old_; // dates of those
    int left_aside_ = 0;
    int runs_ = 0;
    double simulated_ = 0; // s
};

} // namespace tumble::diagnose
