#include "diagnose/bed_model.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr int halvings = 3;     // of an amplitude that a scene does not bear
constexpr double chance = 0.01; // of a cause that does nothing to be taken for one that does

/// Amplitudes to run a cause at: half of what is plausible to either side; of one that has one side, that and half of
/// it.
std::vector<double> amplitudes_for(const Cause& cause) {
    const double up = cause.in_beds > 0 ? cause.in_beds : cause.hi / 2;
    if (cause.lo == 0)
        return {up, up / 2};
    return {up, cause.in_beds > 0 ? -cause.in_beds : cause.lo / 2};
}

bool has_all(const Ensemble& runs, const std::vector<int>& columns) {
    return std::all_of(columns.begin(), columns.end(), [&](int c) { return runs.col(c).allFinite(); });
}

VectorXd mean_of(const Ensemble& runs) {
    return runs.colwise().mean().transpose();
}

} // namespace

VectorXd whitened(const MatrixXd& covariance, const VectorXd& values) {
    return covariance.llt().matrixL().solve(values);
}

VectorXd BedCondition::measured_of(const VectorXd& all) const {
    VectorXd some(static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        some[static_cast<Eigen::Index>(k)] = all[columns[k]];
    return some;
}

VectorXd BedCondition::values() const {
    VectorXd all(static_cast<Eigen::Index>(measured.numbers.size()));
    for (std::size_t k = 0; k < measured.numbers.size(); ++k)
        all[static_cast<Eigen::Index>(k)] = measured.numbers[k].value;
    return all;
}

MatrixXd BedCondition::simulated_covariance() const {
    const auto count = static_cast<Eigen::Index>(columns.size());
    MatrixXd some(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j)
            some(i, j) = scatter.covariance(columns[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
    return some;
}

MatrixXd BedCondition::covariance(int simulated_runs) const {
    const MatrixXd own = simulated_covariance();
    VectorXd factor = VectorXd::Ones(own.rows());
    for (std::size_t k = 0; k < measured.numbers.size(); ++k)
        if (const auto i = static_cast<Eigen::Index>(k); measured.numbers[k].sigma > 0)
            factor[i] = measured.numbers[k].sigma / std::sqrt(own(i, i));
    return own / simulated_runs + MatrixXd(factor.asDiagonal() * own * factor.asDiagonal()) / measured.runs;
}

Result<BedModel> BedModel::make(Beds& beds, const std::vector<Bulk>& conditions, std::vector<Cause> causes,
                                const std::vector<Nuisance>& nuisances, Problems& warnings) {
    BedModel model;
    model.beds_ = &beds;
    model.causes_ = std::move(causes);
    for (const Nuisance& nuisance : nuisances)
        model.take_as_innocent(nuisance, conditions);
    const std::vector<bool> all(model.branches(), true);
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        auto ran = model.run_condition(static_cast<int>(c), conditions[c], all, warnings);
        if (!ran)
            return ran.problems();
        model.conditions_.push_back(std::move(*ran));
    }
    model.forget_what_is_chance();
    return model;
}

void BedModel::take_as_innocent(const Nuisance& nuisance, const std::vector<Bulk>& conditions) {
    if (!nuisance.cause.empty()) {
        innocents_.push_back({.name = nuisance.cause, .spread = nuisance.spread, .branch = branches()});
        innocent_causes_.push_back(choose_causes({nuisance.cause}, Data::beds)->front());
    } else if (!nuisance.per_record) {
        innocents_.push_back(
            {.name = "zero of " + nuisance.measure, .spread = nuisance.spread, .measure = nuisance.measure});
    } else {
        for (const Bulk& bulk : conditions)
            innocents_.push_back({.name = fmt::format("zero of {} of {}", nuisance.measure, bulk.condition),
                                  .spread = nuisance.spread,
                                  .measure = nuisance.measure,
                                  .condition = bulk.condition});
    }
}

Budget BedModel::budget(const Beds& beds, const std::vector<Bulk>& conditions, const std::vector<Cause>& causes,
                        const std::vector<Cause>& innocent_causes) {
    Budget budget;
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        const auto condition = static_cast<int>(c);
        const auto charge_all = [&](const std::vector<Cause>& some) {
            for (const Cause& cause : some)
                for (const double amplitude : amplitudes_for(cause))
                    if (!beds.idle(condition, {{&cause, amplitude}}))
                        beds.charge(budget, condition, {{&cause, amplitude}});
        };
        beds.charge(budget, condition, {});
        if (!conditions[c].held_out)
            charge_all(causes);
        charge_all(innocent_causes);
    }
    return budget;
}

Result<BedCondition> BedModel::planned(int condition, const Bulk& bulk, const std::vector<int>& causes) const {
    std::vector<bool> wanted(branches(), false);
    for (const int k : causes)
        wanted[static_cast<std::size_t>(k)] = true;
    std::fill(wanted.begin() + static_cast<std::ptrdiff_t>(causes_.size()), wanted.end(), true);
    Problems ignored;
    return run_condition(condition, bulk, wanted, ignored);
}

Result<BedCondition> BedModel::run_condition(int condition, const Bulk& bulk, const std::vector<bool>& wanted,
                                             Problems& warnings) const {
    BedCondition now{.measured = bulk, .columns = {}, .baseline = {}, .branches = {}, .scatter = {}, .mean = {}};
    for (const BulkNumber& number : bulk.numbers)
        now.columns.push_back(beds_->column_of(number.measure));
    auto baseline = beds_->ensemble(condition, {});
    if (!baseline)
        return baseline.problems();
    if (!has_all(*baseline, now.columns)) {
        if (!beds_->failure().empty())
            return beds_->failure();
        return Problem{.what =
                           fmt::format("{}: the scene as it is breaks down, or a number measured has no meaning in it",
                                       bulk.condition),
                       .fix = "run it (tumble run) with the same sets, and look at series.csv"};
    }
    now.baseline = std::move(*baseline);
    now.mean = mean_of(now.baseline);
    std::vector<Ensemble> all{now.baseline};
    for (std::size_t k = 0; k < branches(); ++k) {
        const Cause& cause = run_as(k);
        const bool is_run = wanted[k] && (!bulk.held_out || k >= causes_.size());
        auto branch = is_run ? run_cause(condition, cause, now, all, warnings)
                             : Branch::flat(now.mean.size(), cause.lo, cause.hi);
        if (!branch)
            return branch.problems();
        now.branches.push_back(std::move(*branch));
    }
    // Numbers without meaning in some run are measured nowhere; they must not spoil the others.
    for (Ensemble& one : all)
        one = one.unaryExpr([](double value) { return std::isfinite(value) ? value : 0; });
    now.scatter = pooled_scatter(all);
    return now;
}

/// At either amplitude, or at half of it and so on where the scene does not bear it.
Result<Branch> BedModel::run_cause(int condition, const Cause& cause, const BedCondition& into,
                                   std::vector<Ensemble>& all, Problems& warnings) const {
    std::vector<double> amplitudes;
    std::vector<VectorXd> changes;
    for (double amplitude : amplitudes_for(cause)) {
        if (beds_->idle(condition, {{&cause, amplitude}}))
            return Branch::flat(into.mean.size(), cause.lo, cause.hi);
        for (int k = 0; k <= halvings; ++k, amplitude /= 2) {
            const auto runs = beds_->ensemble(condition, {{&cause, amplitude}});
            if (!runs)
                return runs.problems();
            if (!has_all(*runs, into.columns))
                continue;
            if (std::find(amplitudes.begin(), amplitudes.end(), amplitude) == amplitudes.end()) {
                amplitudes.push_back(amplitude);
                changes.push_back(mean_of(*runs) - into.mean);
                all.push_back(*runs);
            }
            break;
        }
    }
    if (amplitudes.empty()) {
        warnings.push_back({.key = cause.id,
                            .what = fmt::format("{} cannot be run in '{}'", cause.id, into.measured.condition),
                            .fix = beds_->failure().empty() ? "" : beds_->failure()[0].what});
        return Branch::flat(into.mean.size(), cause.lo, cause.hi);
    }
    return Branch::through(amplitudes, changes, cause.turns);
}

/// How often seeds alone would set the mean of runs so far from the baseline's, at either end of a branch: by the worst
/// single number, or by all together.
double BedModel::chance_of(std::size_t cause) const {
    const double both = 2.0 / beds_->seeds();
    double least = 1;
    for (const bool far : {true, false}) {
        double sum = 0, numbers = 0, single = 0;
        for (const BedCondition& now : conditions_) {
            if (now.measured.held_out)
                continue;
            const Branch& branch = now.branches[cause];
            const VectorXd change = now.measured_of(branch.change(far ? branch.far_end() : branch.other_end()));
            const MatrixXd covariance = both * now.simulated_covariance();
            sum += whitened(covariance, change).squaredNorm();
            single = std::max(single, change.cwiseAbs2().cwiseQuotient(covariance.diagonal()).maxCoeff());
            numbers += static_cast<double>(change.size());
        }
        least =
            std::min({least, hotelling_tail(sum, numbers, degrees()), numbers * hotelling_tail(single, 1, degrees())});
    }
    return 4 * least; // two ends, two tests
}

/// A cause whose runs differ from the baseline by no more than seeds do is none: its direction would be one of chance.
/// What is left keeps the range that every condition was run in.
void BedModel::forget_what_is_chance() {
    for (std::size_t k = 0; k < branches(); ++k) {
        const bool acts = chance_of(k) < chance;
        for (BedCondition& now : conditions_) {
            Branch& branch = now.branches[k];
            if (!acts)
                branch = Branch::flat(branch.first.size(), branch.lo, branch.hi);
            else if (now.measured_of(branch.first).norm() + now.measured_of(branch.second).norm() > 0) {
                Cause& cause = k < causes_.size() ? causes_[k] : innocent_causes_[k - causes_.size()];
                cause.lo = std::max(cause.lo, branch.lo);
                cause.hi = std::min(cause.hi, branch.hi);
            }
        }
    }
}

double BedModel::degrees() const {
    double least = covariance_known;
    for (const BedCondition& now : conditions_)
        if (!now.measured.held_out)
            least = std::min(least, now.scatter.degrees);
    return least;
}

} // namespace tumble::diagnose
