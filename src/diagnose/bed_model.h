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
    std::vector<Branch> branches; // of each cause, all columns
    Scatter scatter;              // of single runs, all columns
    VectorXd mean;                // of the baseline

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

/// Beds as decide() takes them: baseline, directions of causes, refits between the amplitudes that were run.
class BedModel {
public:
    /// Runs what is missing. `causes` keep of their range what was run. Conditions held out get a baseline only.
    /// Problems: a baseline that cannot be run, or in which a measured number has no meaning.
    static Result<BedModel> make(Beds& beds, const std::vector<Bulk>& conditions, std::vector<Cause> causes,
                                 Problems& warnings);

    /// What make() would run.
    static Budget budget(const Beds& beds, const std::vector<Bulk>& conditions, const std::vector<Cause>& causes);

    [[nodiscard]] Evidence evidence() const;
    /// By least squares between the amplitudes that were run.
    [[nodiscard]] Refit refit(const Evidence& evidence, const std::vector<int>& causes) const;

    [[nodiscard]] const std::vector<BedCondition>& conditions() const { return conditions_; }
    [[nodiscard]] const std::vector<Cause>& causes() const { return causes_; }
    /// Of all conditions that are fitted, the least that the scatter is known with.
    [[nodiscard]] double degrees() const;
    /// Whitened change of all fitted numbers.
    [[nodiscard]] VectorXd change(const std::vector<int>& causes, const VectorXd& amplitudes) const;

private:
    Result<Done> run_condition(int condition, const Bulk& bulk, Problems& warnings);
    Result<Branch> run_cause(int condition, const Cause& cause, BedCondition& into, std::vector<Ensemble>& all,
                             Problems& warnings);
    [[nodiscard]] double chance_of(std::size_t cause) const;
    void forget_what_is_chance();
    [[nodiscard]] Directions directions(Eigen::Index rows) const;
    /// Whitened slopes of all fitted numbers by these causes' amplitudes.
    [[nodiscard]] MatrixXd slopes(const std::vector<int>& causes, const VectorXd& amplitudes) const;
    [[nodiscard]] VectorXd best_amplitudes(const VectorXd& residual, const std::vector<int>& causes, const VectorXd& lo,
                                           const VectorXd& hi) const;
    template <class Part> [[nodiscard]] VectorXd stacked(Part part) const;

    Beds* beds_ = nullptr;
    std::vector<BedCondition> conditions_;
    std::vector<Cause> causes_;
};

} // namespace tumble::diagnose
