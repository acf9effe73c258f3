#pragma once

#include "diagnose/conditions_differ.h"
#include "diagnose/curves.h"
#include "diagnose/decide.h"
#include "diagnose/gain.h"
#include "diagnose/plan.h"
#include "diagnose/profile.h"

#include <functional>
#include <string>

namespace tumble::diagnose {

/// One number of a bed beside what the simulation says of it, SI. Errors are standard errors of means.
struct BedNumber {
    std::string condition, measure, unit;
    bool held_out = false;
    int runs = 0, seeds = 0; // measured, simulated
    double measured = 0, measured_error = 0;
    double baseline = 0, baseline_error = 0;
    double scatter = 0; // of single runs of the simulation
    double extended = 0, extended_error = 0;
    bool has_extended = false; // the named causes were run
};

/// Runs with the named causes at their fitted amplitudes, of seeds that the response table does not know.
struct Confirmation {
    std::vector<double> amplitudes; // as run: the fitted ones in three digits
    double p = 1;                   // of so large a difference from what the table foretold
};

struct FittedNuisance {
    std::string name;
    double start = 0, value = 0, error = 0;
    std::optional<double> extended{}; // with what was named
    bool in_scene = false;            // a key of the scene, the same under every condition
};

/// All that a report tells.
struct Diagnosis {
    std::string title;
    std::filesystem::path scene, data;
    std::string hash;              // of the measurement and its data
    std::string scene_hash;        // of the scene's text
    std::vector<std::string> sets; // what was set beside it
    Settings settings;
    NoiseReport noise;
    std::vector<FittedNuisance> nuisances;
    double chi_square = 0; // of the baseline, with `readings` readings
    int readings = 0;
    std::vector<Cause> causes;
    Evidence evidence; // what the decision was made from
    Decision decision;
    std::vector<Limits> limits;        // 95 %, of each amplitude of decision.best; empty: none was looked for
    std::vector<Cut> cuts;             // of a clipping that is named
    Following follows;                 // what the residual that is left looks like
    std::optional<Besides> differing;  // from condition to condition, where no cause explains it
    std::optional<Besides> overstated; // a nuisance said to be better known than it is, where not even that does
    std::vector<std::string> alike;    // causes that look like that nuisance
    std::optional<Gain> gain;
    std::vector<Proposal> proposals; // best first
    std::vector<Curve> curves;
    std::vector<BedNumber> beds; // of a bed, in place of curves
    std::optional<Confirmation> confirmation;

    Problems warnings;
    double simulated = 0; // s
    int runs = 0;
    int old_runs = 0;                     // of a bed: that counted though another version of the program made them
    std::optional<scene::Scene> extended; // the scene with the named causes in it; none where all are the instrument's
};

/// Of what, and with which settings.
Diagnosis begun_with(const SceneText& scene, const Measurement& measurement);

/// Told what a diagnosis does next: "fits the baseline".
using TellStage = std::function<void(const std::string&)>;

/// Holds a measurement against its scene. Problems: whatever keeps the baseline from being simulated; readings whose
/// unit cannot be what it says. `plan`: propose experiments also where the answer is not ambiguous.
Result<Diagnosis> diagnose(const SceneText& scene, const Measurement& measurement, const Simulate& simulate,
                           bool plan = false, const TellStage& tell = {});

} // namespace tumble::diagnose
