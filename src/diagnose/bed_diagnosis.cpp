#include "diagnose/bed_diagnosis.h"

#include "diagnose/bed_plan.h"
#include "scene/load.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr std::uint64_t confirming_seeds = 1000; // after the scene's: none that the table has
constexpr double confirmed = 0.005;              // least p of runs that bear out the table
constexpr double contradicted = 2;               // factor between stated and simulated scatter
constexpr double negligible = 1e-6;              // of a cause's range

/// In three digits, so that data which change a little find their runs again.
double rounded(double value) {
    if (value == 0)
        return 0;
    const double digit = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
    return std::round(value / digit) * digit;
}

/// Those asked for that are not innocent.
std::vector<Cause> suspects_in(const Measurement& measurement) {
    std::vector<Cause> causes = *choose_causes(measurement.causes, Data::beds);
    std::erase_if(causes, [&](const Cause& cause) {
        return std::any_of(measurement.nuisances.begin(), measurement.nuisances.end(),
                           [&](const Nuisance& nuisance) { return nuisance.cause == cause.id; });
    });
    return causes;
}

class BedDiagnosing {
public:
    BedDiagnosing(const SceneText& scene, const Measurement& measurement, const TellStage& tell)
        : scene_(scene), measurement_(measurement), tell_(tell) {}

    Result<Diagnosis> run(Beds& beds, bool plan) {
        beds_ = &beds;
        d_ = begun_with(scene_, measurement_);
        auto model =
            BedModel::make(beds, measurement_.bulks, suspects_in(measurement_), measurement_.nuisances, d_.warnings);
        if (!model)
            return model.problems();
        for (Problem& warning : d_.warnings)
            if (warning.file.empty())
                warning.file = scene_.file.string();
        model_ = &*model;
        d_.causes = model_->causes();
        baseline_ = model_->adjusted({}, {});
        fill_numbers();
        fill_nuisances();
        if (Problems problems = decide_it(); !problems.empty())
            return problems;
        if (plan || d_.decision.outcome == Outcome::ambiguous) {
            tell(plan ? "runs what could be measured besides" : "looks for numbers that would tell the causes apart");
            d_.proposals = bed_proposals(beds, *model_, d_.evidence, d_.decision, plan);
        }
        d_.simulated = beds.simulated();
        d_.runs = beds.runs();
        tell_of_old_runs();
        return std::move(d_);
    }

private:
    void tell_of_old_runs() {
        d_.old_runs = beds_->old_runs();
        if (d_.old_runs > 0)
            d_.warnings.push_back(
                {.file = measurement_.file.string(),
                 .key = "old runs",
                 .what = fmt::format(
                     "{} of the runs that count were made by another version of the program (--old-runs)", d_.old_runs),
                 .fix = "without --old-runs they are made anew"});
        if (const int aside = beds_->left_aside(); aside > 0)
            d_.warnings.push_back({.file = measurement_.file.string(),
                                   .key = "runs left aside",
                                   .what = fmt::format("{} of the runs kept are of another scene, or their table does "
                                                       "not say of which",
                                                       aside),
                                   .fix = "nothing: they were made anew; old runs of a changed scene never count"});
    }

    void tell(const std::string& stage) const {
        if (tell_)
            tell_(stage);
    }

    Problems decide_it() {
        d_.evidence = model_->evidence();
        const auto& rows = d_.evidence.directions.condition;
        d_.readings = static_cast<int>(std::count_if(rows.begin(), rows.end(), [](int row) { return row >= 0; }));
        d_.chi_square = d_.evidence.residual.squaredNorm();
        if (d_.evidence.degrees - d_.readings < 1) {
            d_.decision.reason =
                fmt::format("the runs tell the scatter of {} numbers with {:.0f} degrees of freedom only", d_.readings,
                            d_.evidence.degrees);
            d_.decision.remedy = "Run more seeds (--seeds), or have more causes considered: all their runs count.";
            return {};
        }
        d_.decision = decide(d_.evidence, measurement_.settings,
                             [this](const std::vector<int>& causes) { return model_->refit(d_.evidence, causes); });
        d_.follows = followed_by(d_.evidence, d_.decision);
        const Outcome outcome = d_.decision.outcome;
        if (outcome == Outcome::named || outcome == Outcome::two_causes) {
            tell("runs the named cause at its fitted value");
            if (Problems problems = confirm(*d_.decision.best); !problems.empty())
                return problems;
        }
        return {};
    }

    /// Runs with the causes at their fitted amplitudes, of new seeds, under every condition.
    Problems confirm(const Refit& best) {
        Confirmation seen;
        Pushes pushes;
        for (std::size_t k = 0; k < best.causes.size(); ++k) {
            seen.amplitudes.push_back(rounded(best.amplitude[static_cast<Eigen::Index>(k)]));
            pushes.push_back({&d_.causes[static_cast<std::size_t>(best.causes[k])], seen.amplitudes.back()});
        }
        BedModel::Adjusted innocent = model_->adjusted(best.causes, best.amplitude);
        const std::vector<double> adjusted = push_innocents(pushes, innocent);
        const double both = 2.0 / beds_->seeds();
        double apart = 0;
        std::vector<Score> scores;
        std::size_t number = 0;
        for (std::size_t c = 0; c < model_->conditions().size(); ++c) {
            const BedCondition& now = model_->conditions()[c];
            const auto runs = beds_->ensemble(static_cast<int>(c), pushes, confirming_seeds);
            if (!runs)
                return runs.problems();
            const VectorXd mean = now.measured_of(runs->colwise().mean().transpose());
            const VectorXd shown = mean + innocent_part(now, innocent);
            for (Eigen::Index k = 0; k < mean.size(); ++k, ++number) {
                d_.beds[number].extended = shown[k];
                d_.beds[number].extended_error = d_.beds[number].baseline_error;
                d_.beds[number].has_extended = std::isfinite(mean[k]);
            }
            const MatrixXd covariance = now.covariance(beds_->seeds());
            const auto chi_square = [&](const VectorXd& simulated) {
                return whitened(covariance, now.values() - simulated).squaredNorm();
            };
            if (now.measured.held_out)
                scores.push_back({.condition = now.measured.condition,
                                  .readings = static_cast<int>(mean.size()),
                                  .baseline = chi_square(now.measured_of(now.mean) + innocent_part(now, baseline_)),
                                  .extended = chi_square(shown)});
            else
                apart += whitened(both * now.simulated_covariance(), mean - foretold(now, best, seen, adjusted))
                             .squaredNorm();
        }
        seen.p = std::isfinite(apart) ? hotelling_tail(apart, d_.readings, d_.evidence.degrees) : 0;
        if (seen.p < confirmed && d_.decision.sure) {
            d_.decision.sure = false;
            d_.decision.reason =
                std::isfinite(apart)
                    ? "runs at the fitted value do not bear out what was read between the amplitudes run"
                    : "the scene breaks down, or a number measured has no meaning, at the fitted value";
            d_.decision.remedy = "Run more seeds (--seeds), or start from a scene nearer to the bed measured.";
        }
        d_.confirmation = seen;
        extend(pushes);
        measure_gain(std::move(scores));
        return {};
    }

    /// Adds what is innocent to what is run, where it fits best and within what is plausible, and leaves of the
    /// adjustment only what no run can hold: zeros of measures. What was added of each, 0 of those.
    std::vector<double> push_innocents(Pushes& pushes, BedModel::Adjusted& innocent) {
        std::vector<double> added(model_->innocents().size(), 0);
        for (std::size_t n = 0; n < added.size(); ++n) {
            const Cause* cause = model_->cause_of(model_->innocents()[n]);
            if (!cause)
                continue;
            double& value = innocent.value[static_cast<Eigen::Index>(n)];
            const double plausible = std::clamp(value, cause->lo, cause->hi);
            if (std::abs(value - plausible) > negligible * (cause->hi - cause->lo))
                d_.warnings.push_back(
                    {.file = measurement_.file.string(),
                     .key = "innocent cause out of range",
                     .what = fmt::format("{} would fit best at {:.3g}, beyond the {:g} to {:g} that were run",
                                         cause->id, value, cause->lo, cause->hi),
                     .fix = fmt::format("it is {:.3g} in what is run and written; ask whether it is innocent, or state "
                                        "what is known of it (spread)",
                                        plausible)});
            value = 0; // the runs have it
            if (std::abs(plausible) <= negligible * (cause->hi - cause->lo))
                continue;
            added[n] = std::clamp(rounded(plausible), cause->lo, cause->hi);
            pushes.push_back({cause, added[n]});
        }
        return added;
    }

    [[nodiscard]] VectorXd foretold(const BedCondition& now, const Refit& best, const Confirmation& seen,
                                    const std::vector<double>& adjusted) const {
        VectorXd all = now.mean;
        for (std::size_t k = 0; k < best.causes.size(); ++k)
            all += now.branches[static_cast<std::size_t>(best.causes[k])].change(seen.amplitudes[k]);
        for (std::size_t n = 0; n < adjusted.size(); ++n)
            if (adjusted[n] != 0)
                all += now.branches[model_->innocents()[n].branch].change(adjusted[n]);
        return now.measured_of(all);
    }

    /// Conditions held out, predicted by what was run in them; else each from the others.
    void measure_gain(std::vector<Score> aside) {
        const bool held_out = !aside.empty();
        if (!held_out)
            for (const Fold& fold : d_.decision.folds)
                aside.push_back(fold.score);
        if (!aside.empty())
            d_.gain = gain_of(std::move(aside), held_out);
    }

    /// The scene as it is written, with the causes in it and those that are innocent.
    void extend(const Pushes& pushes) {
        auto scene = scene::load_scene_text(scene_.toml, scene_.file, scene_.sets);
        if (!scene)
            return;
        for (const Push& push : pushes)
            push.cause->extend(*scene, push.amplitude);
        d_.extended = std::move(*scene);
    }

    /// What is innocent adds to a condition's numbers.
    [[nodiscard]] VectorXd innocent_part(const BedCondition& now, const BedModel::Adjusted& innocent) const {
        if (innocent.value.size() == 0)
            return VectorXd::Zero(static_cast<Eigen::Index>(now.columns.size()));
        return innocent_slopes(now, model_->innocents()) * innocent.value;
    }

    void fill_nuisances() {
        for (std::size_t n = 0; n < model_->innocents().size(); ++n) {
            const auto i = static_cast<Eigen::Index>(n);
            d_.nuisances.push_back({model_->innocents()[n].name, 0, baseline_.value[i], baseline_.error[i]});
        }
    }

    void fill_numbers() {
        for (const BedCondition& now : model_->conditions()) {
            const VectorXd mean = now.measured_of(now.mean) + innocent_part(now, baseline_);
            const MatrixXd own = now.simulated_covariance();
            for (std::size_t k = 0; k < now.measured.numbers.size(); ++k) {
                const auto i = static_cast<Eigen::Index>(k);
                const BulkNumber& number = now.measured.numbers[k];
                const double scatter = std::sqrt(own(i, i));
                const double stated = number.sigma > 0 ? number.sigma : scatter;
                d_.beds.push_back({.condition = now.measured.condition,
                                   .measure = number.measure,
                                   .unit = number.unit,
                                   .held_out = now.measured.held_out,
                                   .runs = now.measured.runs,
                                   .seeds = beds_->seeds(),
                                   .measured = number.value,
                                   .measured_error = stated / std::sqrt(now.measured.runs),
                                   .baseline = mean[i],
                                   .baseline_error = scatter / std::sqrt(beds_->seeds()),
                                   .scatter = scatter});
                if (const double ratio = stated / scatter; ratio > contradicted || ratio < 1 / contradicted)
                    d_.warnings.push_back(
                        {.file = measurement_.file.string(),
                         .key = "sigma contradicted",
                         .what =
                             fmt::format("{}: {} is said to scatter {:.2g} times as much as the simulation's runs do",
                                         now.measured.condition, number.measure, ratio),
                         .fix = "the measured scatter is taken as stated; it should be that of means over as long a "
                                "stretch"});
            }
        }
    }

    const SceneText& scene_;
    const Measurement& measurement_;
    const TellStage& tell_;
    Diagnosis d_;
    Beds* beds_ = nullptr;
    BedModel* model_ = nullptr;
    BedModel::Adjusted baseline_; // what is innocent, without any cause
};

} // namespace

Result<Diagnosis> diagnose_beds(const SceneText& scene, const Measurement& measurement, const Simulate& simulate,
                                const BedOptions& options, const TellStage& tell) {
    auto beds = Beds::make(scene, measurement.bulks, simulate, options);
    if (!beds)
        return beds.problems();
    if (tell)
        tell("runs the bed as it is, and with each cause");
    return BedDiagnosing(scene, measurement, tell).run(*beds, options.plan);
}

Result<Budget> budget_of_beds(const SceneText& scene, const Measurement& measurement, const BedOptions& options) {
    const auto beds = Beds::make(scene, measurement.bulks, {}, options);
    if (!beds)
        return beds.problems();
    std::vector<Cause> innocent;
    for (const Nuisance& nuisance : measurement.nuisances)
        if (!nuisance.cause.empty())
            innocent.push_back(choose_causes({nuisance.cause}, Data::beds)->front());
    return BedModel::budget(*beds, measurement.bulks, suspects_in(measurement), innocent);
}

} // namespace tumble::diagnose
