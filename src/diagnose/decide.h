#pragma once

#include "diagnose/directions.h"
#include "diagnose/statistics.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace tumble::diagnose {

/// Standard errors that the largest plausible amplitude of a cause must reach for it to be considered.
constexpr double least_visible = 3;

/// What a decision is made from, whitened, one row a reading (and a prior): whoever made it, a simulation or a formula.
struct Evidence {
    VectorXd residual;  // of the baseline at its best nuisances
    MatrixXd nuisances; // slopes of the prediction there
    MatrixXd effects;   // slopes per unit of each cause, from its null value
    Directions directions;
    std::vector<Cause> causes;   // parallel to the columns of effects
    std::vector<int> nuisance{}; // which one a column of nuisances is of, copies side by side; empty: each of its own
    double gate = 0;             // known from a case with the same effects; 0: to be drawn
    double degrees = covariance_known; // of freedom of the covariance that whitened it
    bool coarse = false;               // what the baseline misses was taken for scatter
    /// Of the rows behind the readings: of which nuisance each says what was known.
    std::vector<std::string> beforehand{};
};

/// The baseline misses the data by so much that it was pulled far away to explain what it lacks, and slopes about it
/// say little: chi-square is twice what noise leaves.
inline bool astray(double chi_square, Eigen::Index rows) {
    return chi_square > 2 * static_cast<double>(rows);
}

/// How much likelier, in nats, an explanation is under which chi-square falls by `better` than one by `worse`. With an
/// estimated covariance chi-square is Hotelling's T squared, whose density goes with (1 + T^2/n)^(-(n+1)/2).
double nats_between(const Evidence& evidence, double better, double worse);

/// The fall of chi-square that is so many nats less likely than one of `best`.
double gain_behind(const Evidence& evidence, double best, double nats);

/// One or two causes fitted with all nuisances.
struct Refit {
    std::vector<int> causes;
    VectorXd amplitude;    // parallel to causes
    VectorXd error;        // standard errors
    double gain = 0;       // fall of chi-square against the baseline
    VectorXd residual;     // whitened
    MatrixXd slopes;       // nuisances, then the causes
    VectorXd values{};     // of all parameters, where a model was fitted
    bool possible = false; // converged, with plausible amplitudes
    bool at_end = false;   // of the range that is plausible
    std::string refused{}; // why not
};

/// Fits these causes anew. Linear in tests of many thousand cases, through the simulation elsewhere.
using Refitter = std::function<Refit(const std::vector<int>&)>;

/// The refit that the evidence itself gives if everything is linear.
Refit refit_linear(const Evidence& evidence, const std::vector<int>& causes);

enum class Outcome { consistent, named, ambiguous, two_causes, none_known, cannot_decide };

/// Tests of what is left against directions of no particular cause.
struct Adequacy {
    double blocks = 1;            // tail probabilities
    double prints = 1;            // of all fingerprints together
    double strongest = 1;         // of the one that the residual follows most, shared by all (Bonferroni)
    std::optional<Swing> swing{}; // the strongest; none was looked for in means
    [[nodiscard]] double p() const {
        const double least = std::min({blocks, prints, strongest});
        return std::min(1.0, swing ? 4 * std::min(least, swing->p) : 3 * least);
    }
};

/// One cause as the data see it.
struct Seen {
    bool visible = false; // a plausible amplitude would show
    double share = 0;     // of its effect that nuisances leave
    double amplitude = 0; // as the linear screening has it
    double error = 0;     // standard error of that
    double gain = 0;      // fall of chi-square, refitted where it was
    double lower = 0;     // 95 % limits of the amplitude beside the baseline (one-sided)
    double upper = 0;
    std::optional<Refit> refit{};
};

/// How well one condition is predicted by the others: chi-square of its readings, where a prediction that is not well
/// known errs less than one that is by as much.
struct Score {
    std::string condition;
    int readings = 0;
    double baseline = 0, extended = 0;
    double spread = 0; // by how much the logarithm of the prediction's covariance grows with what was added
    /// What the extended scene gains of log score: of the probability that it gave to what was read.
    [[nodiscard]] double nats() const { return 0.5 * (baseline - extended - spread); }
};

/// How the winner, or two of them, do when one condition is left out.
struct Fold {
    Score score;
    double amplitude = 0; // from the other conditions, of the first cause
    double moved = 0;     // standard errors away from the amplitude of all, of the cause that moves most
    int mover = 0;        // which that is
};

struct Decision {
    Outcome outcome = Outcome::cannot_decide;
    std::string reason;                  // of cannot_decide, or what keeps a name from being sure
    bool sure = true;                    // false: named, but a veto spoke
    std::string remedy;                  // what would make it sure
    bool one_class = false;              // the causes named are one answer to these data
    std::vector<int> causes;             // named; or the set that holds the truth
    std::vector<int> beyond;             // would be one answer with those named, at the end of their range or beyond
    std::vector<std::vector<int>> pairs; // of two causes, or of ambiguous pairs
    double gate = 0;    // chi-square fall that the best of the library reaches in alpha of the cases by chance
    double largest = 0; // reached
    double second = 0;  // standard errors, of another cause beside the one named that 95 % do not exclude, and of which
    int second_cause = -1;
    Adequacy baseline, winner;
    std::vector<Seen> seen; // per cause
    MatrixXd isolability;   // share of the row's effect that the column's cause leaves
    std::vector<Fold> folds;
    std::optional<Refit> best; // of the causes named, or the best proxy of none known
};

/// It says what is wrong, sure of it or not.
inline bool names(const Decision& decision) {
    return decision.outcome == Outcome::named || decision.outcome == Outcome::two_causes;
}

Decision decide(const Evidence& evidence, const Settings& settings, const Refitter& refit);

/// What a residual looks like: a direction of no particular cause, and how far the residual goes along it.
struct Followed {
    std::string what; // "the square of speed, with its sign (centre_of_mass_y)"
    double z = 0;     // standard errors, what was fitted adjusted
};

/// Directions that what the best explanation leaves follows, the strongest first, six at most.
struct Following {
    int tried = 0;   // directions
    double gate = 0; // standard errors: noise alone lets any of those tried reach it in 0.27 % of cases (Bonferroni)
    std::vector<Followed> all{};
};

/// Gated by the normal's tail, or by that of Student's t where the covariance was estimated.
Following followed_by(const Evidence& evidence, const Decision& decision);

/// Tests of a residual whose fit had these slopes.
Adequacy adequacy_of(const VectorXd& residual, const MatrixXd& slopes, const Directions& directions,
                     double degrees = covariance_known);

} // namespace tumble::diagnose
