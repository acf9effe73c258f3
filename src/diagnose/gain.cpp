#include "diagnose/gain.h"

#include "base/rng.h"

#include <cmath>

namespace tumble::diagnose {

namespace {

constexpr int bootstraps = 2000;
constexpr std::size_t enough_conditions = 5;

double improvement(const Score& score) {
    return 0.5 * (score.baseline - score.extended);
}

void bootstrap(Gain& gain) {
    Rng rng(1);
    std::vector<double> sums;
    const auto count = static_cast<double>(gain.scores.size());
    for (int k = 0; k < bootstraps; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < gain.scores.size(); ++i)
            sum += improvement(gain.scores[static_cast<std::size_t>(rng.uniform() * count)]);
        sums.push_back(sum);
    }
    std::sort(sums.begin(), sums.end());
    gain.nats_low = sums[bootstraps / 40];
    gain.nats_high = sums[bootstraps - 1 - bootstraps / 40];
    gain.bootstrapped = true;
}

/// Parameters of `aside` that `model` has under the same name take its values.
VectorXd carried_over(const Model& aside, const Model& model, const VectorXd& values) {
    VectorXd carried = aside.start();
    for (std::size_t k = 0; k < aside.parameters().size(); ++k)
        for (std::size_t i = 0; i < model.parameters().size(); ++i)
            if (model.parameters()[i].name == aside.parameters()[k].name)
                carried[static_cast<Eigen::Index>(k)] = values[static_cast<Eigen::Index>(i)];
    return carried;
}

/// Chi-square beyond the first part of every record, by condition, once its own nuisances are fitted to that part.
Result<std::vector<double>> late_chi_squares(Model& aside, const Noise& noise, VectorXd values) {
    std::vector<int> own;
    for (int k = 0; k < aside.nuisances(); ++k)
        if (aside.parameters()[static_cast<std::size_t>(k)].record >= 0)
            own.push_back(k);
    if (!own.empty()) {
        Noise early = noise;
        for (std::size_t row = 0; row < aside.rows().size(); ++row) {
            const Row& one = aside.rows()[row];
            early.left_out[row] =
                one.time > first_part * aside.records()[static_cast<std::size_t>(one.record)].time.back();
        }
        const auto fitted = fit(aside, early, values, own);
        if (!fitted)
            return fitted.problems();
        values = fitted->values;
    }
    const auto misfit = misfit_of(aside, values);
    if (!misfit)
        return misfit.problems();
    const VectorXd white = noise.whiten(*misfit, aside);
    std::vector<double> sums(aside.records().size(), 0);
    for (std::size_t row = 0; row < aside.rows().size(); ++row) {
        const auto record = static_cast<std::size_t>(aside.rows()[row].record);
        if (aside.rows()[row].time > first_part * aside.records()[record].time.back())
            sums[record] += white[static_cast<Eigen::Index>(row)] * white[static_cast<Eigen::Index>(row)];
    }
    return sums;
}

} // namespace

Gain gain_of(std::vector<Score> scores, bool held_out) {
    Gain gain;
    gain.held_out = held_out;
    gain.scores = std::move(scores);
    double baseline = 0, extended = 0, readings = 0;
    bool all_better = !gain.scores.empty();
    for (const Score& score : gain.scores) {
        baseline += score.baseline;
        extended += score.extended;
        readings += score.readings;
        all_better = all_better && improvement(score) > 0;
    }
    if (readings == 0)
        return gain;
    gain.rms_baseline = std::sqrt(baseline / readings);
    gain.rms_extended = std::sqrt(extended / readings);
    gain.skill = 1 - extended / baseline;
    gain.share_removed = baseline > readings ? (baseline - extended) / (baseline - readings) : 0;
    gain.nats = 0.5 * (baseline - extended);
    if (gain.scores.size() >= enough_conditions)
        bootstrap(gain);
    gain.shown = gain.bootstrapped ? gain.nats_low > 0 : all_better;
    return gain;
}

Result<std::vector<Score>> scores_aside(Model& aside, const Model& model, const Noise& noise, const VectorXd& baseline,
                                        const VectorXd& extended) {
    const auto without = late_chi_squares(aside, noise, carried_over(aside, model, baseline));
    if (!without)
        return without.problems();
    const auto with = late_chi_squares(aside, noise, carried_over(aside, model, extended));
    if (!with)
        return with.problems();
    std::vector<Score> scores;
    for (std::size_t r = 0; r < aside.records().size(); ++r) {
        const Record& record = aside.records()[r];
        const auto late = std::count_if(record.time.begin(), record.time.end(),
                                        [&](double t) { return t > first_part * record.time.back(); });
        scores.push_back({record.name, static_cast<int>(late) * static_cast<int>(record.channels.size()), (*without)[r],
                          (*with)[r]});
    }
    return scores;
}

} // namespace tumble::diagnose
