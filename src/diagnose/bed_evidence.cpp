#include "diagnose/bed_model.h"
#include "diagnose/folds.h"

#include <Eigen/QR>
#include <algorithm>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr int grid = 121;                    // of amplitudes, where one cause is fitted
constexpr int coarse_grid = 31;              // along each of two
constexpr int most_steps = 50;               // of Gauss and Newton from there
constexpr double least_share_of_step = 1e-4; // of a step that is worth taking
constexpr double at_its_end = 1e-6;          // of the range

} // namespace

template <class Part> VectorXd BedModel::stacked(Part part) const {
    std::vector<double> all;
    for (const BedCondition& now : conditions_)
        if (!now.measured.held_out)
            for (const double value : whitened(now.covariance(beds_->seeds()), part(now)))
                all.push_back(value);
    for (const Innocent& innocent : innocents_)
        if (innocent.spread > 0)
            all.push_back(0);
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

VectorXd BedModel::misfit() const {
    return stacked([](const BedCondition& now) { return VectorXd(now.values() - now.measured_of(now.mean)); });
}

MatrixXd innocent_slopes(const BedCondition& now, const std::vector<Innocent>& innocents) {
    const auto numbers = static_cast<Eigen::Index>(now.columns.size());
    MatrixXd all = MatrixXd::Zero(numbers, static_cast<Eigen::Index>(innocents.size()));
    for (std::size_t n = 0; n < innocents.size(); ++n) {
        const Innocent& one = innocents[n];
        const auto column = static_cast<Eigen::Index>(n);
        if (one.measure.empty())
            all.col(column) = now.measured_of(now.branches[one.branch].slope(0));
        for (Eigen::Index k = 0; k < numbers; ++k)
            if (now.measured.numbers[static_cast<std::size_t>(k)].measure == one.measure &&
                (one.condition.empty() || one.condition == now.measured.condition))
                all(k, column) = 1;
    }
    return all;
}

MatrixXd BedModel::nuisances() const {
    const auto priors = std::count_if(innocents_.begin(), innocents_.end(), [](const auto& n) { return n.spread > 0; });
    MatrixXd all(misfit().size(), static_cast<Eigen::Index>(innocents_.size()));
    Eigen::Index prior = all.rows() - priors;
    for (Eigen::Index n = 0; n < all.cols(); ++n) {
        all.col(n) =
            stacked([&](const BedCondition& now) { return VectorXd(innocent_slopes(now, innocents_).col(n)); });
        if (const double spread = innocents_[static_cast<std::size_t>(n)].spread; spread > 0)
            all(prior++, n) = 1 / spread;
    }
    return all;
}

BedModel::Adjusted BedModel::adjusted(const std::vector<int>& causes, const VectorXd& amplitudes) const {
    if (innocents_.empty())
        return {};
    const MatrixXd slopes = nuisances();
    return {slopes.completeOrthogonalDecomposition().solve(misfit() - change(causes, amplitudes)), errors_of(slopes)};
}

Evidence BedModel::evidence() const {
    Evidence evidence;
    evidence.nuisances = nuisances();
    evidence.residual = Projector(evidence.nuisances).out(misfit());
    const Eigen::Index rows = evidence.residual.size();
    evidence.effects = MatrixXd::Zero(rows, static_cast<Eigen::Index>(causes_.size()));
    for (std::size_t k = 0; k < causes_.size(); ++k) {
        const auto part = [&](auto of) {
            return stacked([&](const BedCondition& now) { return now.measured_of(of(now.branches[k])); });
        };
        const bool mostly_even = part([](const Branch& branch) { return branch.even(); }).norm() >
                                 part([](const Branch& branch) { return branch.odd(); }).norm();
        evidence.effects.col(static_cast<Eigen::Index>(k)) =
            part([&](const Branch& branch) { return branch.direction(mostly_even); });
    }
    evidence.causes = causes_;
    evidence.degrees = degrees();
    evidence.directions = directions(rows);
    return evidence;
}

/// Any number may be off by itself, or one measure under all conditions alike.
Directions BedModel::directions(Eigen::Index rows) const {
    Directions directions;
    std::vector<std::string> measures;
    for (const BedCondition& now : conditions_) {
        if (now.measured.held_out)
            continue;
        for (const BulkNumber& number : now.measured.numbers) {
            directions.condition.push_back(static_cast<int>(directions.conditions.size()));
            if (std::find(measures.begin(), measures.end(), number.measure) == measures.end())
                measures.push_back(number.measure);
        }
        directions.conditions.push_back(now.measured.condition);
    }
    directions.blocks = MatrixXd::Identity(rows, static_cast<Eigen::Index>(directions.condition.size()));
    directions.condition.resize(static_cast<std::size_t>(rows), -1); // priors
    directions.prints = MatrixXd::Zero(rows, static_cast<Eigen::Index>(measures.size()));
    for (std::size_t m = 0; m < measures.size(); ++m)
        directions.prints.col(static_cast<Eigen::Index>(m)) = stacked([&](const BedCondition& now) {
            VectorXd only = now.covariance(1).diagonal().cwiseSqrt();
            for (std::size_t k = 0; k < now.columns.size(); ++k)
                if (now.measured.numbers[k].measure != measures[m])
                    only[static_cast<Eigen::Index>(k)] = 0;
            return only;
        });
    directions.prints = unit_columns(directions.prints);
    for (const std::string& measure : measures)
        directions.names.push_back(measure + " under all conditions alike");
    return directions;
}

MatrixXd BedModel::slopes(const std::vector<int>& causes, const VectorXd& amplitudes) const {
    MatrixXd all(misfit().size(), amplitudes.size());
    for (Eigen::Index k = 0; k < amplitudes.size(); ++k)
        all.col(k) = stacked([&](const BedCondition& now) {
            const auto cause = static_cast<std::size_t>(causes[static_cast<std::size_t>(k)]);
            return now.measured_of(now.branches[cause].slope(amplitudes[k]));
        });
    return all;
}

/// Where parabolas bend there may be two valleys: a grid finds the deeper one, Gauss and Newton its bottom.
VectorXd BedModel::best_amplitudes(const Evidence& evidence, const std::vector<int>& causes, const VectorXd& lo,
                                   const VectorXd& hi) const {
    const Projector innocent(evidence.nuisances);
    const auto left_by = [&](const VectorXd& amplitudes) {
        return innocent.out(VectorXd(evidence.residual - change(causes, amplitudes)));
    };
    const auto chi_square = [&](const VectorXd& amplitudes) { return left_by(amplitudes).squaredNorm(); };
    const Eigen::Index count = lo.size();
    VectorXd best = VectorXd::Zero(count), trial(count);
    double least = chi_square(best);
    const int along = count == 1 ? grid : coarse_grid;
    for (int i = 0; i < (count == 1 ? along : along * along); ++i) {
        for (Eigen::Index k = 0; k < count; ++k)
            trial[k] = lo[k] + (hi[k] - lo[k]) * (k == 0 ? i % along : i / along) / (along - 1);
        if (const double now = chi_square(trial); now < least)
            least = now, best = trial;
    }
    double share = 1;
    for (int step = 0; step < most_steps && share > least_share_of_step; ++step) {
        const MatrixXd steep = innocent.out(slopes(causes, best));
        const VectorXd full = steep.completeOrthogonalDecomposition().solve(left_by(best));
        for (share = 1; share > least_share_of_step; share /= 2) {
            trial = (best + share * full).cwiseMax(lo).cwiseMin(hi);
            if (const double now = chi_square(trial); now < least) {
                least = now, best = trial;
                break;
            }
        }
    }
    return best;
}

Refit BedModel::refit(const Evidence& evidence, const std::vector<int>& causes) const {
    const auto count = static_cast<Eigen::Index>(causes.size());
    VectorXd lo(count), hi(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Cause& cause = causes_[static_cast<std::size_t>(causes[static_cast<std::size_t>(k)])];
        lo[k] = cause.lo;
        hi[k] = cause.hi;
    }
    Refit refit;
    refit.causes = causes;
    refit.amplitude = best_amplitudes(evidence, causes, lo, hi);
    refit.residual = Projector(evidence.nuisances).out(VectorXd(evidence.residual - change(causes, refit.amplitude)));
    refit.slopes.resize(evidence.nuisances.rows(), evidence.nuisances.cols() + count);
    refit.slopes << evidence.nuisances, slopes(causes, refit.amplitude);
    refit.error = errors_of(refit.slopes).tail(count);
    refit.gain = evidence.residual.squaredNorm() - refit.residual.squaredNorm();
    refit.possible = true;
    for (Eigen::Index k = 0; k < count; ++k) {
        const double near = at_its_end * (hi[k] - lo[k]), found = refit.amplitude[k];
        const bool turns = causes_[static_cast<std::size_t>(causes[static_cast<std::size_t>(k)])].turns;
        if (turns || (found > lo[k] + near && found < hi[k] - near))
            continue;
        refit.possible = false;
        refit.at_end = true;
        refit.refused = fmt::format("would have to be {} {:g}, the end of what was run",
                                    found <= lo[k] + near ? "below" : "above", found);
    }
    return refit;
}

} // namespace tumble::diagnose
