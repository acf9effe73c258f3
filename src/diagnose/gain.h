#pragma once

#include "diagnose/decide.h"

namespace tumble::diagnose {

/// What the named cause is worth on conditions that it was not fitted to.
struct Gain {
    std::vector<Score> scores;
    bool held_out = false;   // scores of records set aside; else each condition from all others, linear about the fits
    double rms_baseline = 0; // in the noise's unit: standard errors of a reading
    double rms_extended = 0;
    double skill = 0;                   // 1 - chi-square extended / baseline
    double share_removed = 0;           // of the misfit that any model could remove
    double nats = 0;                    // of log score
    double nats_low = 0, nats_high = 0; // 95 % of bootstraps over conditions; five conditions or more
    bool bootstrapped = false;
    bool shown =
        false; // the lower end is above 0; with fewer conditions: all by 3 nats, and none that it touches gets worse
};

Gain gain_of(std::vector<Score> scores, bool held_out);

/// Scores of records that were set aside, those of one condition together: shared nuisances and the cause from the fit,
/// what only the record can tell left open. Both vectors belong to `model`; parameters of `aside` find theirs by name.
Result<std::vector<Score>> scores_aside(Model& aside, const Model& model, const Noise& noise, const VectorXd& baseline,
                                        const VectorXd& extended);

} // namespace tumble::diagnose
