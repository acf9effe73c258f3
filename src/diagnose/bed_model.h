#pragma once

#include "diagnose/beds.h"
#include "diagnose/branch.h"
#include "diagnose/decide.h"

namespace tumble::diagnose {

/// What the runs of one condition came to.
struct BedCondition {
    Bulk measured;
    std::vector<int> columns; // of each number measured
    Ensemble baseline;
    std::vector<Branch>
        branches;    // of each cause, then of the innocent ones, all columns; held out: of the innocent ones alone
    Scatter scatter; // of single runs, all columns
    VectorXd mean;   // of the baseline

    /// The numbers measured out of all columns.
    [[nodiscard]] VectorXd measured_of(const VectorXd& all) const;
    [[nodiscard]] VectorXd values() const;
    /// Of measured less simulated, with so many runs simulated: both scatter. Where a measured scatter is stated it
    /// stands for the measured part, with the simulation's correlations.
    [[nodiscard]] MatrixXd covariance(int simulated_runs) const;
    /// The simulation's own scatter of the numbers measured, of single runs.
    [[nodiscard]] MatrixXd simulated_covariance() const;
};

/// L^-1 times the values, L the lower triangle of their covariance: numbers of scatter 1 that do not depend on each
/// other.
VectorXd whitened(const MatrixXd& covariance, const VectorXd& values);

/// What every explanation may adjust: the amplitude of a cause, or the zero of a measure.
struct Innocent {
    std::string name;
    double spread = 0;       // of what is known beforehand; 0: nothing is
    std::string measure{};   // empty: a cause's amplitude
    std::size_t branch = 0;  // of that cause
    std::string condition{}; // the only one it acts on; empty: all
};

/// Change of a condition's measured numbers per unit of each of these.
MatrixXd innocent_slopes(const BedCondition& now, const std::vector<Innocent>& innocents);

/// Beds as decide() takes them: baseline, directions of causes, refits between the amplitudes that were run.
class BedModel {
public:
    /// Runs what is missing. `causes` keep of their range what was run. Conditions held out get a baseline, and
    /// the causes among the nuisances, which are run as the others are. Problems: a baseline that cannot be run, or in
    /// which a measured number has no meaning.
    static Result<BedModel> make(Beds& beds, const std::vector<Bulk>& conditions, std::vector<Cause> causes,
                                 const std::vector<Nuisance>& nuisances, Problems& warnings);

    /// One more condition of the beds, which could be measured, with these causes and the innocent ones alone.
    [[nodiscard]] Result<BedCondition> planned(int condition, const Bulk& bulk, const std::vector<int>& causes) const;

    /// What make() would run.
    static Budget budget(const Beds& beds, const std::vector<Bulk>& conditions, const std::vector<Cause>& causes,
                         const std::vector<Cause>& innocent_causes);

    [[nodiscard]] Evidence evidence() const;
    /// By least squares between the amplitudes that were run.
    [[nodiscard]] Refit refit(const Evidence& evidence, const std::vector<int>& causes) const;

    [[nodiscard]] const std::vector<BedCondition>& conditions() const { return conditions_; }
    [[nodiscard]] const std::vector<Cause>& causes() const { return causes_; }
    [[nodiscard]] const std::vector<Innocent>& innocents() const { return innocents_; }
    /// Of all conditions that are fitted, the least that the scatter is known with.
    [[nodiscard]] double degrees() const;
    /// Whitened change of all fitted numbers, with a row of 0 for each prior.
    [[nodiscard]] VectorXd change(const std::vector<int>& causes, const VectorXd& amplitudes) const;

    /// What is innocent at its best, with these causes at these amplitudes, and its standard errors.
    struct Adjusted {
        VectorXd value, error;
    };
    [[nodiscard]] Adjusted adjusted(const std::vector<int>& causes, const VectorXd& amplitudes) const;
    /// The cause that this one is; null for the zero of a measure.
    [[nodiscard]] const Cause* cause_of(const Innocent& one) const {
        return one.measure.empty() ? &run_as(one.branch) : nullptr;
    }

private:
    [[nodiscard]] const Cause& run_as(std::size_t branch) const {
        return branch < causes_.size() ? causes_[branch] : innocent_causes_[branch - causes_.size()];
    }
    [[nodiscard]] std::size_t branches() const { return causes_.size() + innocent_causes_.size(); }
    void take_as_innocent(const Nuisance& nuisance, const std::vector<Bulk>& conditions);
    Result<BedCondition> run_condition(int condition, const Bulk& bulk, const std::vector<bool>& wanted,
                                       Problems& warnings) const;
    Result<Branch> run_cause(int condition, const Cause& cause, const BedCondition& into, std::vector<Ensemble>& all,
                             Problems& warnings) const;
    [[nodiscard]] double chance_of(std::size_t cause) const;
    void forget_what_is_chance();
    [[nodiscard]] Directions directions(Eigen::Index rows) const;
    /// Whitened slopes of all fitted numbers by these causes' amplitudes.
    [[nodiscard]] MatrixXd slopes(const std::vector<int>& causes, const VectorXd& amplitudes) const;
    [[nodiscard]] VectorXd best_amplitudes(const Evidence& evidence, const std::vector<int>& causes, const VectorXd& lo,
                                           const VectorXd& hi) const;
    /// Whitened slopes of what is innocent, and its priors.
    [[nodiscard]] MatrixXd nuisances() const;
    [[nodiscard]] VectorXd misfit() const;
    /// What `part` gives of every fitted condition, whitened and one below the other; then 0 for each prior.
    template <class Part> [[nodiscard]] VectorXd stacked(Part part) const;

    Beds* beds_ = nullptr;
    std::vector<BedCondition> conditions_;
    std::vector<Cause> causes_;
    std::vector<Innocent> innocents_;
    std::vector<Cause> innocent_causes_;
};

} // namespace tumble::diagnose
