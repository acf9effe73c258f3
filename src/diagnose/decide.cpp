#include "diagnose/decide.h"

#include "diagnose/folds.h"

#include <Eigen/QR>
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tumble::diagnose {

namespace {

constexpr double least_share = 0.005;    // of an effect that nuisances must leave: less is rounding of the slopes
constexpr double missed_by_slopes = 0.1; // of a fall of chi-square, at most: seen, 2 % at 49 standard errors
constexpr double missed_if_astray = 0.9; // the same, of slopes about a baseline that went astray: seen, 52 %
constexpr double pair_gate_extra = 2;    // chi-square a pair must reach beyond the gate
constexpr double pair_adequacy = 0.05;   // a pair explains more by chance, so it must fit better
constexpr std::size_t most_pairs_fitted = 6;

class Deciding {
public:
    Deciding(const Evidence& evidence, const Settings& settings, const Refitter& refit)
        : e_(evidence), settings_(settings), refit_(refit), count_(static_cast<int>(evidence.causes.size())) {}

    Decision run() {
        screen();
        d_.baseline = adequacy_of(e_.residual, e_.nuisances, e_.directions, e_.degrees);
        if (std::none_of(d_.seen.begin(), d_.seen.end(), [](const Seen& seen) { return seen.visible; })) {
            if (e_.nuisances.cols() == 0 && d_.baseline.p() <= settings_.alpha_adequacy) {
                d_.outcome = Outcome::none_known; // nothing was adjusted that could hide what is wrong
                return d_;
            }
            return cannot("no cause of the library would show in these data, whatever nuisances are adjusted: "
                          "measure under more conditions, or more than one number for each");
        }
        for (int k = 0; k < count_; ++k)
            d_.largest = std::max(d_.largest, one(k).gain);
        const bool adequate = d_.baseline.p() > settings_.alpha_adequacy;
        if (d_.largest >= d_.gate || !adequate)
            fit_rivals(d_.largest < d_.gate); // all, where something is there that no slope points to: it may bend
        if (!stays_over_the_gate() && adequate) {
            d_.outcome = Outcome::consistent; // or by slopes alone it went over
            return d_;
        }
        int winner = best_possible();
        if (!suffices(winner) && is_astray()) {
            fit_rivals(true);
            winner = best_possible();
        }
        if (suffices(winner))
            name(winner);
        else if (!name_unended())
            try_pairs(winner);
        return d_;
    }

private:
    /// Standard errors, of a one-sided limit of 95 %.
    [[nodiscard]] double limit() const { return student_quantile(0.05, e_.degrees); }
    Seen& one(int k) { return d_.seen[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const Cause& cause(int k) const { return e_.causes[static_cast<std::size_t>(k)]; }

    Decision cannot(std::string why) {
        d_.outcome = Outcome::cannot_decide;
        d_.reason = std::move(why);
        return d_;
    }

    /// Every cause by its slope alone, and how much of each the others would leave.
    void screen() {
        const Projector nuisances(e_.nuisances);
        const VectorXd residual = nuisances.out(e_.residual);
        effects_ = nuisances.out(e_.effects);
        d_.seen.resize(static_cast<std::size_t>(count_));
        std::vector<int> visible;
        const double one_sided = limit();
        for (int k = 0; k < count_; ++k) {
            Seen& seen = one(k);
            const double length = effects_.col(k).norm();
            const double whole = e_.effects.col(k).norm();
            seen.share = whole > 0 ? std::max(DBL_MIN, std::min(length, left_by_one_nuisance(k)) / whole)
                                   : 0; // 0: it does nothing
            const double reach = std::max(std::abs(cause(k).lo), std::abs(cause(k).hi));
            seen.visible = seen.share > least_share && length * reach > least_visible;
            if (!seen.visible)
                continue;
            visible.push_back(k);
            const double z = effects_.col(k).dot(residual) / length;
            seen.amplitude = z / length;
            seen.error = 1 / length;
            seen.gain = plausible_sign(k, z) ? z * z : 0;
            seen.lower = seen.amplitude - one_sided * seen.error;
            // Of an effect that cannot be negative, data that ask for less than none exclude no more than none would.
            seen.upper = (cause(k).lo == 0 ? std::max(0.0, seen.amplitude) : seen.amplitude) + one_sided * seen.error;
        }
        isolate(visible);
    }

    /// A cause that one nuisance takes over by itself, or its copies for each record do, is that nuisance: the
    /// measurement calls it innocent, however far it has to go. What is known of it beforehand says nothing then.
    [[nodiscard]] double left_by_one_nuisance(int k) const {
        const auto readings = std::count_if(e_.directions.condition.begin(), e_.directions.condition.end(),
                                            [](int condition) { return condition >= 0; });
        const VectorXd effect = e_.effects.col(k).head(readings);
        double least = effect.norm();
        for (Eigen::Index first = 0, next = 0; first < e_.nuisances.cols(); first = next) {
            while (next < e_.nuisances.cols() && of_nuisance(next) == of_nuisance(first))
                ++next;
            const Projector one(e_.nuisances.block(0, first, readings, next - first));
            least = std::min(least, one.out(effect).norm());
        }
        return least;
    }

    [[nodiscard]] int of_nuisance(Eigen::Index column) const {
        return e_.nuisance.empty() ? static_cast<int>(column) : e_.nuisance[static_cast<std::size_t>(column)];
    }

    /// Signs of the amplitude that are plausible.
    [[nodiscard]] Side side_of(int k) const {
        if (cause(k).lo < 0)
            return cause(k).hi > 0 ? Side::both : Side::below;
        return Side::above;
    }

    [[nodiscard]] bool plausible_sign(int k, double z) const {
        return side_of(k) == Side::both || side_of(k) == (z < 0 ? Side::below : Side::above);
    }

    void isolate(const std::vector<int>& visible) {
        d_.isolability = MatrixXd::Constant(count_, count_, std::nan(""));
        const auto size = static_cast<Eigen::Index>(visible.size());
        MatrixXd correlation = MatrixXd::Identity(size, size);
        for (Eigen::Index a = 0; a < size; ++a)
            for (Eigen::Index b = 0; b < size; ++b) {
                const int i = visible[static_cast<std::size_t>(a)], j = visible[static_cast<std::size_t>(b)];
                const double cosine =
                    effects_.col(i).dot(effects_.col(j)) / (effects_.col(i).norm() * effects_.col(j).norm());
                correlation(a, b) = a == b ? 1 : cosine;
                d_.isolability(i, j) = a == b ? 0 : std::sqrt(std::max(0.0, 1 - cosine * cosine));
            }
        std::vector<Side> sides;
        for (const int k : visible)
            sides.push_back(side_of(k));
        if (size > 0)
            d_.gate =
                e_.gate > 0 ? e_.gate : quantile_of_largest(correlation, sides, settings_.alpha_gate, 1, e_.degrees);
    }

    /// How far behind the best by slopes a rival may lie and still win: what slopes miss grows with the effect.
    [[nodiscard]] double within_reach(double largest) const {
        const double missed = is_astray() ? missed_if_astray : missed_by_slopes;
        return std::max(2 * settings_.rival_window, missed * largest);
    }

    [[nodiscard]] bool is_astray() const { return e_.coarse || astray(e_.residual.squaredNorm(), e_.residual.size()); }

    /// It explains more than chance does, and leaves nothing but noise.
    bool suffices(int winner) {
        if (winner < 0 || one(winner).gain < d_.gate)
            return false;
        d_.best = one(winner).refit;
        d_.winner = adequacy_of(d_.best->residual, d_.best->slopes, e_.directions, e_.degrees);
        return d_.winner.p() > settings_.alpha_adequacy;
    }

    void fit_rivals(bool all) {
        const double enough = d_.largest - within_reach(d_.largest);
        for (int k = 0; k < count_; ++k)
            if (one(k).visible && !one(k).refit && (all || (one(k).gain > 0 && one(k).gain >= enough))) {
                one(k).refit = refit_({k});
                one(k).gain = one(k).refit->possible ? one(k).refit->gain : 0;
            }
    }

    /// Some cause, fitted anew, still explains as much as chance hardly ever does.
    bool stays_over_the_gate() {
        d_.largest = 0;
        for (const Seen& seen : d_.seen)
            d_.largest = std::max(d_.largest, seen.refit ? seen.refit->gain : seen.gain);
        return d_.largest >= d_.gate;
    }

    int best_possible() {
        int best = -1;
        for (int k = 0; k < count_; ++k)
            if (one(k).refit && one(k).refit->possible && (best < 0 || one(k).gain > one(best).gain))
                best = k;
        return best;
    }

    /// The winner and whoever is within the margin of it; also a twin by its slope whose fit did not end.
    void name(int winner) {
        d_.causes = {winner};
        bool alike = true;
        for (int k = 0; k < count_; ++k) {
            if (k == winner || !one(k).refit || reached(k) == 0 ||
                nats_between(e_, one(winner).gain, reached(k)) >= settings_.margin)
                continue;
            const bool twin = d_.isolability(winner, k) < settings_.same_class;
            if (one(k).refit->possible || (twin && !one(k).refit->at_end)) {
                d_.causes.push_back(k);
                alike = alike && same_answer(winner, k);
            } else if (twin) {
                d_.beyond.push_back(k);
            }
        }
        d_.one_class = alike && d_.causes.size() > 1;
        d_.outcome = alike ? Outcome::named : Outcome::ambiguous;
        d_.folds = folds_of(e_, *d_.best);
        if (d_.outcome == Outcome::named) {
            bound_second();
            veto();
        }
    }

    /// Where no fit that ended suffices, the one that came farthest may: what it lacks would only better it. Its
    /// amplitude is not known well, so the name is not sure.
    bool name_unended() {
        int open = -1;
        for (int k = 0; k < count_; ++k)
            if (one(k).refit && !one(k).refit->possible && !one(k).refit->at_end &&
                (open < 0 || reached(k) > reached(open)))
                open = k;
        if (open < 0 || reached(open) == 0)
            return false;
        one(open).gain = reached(open);
        if (!suffices(open)) {
            one(open).gain = 0;
            return false;
        }
        name(open);
        if (d_.outcome == Outcome::named && d_.sure)
            doubt("its fit did not end", "Let the scene begin nearer to what is known of its nuisances.");
        return true;
    }

    void doubt(std::string reason, std::string remedy) {
        d_.sure = false;
        d_.reason = std::move(reason);
        d_.remedy = std::move(remedy);
    }

    /// By their slopes, or by what each leaves once it is fitted: slopes about a baseline that went astray say little.
    bool same_answer(int i, int k) {
        const Refit &one_fit = *one(i).refit, &other = *one(k).refit;
        return d_.isolability(i, k) < settings_.same_class ||
               (one_fit.residual.size() == other.residual.size() &&
                (one_fit.residual - other.residual).norm() < settings_.same_class * std::sqrt(one_fit.gain));
    }

    void veto() {
        if (d_.folds.empty())
            return doubt("there is only one condition, so nothing was tried on one that it was not fitted to",
                         "Measure under a second condition, best a very different one.");
        if (d_.outcome == Outcome::named)
            for (int k = 0; k < count_; ++k)
                if (one(k).refit && !one(k).refit->possible && reached(k) > 0 &&
                    !(d_.isolability(d_.best->causes[0], k) < settings_.same_class) &&
                    nats_between(e_, d_.best->gain, reached(k)) < settings_.margin) {
                    if (one(k).refit->at_end)
                        doubt(fmt::format("{} would explain it as well, at the end of its range ({:.3g}) or beyond",
                                          cause(k).id, one(k).refit->amplitude[0]),
                              "Find out whether that can be. If not, leave it out of the causes that are considered.");
                    else
                        doubt(fmt::format("{} explains it as well as far as its fit came, which did not end",
                                          cause(k).id),
                              "Let the scene begin nearer to what is known of its nuisances, or leave that cause out "
                              "if it cannot be.");
                }
        if (d_.outcome == Outcome::two_causes && pairs_left_)
            doubt("there are more pairs that may explain it than were fitted",
                  "Name the families that can be at work (causes), or measure under more conditions.");
        double better = 0;
        for (const Fold& fold : d_.folds) {
            better += fold.score.nats();
            if (std::abs(fold.moved) > settings_.fold_veto)
                doubt(fmt::format("the amplitude of {} moves by {:.1f} standard errors when {} is left out",
                                  cause(fold.mover).id, std::abs(fold.moved), fold.score.condition),
                      "Repeat the condition that disagrees before you believe the name.");
        }
        if (better <= 0)
            doubt("it does not improve the prediction of conditions that are left out",
                  "Measure under more conditions before you believe the name.");
    }

    /// Two causes at once, all pairs; each must carry its weight, and the pair must leave nothing but noise.
    void try_pairs(int proxy) {
        d_.best.reset();
        if (proxy >= 0 && one(proxy).gain >= d_.gate)
            d_.best = one(proxy).refit;
        std::vector<Refit> fitted;
        for (const auto& [i, j] : likely_pairs()) {
            Refit pair = refit_({i, j});
            if (pair.possible && carries_weight(pair))
                fitted.push_back(std::move(pair));
        }
        if (const int single = best_possible(); single != proxy && suffices(single)) {
            fit_rivals(true); // slopes had it far behind, and as one of a pair it was fitted: they say nothing here
            if (const int best = best_possible(); suffices(best)) {
                name(best);
                return;
            }
        }
        std::sort(fitted.begin(), fitted.end(), [](const Refit& a, const Refit& b) { return a.gain > b.gain; });
        d_.outcome = Outcome::none_known;
        if (fitted.empty() || fitted[0].gain < d_.gate + pair_gate_extra)
            return;
        const Adequacy rest = adequacy_of(fitted[0].residual, fitted[0].slopes, e_.directions, e_.degrees);
        if (rest.p() <= pair_adequacy)
            return;
        d_.winner = rest;
        for (const Refit& pair : fitted)
            if (nats_between(e_, fitted[0].gain, pair.gain) < settings_.margin)
                d_.pairs.push_back(pair.causes);
        d_.outcome = d_.pairs.size() == 1 ? Outcome::two_causes : Outcome::ambiguous;
        d_.causes = fitted[0].causes;
        d_.best = fitted[0];
        if (d_.outcome == Outcome::two_causes) {
            d_.folds = folds_of(e_, *d_.best);
            veto();
        }
    }

    /// What a pair would explain by the slope of one beside the other, which is the best that was fitted; 0 of others.
    double beside_best(int i, int j) {
        if (!d_.best || d_.best->causes.size() != 1 || (d_.best->causes[0] != i && d_.best->causes[0] != j))
            return 0;
        const int other = d_.best->causes[0] == i ? j : i;
        const VectorXd left = Projector(d_.best->slopes).out(VectorXd(e_.effects.col(other)));
        const double z = left.dot(d_.best->residual) / std::max(left.norm(), 1e-300);
        return d_.best->gain + (plausible_sign(other, z) ? z * z : 0);
    }

    /// What a pair would explain by slopes; where one of the two would have the wrong sign, what the other does alone.
    double by_slopes(int i, int j) {
        const Refit pair = refit_linear(e_, {i, j});
        if (is_astray() || (plausible_sign(i, pair.amplitude[0]) && plausible_sign(j, pair.amplitude[1])))
            return pair.gain;
        return std::max(one(i).gain, one(j).gain);
    }

    [[nodiscard]] std::vector<std::pair<int, int>> likely_pairs() {
        std::vector<std::pair<double, std::pair<int, int>>> all;
        for (int i = 0; i < count_; ++i)
            for (int j = i + 1; j < count_; ++j)
                if (one(i).visible && one(j).visible && d_.isolability(i, j) > settings_.same_class)
                    all.push_back({std::max(by_slopes(i, j), beside_best(i, j)), {i, j}});
        std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<std::pair<int, int>> likely;
        for (const auto& [gain, pair] : all) {
            const bool rival = nats_between(e_, all[0].first, gain) < settings_.margin;
            if (likely.size() < most_pairs_fitted && gain > all[0].first - within_reach(all[0].first))
                likely.push_back(pair);
            else
                pairs_left_ = pairs_left_ || rival;
        }
        return likely;
    }

    /// The backward check: either member alone must be worse by more than half the gate.
    bool carries_weight(const Refit& pair) {
        for (const int k : pair.causes) {
            if (!one(k).refit) {
                one(k).refit = refit_({k});
                one(k).gain = one(k).refit->possible ? one(k).refit->gain : 0;
            }
            if (pair.gain - reached(k) <= d_.gate / 2)
                return false;
        }
        return true;
    }

    /// What a cause explains at least: what its fit reached, though it may not have ended, or ended at its range's end.
    double reached(int k) { return one(k).refit ? std::max(0.0, one(k).refit->gain) : one(k).gain; }

    /// How much of another cause the named one may hide beside it.
    void bound_second() {
        const Projector fitted(d_.best->slopes);
        for (int k = 0; k < count_; ++k) {
            const VectorXd left = fitted.out(VectorXd(e_.effects.col(k)));
            const bool shows = one(k).visible && left.norm() > settings_.same_class * effects_.col(k).norm();
            if (std::find(d_.causes.begin(), d_.causes.end(), k) != d_.causes.end() || !shows)
                continue;
            const double z = left.dot(d_.best->residual) / left.norm();
            const double most = limit() + (cause(k).lo < 0 ? std::abs(z) : std::max(0.0, z));
            if (most > d_.second)
                d_.second = most, d_.second_cause = k;
        }
    }

    const Evidence& e_;
    const Settings& settings_;
    const Refitter& refit_;
    int count_;
    MatrixXd effects_;        // what nuisances leave of them
    bool pairs_left_ = false; // within the margin of the best by slopes, and not fitted
    Decision d_;
};

} // namespace

Refit refit_linear(const Evidence& evidence, const std::vector<int>& causes) {
    Refit refit;
    refit.causes = causes;
    const Eigen::Index nuisances = evidence.nuisances.cols();
    const auto count = static_cast<Eigen::Index>(causes.size());
    refit.slopes.resize(evidence.residual.size(), nuisances + count);
    refit.slopes.leftCols(nuisances) = evidence.nuisances;
    for (Eigen::Index k = 0; k < count; ++k)
        refit.slopes.col(nuisances + k) = evidence.effects.col(causes[static_cast<std::size_t>(k)]);
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(refit.slopes);
    const VectorXd step = qr.solve(evidence.residual);
    refit.residual = evidence.residual - refit.slopes * step;
    refit.amplitude = step.tail(count);
    refit.error = errors_of(refit.slopes).tail(count);
    const Projector baseline(evidence.nuisances);
    refit.gain = baseline.out(evidence.residual).squaredNorm() - refit.residual.squaredNorm();
    refit.possible = true;
    for (Eigen::Index k = 0; k < count; ++k) {
        const Cause& cause = evidence.causes[static_cast<std::size_t>(causes[static_cast<std::size_t>(k)])];
        if (refit.amplitude[k] < cause.lo || refit.amplitude[k] > cause.hi) {
            refit.possible = false;
            refit.refused = "implausible amplitude or sign of " + cause.id;
        }
    }
    return refit;
}

double nats_between(const Evidence& evidence, double better, double worse) {
    if (std::isinf(evidence.degrees))
        return 0.5 * (better - worse);
    const double n = evidence.degrees, whole = evidence.residual.squaredNorm();
    return 0.5 * (n + 1) * std::log((n + whole - worse) / (n + whole - better));
}

double gain_behind(const Evidence& evidence, double best, double nats) {
    if (std::isinf(evidence.degrees))
        return best - 2 * nats;
    const double n = evidence.degrees, whole = evidence.residual.squaredNorm();
    return n + whole - (n + whole - best) * std::exp(2 * nats / (n + 1));
}

Decision decide(const Evidence& evidence, const Settings& settings, const Refitter& refit) {
    return Deciding(evidence, settings, refit).run();
}

} // namespace tumble::diagnose
