#include "diagnose/gain.h"

#include "base/rng.h"
#include "diagnose/folds.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

constexpr int bootstraps = 2000;
constexpr std::size_t enough_conditions = 5;
constexpr double untouched = 0.05; // nats: a condition where the cause does nothing decides nothing
constexpr double least_nats = 3;   // a ratio of predictive densities, which chance reaches in exp(-3) = 5 % at most

void bootstrap(Gain& gain) {
    Rng rng(1);
    std::vector<double> sums;
    const auto count = static_cast<double>(gain.scores.size());
    for (int k = 0; k < bootstraps; ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < gain.scores.size(); ++i)
            sum += gain.scores[static_cast<std::size_t>(rng.uniform() * count)].nats();
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

/// Of every record how far it lies from the prediction at its best own nuisances, and the logarithm of what its
/// readings tell of them.
Result<std::vector<Foretold>> records_at(Model& aside, const Noise& noise, VectorXd values) {
    std::vector<int> own;
    for (int k = 0; k < aside.nuisances(); ++k)
        if (aside.parameters()[static_cast<std::size_t>(k)].record >= 0)
            own.push_back(k);
    const auto fitted = fit(aside, noise, values, own);
    if (!fitted)
        return fitted.problems();
    std::vector<Foretold> records(aside.records().size());
    for (std::size_t row = 0; row < aside.rows().size(); ++row) {
        const double missed = fitted->residual[static_cast<Eigen::Index>(row)];
        records[static_cast<std::size_t>(aside.rows()[row].record)].chi_square += missed * missed;
    }
    for (std::size_t r = 0; r < records.size(); ++r) {
        std::vector<Eigen::Index> of_record;
        for (std::size_t k = 0; k < own.size(); ++k) {
            const Parameter& parameter = aside.parameters()[static_cast<std::size_t>(own[k])];
            if (parameter.record != static_cast<int>(r))
                continue;
            of_record.push_back(static_cast<Eigen::Index>(k));
            if (parameter.spread > 0)
                records[r].chi_square += std::pow((fitted->values[own[k]] - parameter.start) / parameter.spread, 2);
        }
        if (of_record.empty())
            continue;
        const MatrixXd slopes = fitted->slopes(Eigen::all, of_record);
        records[r].spread = (slopes.transpose() * slopes).ldlt().vectorD().array().abs().max(1e-300).log().sum();
    }
    return records;
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
        gain.nats += score.nats();
        if (std::abs(score.nats()) > untouched)
            all_better = all_better && score.nats() > 0;
    }
    if (readings == 0)
        return gain;
    gain.rms_baseline = std::sqrt(baseline / readings);
    gain.rms_extended = std::sqrt(extended / readings);
    gain.skill = 1 - extended / baseline;
    gain.share_removed = baseline > readings ? (baseline - extended) / (baseline - readings) : 0;
    if (gain.scores.size() >= enough_conditions)
        bootstrap(gain);
    gain.shown = gain.bootstrapped ? gain.nats_low > 0 : all_better && gain.nats > least_nats;
    return gain;
}

Result<std::vector<Score>> scores_aside(Model& aside, const Model& model, const Noise& noise, const VectorXd& baseline,
                                        const VectorXd& extended) {
    const auto without = records_at(aside, noise, carried_over(aside, model, baseline));
    if (!without)
        return without.problems();
    const auto with = records_at(aside, noise, carried_over(aside, model, extended));
    if (!with)
        return with.problems();
    std::vector<Score> scores;
    for (std::size_t r = 0; r < aside.records().size(); ++r) {
        const Record& record = aside.records()[r];
        auto same = std::find_if(scores.begin(), scores.end(),
                                 [&](const Score& one) { return one.condition == record.condition; });
        if (same == scores.end())
            same = scores.insert(scores.end(), Score{.condition = record.condition});
        same->readings += static_cast<int>(record.time.size() * record.channels.size());
        same->baseline += (*without)[r].chi_square;
        same->extended += (*with)[r].chi_square;
        same->spread += (*with)[r].spread - (*without)[r].spread;
    }
    return scores;
}

} // namespace tumble::diagnose
