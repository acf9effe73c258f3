#include "diagnose/bed_model.h"

#include "base/text.h"
#include "diagnose/folds.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr int halvings = 3;         // of an amplitude that a scene does not bear
constexpr double chance = 0.01;     // of a cause that does nothing to be taken for one that does
constexpr int grid = 121;           // of amplitudes, where one cause is fitted
constexpr int coarse_grid = 31;     // along each of two
constexpr int most_steps = 50;      // of Gauss and Newton from there
constexpr double at_its_end = 1e-6; // of the range

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
                                Problems& warnings) {
    BedModel model;
    model.beds_ = &beds;
    model.causes_ = std::move(causes);
    for (std::size_t c = 0; c < conditions.size(); ++c)
        if (const auto ran = model.run_condition(static_cast<int>(c), conditions[c], warnings); !ran)
            return ran.problems();
    model.forget_what_is_chance();
    return model;
}

Budget BedModel::budget(const Beds& beds, const std::vector<Bulk>& conditions, const std::vector<Cause>& causes) {
    Budget budget;
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        const auto condition = static_cast<int>(c);
        beds.charge(budget, condition, {});
        for (const Cause& cause : conditions[c].held_out ? std::vector<Cause>{} : causes)
            for (const double amplitude : amplitudes_for(cause))
                if (!beds.idle(condition, {{&cause, amplitude}}))
                    beds.charge(budget, condition, {{&cause, amplitude}});
    }
    return budget;
}

Result<Done> BedModel::run_condition(int condition, const Bulk& bulk, Problems& warnings) {
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
    for (const Cause& cause : bulk.held_out ? std::vector<Cause>{} : causes_) {
        auto branch = run_cause(condition, cause, now, all, warnings);
        if (!branch)
            return branch.problems();
        now.branches.push_back(std::move(*branch));
    }
    // Numbers without meaning in some run are measured nowhere; they must not spoil the others.
    for (Ensemble& one : all)
        one = one.unaryExpr([](double value) { return std::isfinite(value) ? value : 0; });
    now.scatter = pooled_scatter(all);
    conditions_.push_back(std::move(now));
    return Done{};
}

/// At either amplitude, or at half of it and so on where the scene does not bear it.
Result<Branch> BedModel::run_cause(int condition, const Cause& cause, BedCondition& into, std::vector<Ensemble>& all,
                                   Problems& warnings) {
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

/// A cause whose runs differ from the baseline by no more than seeds do is none: its direction would be one of chance.
/// What is left keeps the range that every condition was run in.
void BedModel::forget_what_is_chance() {
    const double both = 2.0 / beds_->seeds();
    for (std::size_t k = 0; k < causes_.size(); ++k) {
        double largest = 0, numbers = 0;
        for (const double side : {-1.0, 1.0}) {
            double sum = 0;
            numbers = 0;
            for (const BedCondition& now : conditions_) {
                if (now.measured.held_out)
                    continue;
                const Branch& branch = now.branches[k];
                const double end = branch.wave ? 90 * side
                                   : side < 0  ? (branch.lo < 0 ? branch.lo : branch.hi / 2)
                                               : branch.hi;
                sum += whitened(both * now.simulated_covariance(), now.measured_of(branch.change(end))).squaredNorm();
                numbers += static_cast<double>(now.columns.size());
            }
            largest = std::max(largest, sum);
        }
        const bool acts = 2 * hotelling_tail(largest, numbers, degrees()) < chance;
        for (BedCondition& now : conditions_) {
            if (now.measured.held_out)
                continue;
            Branch& branch = now.branches[k];
            if (!acts)
                branch = Branch::flat(branch.first.size(), branch.lo, branch.hi);
            else if (branch.first.norm() + branch.second.norm() > 0) {
                causes_[k].lo = std::max(causes_[k].lo, branch.lo);
                causes_[k].hi = std::min(causes_[k].hi, branch.hi);
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

/// What `part` gives of every fitted condition, whitened and one below the other.
template <class Part> VectorXd BedModel::stacked(Part part) const {
    std::vector<double> all;
    for (const BedCondition& now : conditions_)
        if (!now.measured.held_out)
            for (const double value : whitened(now.covariance(beds_->seeds()), part(now)))
                all.push_back(value);
    return Eigen::Map<VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

VectorXd BedModel::change(const std::vector<int>& causes, const VectorXd& amplitudes) const {
    return stacked([&](const BedCondition& now) {
        VectorXd sum = VectorXd::Zero(now.mean.size());
        for (std::size_t k = 0; k < causes.size(); ++k)
            sum += now.branches[static_cast<std::size_t>(causes[k])].change(amplitudes[static_cast<Eigen::Index>(k)]);
        return now.measured_of(sum);
    });
}

Evidence BedModel::evidence() const {
    Evidence evidence;
    evidence.residual =
        stacked([](const BedCondition& now) { return VectorXd(now.values() - now.measured_of(now.mean)); });
    const Eigen::Index rows = evidence.residual.size();
    evidence.nuisances = MatrixXd::Zero(rows, 0);
    evidence.effects = MatrixXd::Zero(rows, static_cast<Eigen::Index>(causes_.size()));
    for (std::size_t k = 0; k < causes_.size(); ++k)
        evidence.effects.col(static_cast<Eigen::Index>(k)) =
            stacked([k](const BedCondition& now) { return now.measured_of(now.branches[k].direction()); });
    evidence.causes = causes_;
    evidence.degrees = degrees();
    Directions& directions = evidence.directions;
    std::vector<std::string> measures;
    for (const BedCondition& now : conditions_) {
        if (now.measured.held_out)
            continue;
        for (const BulkNumber& number : now.measured.numbers) {
            directions.condition.push_back(static_cast<int>(directions.conditions.size()));
            directions.early.push_back(false);
            if (std::find(measures.begin(), measures.end(), number.measure) == measures.end())
                measures.push_back(number.measure);
        }
        directions.conditions.push_back(now.measured.condition);
    }
    // Any number may be off by itself, or one measure under all conditions alike.
    directions.blocks = MatrixXd::Identity(rows, rows);
    directions.prints = MatrixXd::Zero(rows, static_cast<Eigen::Index>(measures.size()));
    for (std::size_t m = 0; m < measures.size(); ++m)
        directions.prints.col(static_cast<Eigen::Index>(m)) = stacked([&](const BedCondition& now) {
            VectorXd only = VectorXd::Zero(static_cast<Eigen::Index>(now.columns.size()));
            for (std::size_t k = 0; k < now.columns.size(); ++k)
                if (now.measured.numbers[k].measure == measures[m])
                    only[static_cast<Eigen::Index>(k)] =
                        std::sqrt(now.covariance(1)(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)));
            return only;
        });
    directions.prints = unit_columns(directions.prints);
    return evidence;
}

Refit BedModel::refit(const Evidence& evidence, const std::vector<int>& causes) const {
    const auto count = static_cast<Eigen::Index>(causes.size());
    VectorXd lo(count), hi(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Cause& cause = causes_[static_cast<std::size_t>(causes[static_cast<std::size_t>(k)])];
        lo[k] = cause.lo;
        hi[k] = cause.hi;
    }
    const auto misfit = [&](const VectorXd& amplitudes) {
        return (evidence.residual - change(causes, amplitudes)).squaredNorm();
    };
    // Where parabolas bend there may be two valleys: a grid finds the deeper one.
    VectorXd best = VectorXd::Zero(count), trial(count);
    double least = misfit(best);
    const int along = count == 1 ? grid : coarse_grid;
    for (int i = 0; i < (count == 1 ? along : along * along); ++i) {
        for (Eigen::Index k = 0; k < count; ++k)
            trial[k] = lo[k] + (hi[k] - lo[k]) * (k == 0 ? i % along : i / along) / (along - 1);
        if (const double now = misfit(trial); now < least)
            least = now, best = trial;
    }
    const auto slopes_at = [&](const VectorXd& amplitudes) {
        MatrixXd slopes(evidence.residual.size(), count);
        for (Eigen::Index k = 0; k < count; ++k)
            slopes.col(k) = stacked([&](const BedCondition& now) {
                const auto cause = static_cast<std::size_t>(causes[static_cast<std::size_t>(k)]);
                return now.measured_of(now.branches[cause].slope(amplitudes[k]));
            });
        return slopes;
    };
    for (int step = 0; step < most_steps; ++step) {
        const VectorXd rest = evidence.residual - change(causes, best);
        const VectorXd full = slopes_at(best).completeOrthogonalDecomposition().solve(rest);
        double share = 1;
        for (; share > 1e-4; share /= 2) {
            trial = (best + share * full).cwiseMax(lo).cwiseMin(hi);
            if (const double now = misfit(trial); now < least) {
                least = now, best = trial;
                break;
            }
        }
        if (share <= 1e-4)
            break;
    }
    Refit refit;
    refit.causes = causes;
    refit.amplitude = best;
    refit.residual = evidence.residual - change(causes, best);
    refit.slopes = slopes_at(best);
    refit.error = errors_of(refit.slopes);
    refit.gain = evidence.residual.squaredNorm() - least;
    refit.possible = true;
    for (Eigen::Index k = 0; k < count; ++k) {
        const Cause& cause = causes_[static_cast<std::size_t>(causes[static_cast<std::size_t>(k)])];
        const double near = at_its_end * (hi[k] - lo[k]);
        if (!cause.turns && (best[k] <= lo[k] + near || best[k] >= hi[k] - near)) {
            refit.possible = false;
            refit.refused =
                fmt::format("would have to be {} {:g}, the end of what was run",
                            best[k] <= lo[k] + near ? "below" : "above", best[k] <= lo[k] + near ? lo[k] : hi[k]);
        }
    }
    return refit;
}

} // namespace tumble::diagnose
