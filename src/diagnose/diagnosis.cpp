#include "diagnose/diagnosis.h"

#include "diagnose/considered.h"
#include "diagnose/curves.h"
#include "diagnose/data_doubts.h"
#include "diagnose/fit_doubts.h"
#include "diagnose/folds.h"
#include "diagnose/kinematics.h"
#include "diagnose/misread.h"
#include "diagnose/noise_doubts.h"
#include "diagnose/plain_reason.h"
#include "diagnose/profile.h"
#include "diagnose/refit.h"
#include "diagnose/taken.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <tuple>

namespace tumble::diagnose {

namespace {

std::vector<int> first_numbers(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

constexpr double most_between_repeats = 1.2; // of their scatter over that of the readings in one record
constexpr double by_chance = 0.01;           // less likely differences of repeats are not put down to chance
constexpr double far_away = 3;               // spreads of what was known beforehand
constexpr double may_lack = 0.01;            // of chi-square: nats that a baseline far off may lack
constexpr double well_above = 1.2;           // times the scatter known before: what the best cause leaves is asked
constexpr double hardly_less = 0.9;          // of the scatter before
constexpr double may_lack_then = 2;          // nats, a third of what the gate asks
constexpr double seen_well = 3; // standard errors, left beside nuisances: how far off the slope of a filter is taken

class Diagnosing {
public:
    Diagnosing(const SceneText& scene, const Measurement& measurement, const Simulate& simulate, const TellStage& tell)
        : scene_(scene), measurement_(measurement), simulate_(simulate), tell_(tell) {}

    Result<Diagnosis> run(bool plan) {
        d_ = begun_with(scene_, measurement_);
        auto causes = considered_in(measurement_);
        if (!causes)
            return causes.problems();
        d_.causes = std::move(*causes);
        std::vector<Record> used;
        for (const Record& record : measurement_.records)
            (record.held_out ? aside_ : used).push_back(record);
        if (used.empty())
            return Problem{.file = measurement_.file.string(),
                           .key = "series.held_out",
                           .what = "every series is held out: nothing is left to learn from",
                           .fix = "hold out fewer"};
        auto model = Model::make(scene_, used, measurement_.nuisances, d_.causes, simulate_);
        if (!model)
            return model.problems();
        model_ = &*model;
        tell("fits the baseline, and how each cause would show");
        Problems problems = find_baseline();
        if (problems.empty())
            doubt_bounds(*model_, baseline_.values, measurement_.file, d_.warnings);
        if (problems.empty() && baseline_.converged) {
            tell("fits the causes that show");
            problems = decide_it();
            for (double before = INFINITY; problems.empty() && !slipped() && d_.noise.above > well_above &&
                                           d_.noise.above < hardly_less * before;) {
                before = d_.noise.above;
                tell("takes the scatter from what the best cause leaves");
                problems = decide_by_what_is_left();
            }
            const bool misses = d_.decision.outcome != Outcome::cannot_decide || d_.noise.above > well_above;
            if (problems.empty() && d_.decision.outcome != Outcome::consistent && misses) {
                tell("asks whether a plainer reason does");
                doubt_by_a_plain_reason();
            }
        } else {
            doubt_sensors(d_.decision, d_.warnings);
        }
        if (problems.empty() && names(d_.decision)) {
            tell("measures what the extended scene gains");
            problems = measure_gain();
            if (problems.empty())
                d_.limits = profile_of(*d_.decision.best, baseline_, *model_, noise_,
                                       student_quantile(0.025, d_.evidence.degrees));
            d_.cuts = cuts_of(*model_, d_.decision.best->values);
        }
        if (!problems.empty())
            return problems;
        if (plan || d_.decision.outcome == Outcome::ambiguous || d_.decision.one_class) {
            tell("looks for experiments that would tell the causes apart");
            propose();
        }
        const bool extended = d_.decision.best && d_.decision.best->values.size() > 0;
        d_.curves = curves_of(*model_, noise_, baseline_.values, extended ? &d_.decision.best->values : nullptr);
        d_.simulated = model_->simulated() + plain_effort_.simulated;
        d_.runs = model_->runs() + plain_effort_.runs;
        return std::move(d_);
    }

private:
    void tell(const std::string& stage) const {
        if (tell_)
            tell_(stage);
    }

    Problems find_baseline() {
        noise_ = first_noise(*model_);
        const VectorXd start = model_->start();
        for (std::size_t r = 0; r < model_->records().size(); ++r)
            if (const auto scene = model_->scene_at(start, static_cast<int>(r))) {
                if (auto slip = time_slip(model_->records()[r], scene->duration))
                    return {std::move(*slip)};
                for (Problem& doubt : kinematic_doubts(model_->records()[r], noise_.sigma[r], *scene))
                    d_.warnings.push_back(std::move(doubt));
            }
        const auto predicted = model_->predict(start);
        if (!predicted)
            return predicted.problems();
        std::vector<Misread> misread = misread_in(*model_, noise_, *predicted, d_.warnings);
        if (Problems problems = unit_slips(model_->records(), *predicted, misread); !problems.empty())
            return problems;
        if (const auto scene = model_->scene_at(start, -1); scene && scene->bodies[0].spheres.size() == 1)
            if (auto doubt = lowest_point(model_->records(), *predicted, scene->bodies[0].spheres[0].radius))
                d_.warnings.push_back(std::move(*doubt));
        for (int k = 0; k < model_->nuisances(); ++k)
            if (const auto slope = slope_of(*model_, noise_, start, k, true); !slope)
                return slope.problems();
        if (Problems problems = fit_baseline(start, measurement_.settings.progressive); !problems.empty())
            return problems;
        append(d_.warnings, standing(misread, baseline_, *model_));
        if (const Problem* slip = first_of(d_.warnings, [](const std::string& key) { // what comes may take minutes
                return is_slip(key) || key == warning_key::lowest_point;
            }))
            tell("goes on, though " + slip->what);
        if (Problems problems = find_effects(true); !problems.empty())
            return problems;
        return sharpen_noise(baseline_.values);
    }

    Problems fit_baseline(const VectorXd& start, bool progressive) {
        auto fitted = fit(*model_, noise_, start, first_numbers(model_->nuisances()), {.progressive = progressive});
        if (!fitted)
            return fitted.problems();
        baseline_ = std::move(*fitted);
        const bool lost = astray(baseline_.chi_square, baseline_.residual.size());
        if (((lost || taken_for_scatter()) && baseline_.decrement < may_lack * baseline_.chi_square) ||
            (d_.noise.above > well_above && baseline_.decrement < may_lack_then))
            baseline_.converged = true; // what it still lacks is nothing beside what it misses
        if (!baseline_.converged) {
            d_.decision.reason = fmt::format("the baseline could not be fitted: a further step would still gain {:.2g} "
                                             "nats",
                                             baseline_.decrement);
            d_.decision.remedy = "Let the scene begin nearer to what is known of its nuisances, state their spread, or "
                                 "leave fewer of them free.";
        }
        return {};
    }

    /// A slip of whoever wrote the files is the likeliest reason for a large misfit: no long search for causes then.
    [[nodiscard]] bool slipped() const { return first_of(d_.warnings, ends_search); }

    /// Of what the baseline misses.
    [[nodiscard]] bool taken_for_scatter() const { return d_.noise.above > much_wider; }

    /// Where the baseline misses much that no direction spans, the scatter found is mostly that. What the best cause
    /// leaves tells it better: with that scatter all is decided again, unless it is hardly less.
    Problems decide_by_what_is_left() {
        const auto best = d_.decision.best;
        if (!best || best->values.size() == 0)
            return {};
        const Diagnosis first = d_;
        const auto state = std::tuple(noise_, baseline_, effects_, directions_);
        std::vector<int> free = baseline_.free;
        for (const int cause : best->causes)
            free.push_back(model_->parameter_of(cause));
        noise_ = first_noise(*model_);
        auto extended = fit(*model_, noise_, best->values, free);
        if (!extended)
            return extended.problems();
        baseline_ = std::move(*extended);
        d_.warnings.resize(doubts_);
        d_.decision = {};
        d_.nuisances.clear();
        d_.overstated.reset();
        d_.differing.reset();
        d_.alike.clear();
        if (Problems problems = find_effects(false); !problems.empty())
            return problems;
        if (Problems problems = sharpen_noise(std::get<1>(state).values); !problems.empty())
            return problems;
        if (d_.noise.above < hardly_less * first.noise.above && baseline_.converged) {
            doubt_bounds(*model_, baseline_.values, measurement_.file, d_.warnings);
            return decide_it();
        }
        d_ = first;
        std::tie(noise_, baseline_, effects_, directions_) = state;
        return {};
    }

    /// What filters and clipping do is not in proportion to them: a low pass that is quicker than the readings only
    /// lags, as a clock does that starts late, and a ceiling cuts more readings the lower it is. Their slopes are taken
    /// at an amplitude that would be seen. What such a step leaves of a physical cause may be no more than the
    /// curvature of a nuisance that is the same.
    void look_further(std::size_t cause) {
        const int index = model_->parameter_of(static_cast<int>(cause));
        Parameter& parameter = model_->parameters()[static_cast<std::size_t>(index)];
        const double most = (parameter.hi - parameter.lo) / 4, usual = parameter.step;
        auto effect = effects_.col(static_cast<Eigen::Index>(cause));
        const Projector nuisances(baseline_.slopes);
        double step = usual;
        const bool filter = !d_.causes[cause].physical() && !parameter.exact;
        for (int k = 0; k < 3 && filter && step < most; ++k) {
            const double left = nuisances.out(VectorXd(effect)).norm();
            if (left * step > seen_well / 2)
                break;
            step = std::min(most, step * std::clamp(seen_well / std::max(1e-9, left * step), 2.0, 100.0));
            parameter.step = step;
            if (const auto slope = slope_of(*model_, noise_, baseline_.values, index, false))
                effect = *slope;
        }
        parameter.step = usual;
    }

    /// Slopes of every cause beside the baseline, and the directions of no cause. A cause that cannot be simulated here
    /// has none.
    Problems find_effects(bool tune) {
        effects_ = MatrixXd::Zero(baseline_.residual.size(), static_cast<Eigen::Index>(d_.causes.size()));
        for (std::size_t k = 0; k < d_.causes.size(); ++k) {
            const int parameter = model_->parameter_of(static_cast<int>(k));
            if (const auto slope = slope_of(*model_, noise_, baseline_.values, parameter, tune)) {
                effects_.col(static_cast<Eigen::Index>(k)) = *slope;
                look_further(k);
            } else if (tune)
                d_.warnings.push_back({.file = scene_.file.string(),
                                       .key = d_.causes[k].id,
                                       .what = d_.causes[k].id + " cannot be simulated in this scene",
                                       .fix = slope.problems()[0].what});
        }
        auto directions = directions_at(*model_, noise_, baseline_);
        if (!directions)
            return directions.problems();
        directions_ = std::move(*directions);
        return {};
    }

    /// The scatter that the readings themselves show about the fit, and the baseline from those values on, and all of
    /// the above, with it.
    Problems sharpen_noise(const VectorXd& values) {
        const bool first = d_.noise.of.empty();
        doubts_ = d_.warnings.size();
        const auto misfit = misfit_of(*model_, baseline_.values);
        if (!misfit)
            return misfit.problems();
        MatrixXd explained(baseline_.residual.size(), baseline_.slopes.cols() + effects_.cols() +
                                                          directions_.blocks.cols() + directions_.prints.cols());
        explained << baseline_.slopes, effects_, directions_.blocks, directions_.prints;
        noise_ = refined_noise(noise_, *model_, *misfit, explained, d_.noise);
        if (auto simulated = simulated_readings(noise_, *model_); simulated && first)
            return {std::move(*simulated)};
        const Repeats repeats = repeats_in(noise_, *model_, *misfit, slopes_of_own(), effects_);
        d_.noise.widened = 1;
        d_.noise.repeats = repeats.scatter;
        d_.noise.along = repeats.along;
        if (repeats.chance < by_chance && repeats.scatter > most_between_repeats)
            d_.noise.widened = repeats.scatter;
        if (repeats.along_chance < by_chance && repeats.along > most_between_repeats)
            d_.noise.widened = std::max(d_.noise.widened, repeats.along);
        if (d_.noise.widened > 1) {
            d_.noise.used *= d_.noise.widened;
            for (std::vector<double>& record : noise_.sigma)
                for (double& sigma : record)
                    sigma *= d_.noise.widened;
        }
        doubt_noise(d_.noise, *model_, measurement_.file, d_.warnings);
        if (Problems problems = fit_baseline(values, false); !problems.empty())
            return problems;
        return find_effects(false);
    }

    /// Slopes of the nuisances that every record has its own of.
    [[nodiscard]] MatrixXd slopes_of_own() const {
        std::vector<Eigen::Index> own;
        for (std::size_t k = 0; k < baseline_.free.size(); ++k)
            if (model_->parameters()[static_cast<std::size_t>(baseline_.free[k])].record >= 0)
                own.push_back(static_cast<Eigen::Index>(k));
        return baseline_.slopes(Eigen::all, own);
    }

    Problems decide_it() {
        doubt_numbers(*model_, baseline_.values, d_.warnings);
        d_.evidence = {baseline_.residual, baseline_.slopes, effects_, directions_, d_.causes, {}, 0};
        d_.evidence.degrees = degrees_of_numbers(model_->records());
        d_.evidence.coarse = taken_for_scatter() && !slipped();
        for (const int k : baseline_.free)
            d_.evidence.nuisance.push_back(model_->parameters()[static_cast<std::size_t>(k)].nuisance);
        for (const Parameter& parameter : model_->parameters())
            if (parameter.spread > 0) {
                const Nuisance& nuisance = measurement_.nuisances[static_cast<std::size_t>(parameter.nuisance)];
                d_.evidence.beforehand.push_back(nuisance.key.empty() ? nuisance.instrument : nuisance.key);
            }
        d_.decision = decide(d_.evidence, measurement_.settings, [this](const std::vector<int>& causes) {
            return refit_of(causes, *model_, noise_, baseline_, effects_, !slipped());
        });
        if (d_.decision.outcome == Outcome::cannot_decide && taken_for_scatter()) {
            d_.decision.reason = fmt::format("the simulation misses the readings by {:.0f} times what they scatter, "
                                             "and beside that nothing would show",
                                             d_.noise.above);
            d_.decision.remedy = "Look at the residual first: does time begin where the scene begins, and is each "
                                 "record under its own condition?";
        }
        doubt_agreement(d_.decision, d_.noise, baseline_.residual, *model_);
        d_.follows = followed_by(d_.evidence, d_.decision);
        if (d_.decision.outcome != Outcome::none_known) // what is left of a misfit swings at any frequency
            doubt_hum(d_.decision.best ? d_.decision.best->residual : baseline_.residual, directions_.courses,
                      measurement_.file, d_.warnings);
        else {
            d_.overstated = overstated_in(d_.evidence, measurement_.settings);
            if (d_.overstated)
                d_.alike = alike_to(d_.evidence, d_.overstated->what);
            else
                d_.differing = differing_in(d_.evidence, measurement_.settings);
        }
        doubt_name(d_.decision, d_.causes, d_.warnings);
        take_slips_back();
        const VectorXd errors = errors_of(baseline_.slopes);
        for (int k = 0; k < model_->nuisances(); ++k) {
            const Parameter& parameter = model_->parameters()[static_cast<std::size_t>(k)];
            d_.nuisances.push_back({parameter.name, parameter.start, baseline_.values[k], errors[k]});
            const auto& best = d_.decision.best;
            if (best && !d_.decision.causes.empty() && best->values.size() > 0)
                d_.nuisances.back().extended = best->values[k];
            const auto of = static_cast<std::size_t>(parameter.nuisance);
            d_.nuisances.back().in_scene = parameter.record < 0 && !measurement_.nuisances[of].key.empty();
            const double away = std::abs(d_.nuisances.back().extended.value_or(baseline_.values[k]) - parameter.start);
            if (parameter.spread > 0 && away > far_away * parameter.spread)
                d_.warnings.push_back(
                    {.file = measurement_.file.string(),
                     .key = warning_key::far_off,
                     .what = fmt::format(
                         "{} had to go from {:.4g} to {:.4g}, {:.1f} times its spread away from what was known "
                         "beforehand",
                         parameter.name, parameter.start, d_.nuisances.back().extended.value_or(baseline_.values[k]),
                         away / parameter.spread),
                     .fix = "state a larger spread, or find out what moved it: it counts as innocent here"});
        }
        d_.chi_square = baseline_.chi_square;
        d_.readings = static_cast<int>(model_->rows().size());
        return {};
    }

    /// What a sure name explains is no slip.
    void take_slips_back() {
        if (!names(d_.decision) || !d_.decision.sure)
            return;
        const auto slipped_record = [](const Problem& warning) { return is_of_record(warning.key); };
        const auto first_of_noise = d_.warnings.begin() + static_cast<std::ptrdiff_t>(doubts_);
        doubts_ -= static_cast<std::size_t>(std::count_if(d_.warnings.begin(), first_of_noise, slipped_record));
        std::erase_if(d_.warnings, slipped_record);
    }

    /// A reason that is no effect and leaves only noise comes first, and makes a name unsure unless that is likelier.
    void doubt_by_a_plain_reason() {
        Decision& decision = d_.decision;
        const bool is_friction = // the cause, and every contact's friction with it
            std::any_of(decision.causes.begin(), decision.causes.end(),
                        [this](int k) { return d_.causes[static_cast<std::size_t>(k)].id == "fric.factor"; });
        if (is_friction)
            return;
        const auto reason = plain_reason({.scene = scene_,
                                          .records = model_->records(),
                                          .nuisances = measurement_.nuisances,
                                          .simulate = simulate_,
                                          .settings = measurement_.settings,
                                          .noise = noise_},
                                         plain_effort_);
        if (!reason || (names(decision) &&
                        nats_between(d_.evidence, decision.best->gain, baseline_.chi_square - reason->chi_square) >=
                            measurement_.settings.margin))
            return;
        if (names(decision)) {
            decision.sure = false;
            decision.reason = reason->what + " only noise is left, too";
        }
        std::string what = reason->what;
        what[0] = 'W'; // "with ..."
        decision.remedy = fmt::format("{} only noise is left: first {}.", what, reason->fix);
    }

    Problems measure_gain() {
        const Decision& decision = d_.decision;
        VectorXd baseline = model_->start();
        baseline.head(model_->nuisances()) = baseline_.values.head(model_->nuisances());
        const auto& named = decision.best->causes;
        if (std::any_of(named.begin(), named.end(),
                        [this](int k) { return d_.causes[static_cast<std::size_t>(k)].physical(); }))
            d_.extended = scene_with_causes(decision.best->values);
        if (aside_.empty()) {
            std::vector<Score> scores;
            for (const Fold& fold : decision.folds)
                scores.push_back(fold.score);
            if (!scores.empty())
                d_.gain = gain_of(std::move(scores), false);
            return {};
        }
        auto aside = Model::make(scene_, aside_, measurement_.nuisances, d_.causes, simulate_);
        if (!aside)
            return aside.problems();
        auto ranges = model_->ranges_at(decision.best->values);
        if (!ranges)
            return ranges.problems();
        aside->share_sensors(std::move(*ranges));
        Noise noise = first_noise(*aside);
        noise.of = noise_.of;
        for (std::size_t r = 0; r < noise.sigma.size(); ++r)
            for (std::size_t c = 0; c < noise.sigma[r].size(); ++c)
                if (const Channel& channel = aside->records()[r].channels[c]; channel.sigma == 0)
                    noise.sigma[r][c] = scatter_used_for(channel.measure, noise.sigma[r][c]);
                else
                    noise.sigma[r][c] *= noise.of[channel.measure].ratio * d_.noise.widened;
        auto scores = scores_aside(*aside, *model_, noise, baseline, decision.best->values);
        if (!scores)
            return scores.problems();
        d_.gain = gain_of(std::move(*scores), true);
        return {};
    }

    /// What the fit found for another channel of this measure; `otherwise` where there is none.
    [[nodiscard]] double scatter_used_for(const std::string& measure, double otherwise) const {
        for (std::size_t r = 0; r < noise_.sigma.size(); ++r)
            for (std::size_t c = 0; c < noise_.sigma[r].size(); ++c)
                if (model_->records()[r].channels[c].measure == measure)
                    return noise_.sigma[r][c];
        return otherwise;
    }

    /// The scene as it is written, with the causes named and the nuisances that fit them.
    [[nodiscard]] std::optional<scene::Scene> scene_with_causes(const VectorXd& values) const {
        auto scene = model_->scene_at(values, -1);
        return scene ? std::optional(std::move(*scene)) : std::nullopt;
    }

    void propose() {
        const Decision& decision = d_.decision;
        std::vector<Rival> rivals;
        for (const std::vector<int>& causes : rivals_in(decision)) {
            Rival rival{causes, VectorXd()};
            const auto& seen = decision.seen[static_cast<std::size_t>(causes[0])];
            if (causes.size() == 1)
                rival.amplitudes = seen.refit && seen.refit->amplitude.size()
                                       ? seen.refit->amplitude
                                       : VectorXd(VectorXd::Constant(1, seen.amplitude));
            else
                rival.amplitudes = refit_of(causes, *model_, noise_, baseline_, effects_).amplitude;
            rivals.push_back(std::move(rival));
        }
        if (rivals.size() > 1)
            d_.proposals = proposals_for(scene_, *model_, measurement_.nuisances, noise_, simulate_, baseline_.values,
                                         rivals, d_.warnings);
    }

    const SceneText& scene_;
    const Measurement& measurement_;
    const Simulate& simulate_;
    const TellStage& tell_;
    Diagnosis d_;
    std::vector<Record> aside_;
    Model* model_ = nullptr;
    Effort plain_effort_;
    Noise noise_;
    Fit baseline_;
    MatrixXd effects_;
    Directions directions_;
    std::size_t doubts_ = 0; // warnings before those of the noise
};

} // namespace

Result<Diagnosis> diagnose(const SceneText& scene, const Measurement& measurement, const Simulate& simulate, bool plan,
                           const TellStage& tell) {
    return Diagnosing(scene, measurement, simulate, tell).run(plan);
}

} // namespace tumble::diagnose
