#include "diagnose/misread.h"

#include "diagnose/noise.h"
#include "diagnose/warning_key.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double baseline_misses = 5; // scatters, root mean square over a record
constexpr double twice = 2;           // what is left without the slip, of the root mean square
constexpr double no_repeats = 30;     // scatters, root mean square, between series of one set
constexpr double share_apart = 0.1;   // of what the readings span
constexpr double hundredth = 0.01;    // of what the scene lasts

/// A record that is over before the scene has begun in earnest.
std::optional<Problem> too_short(const Record& record, double scene_lasts) {
    const double lasts = record.time.back() - record.time.front();
    if (record.single() || lasts > hundredth * scene_lasts)
        return std::nullopt;
    return Problem{.file = record.file.string(),
                   .key = warning_key::too_short,
                   .what = fmt::format("'{}' lasts {:g} s, a {:.0f}th of the scene, {:g} s: seconds under a head that "
                                       "says milliseconds?",
                                       record.name, lasts, scene_lasts / lasts, scene_lasts),
                   .fix = "correct the unit of time"};
}

} // namespace

std::vector<Misread> forgotten_sets(const std::vector<Record>& records) {
    std::vector<Misread> misread;
    for (std::size_t r = 1; r < records.size(); ++r) {
        const Record& record = records[r];
        const auto first =
            std::find_if(records.begin(), records.end(), [&](const Record& one) { return one.sets == record.sets; });
        if (record.single() || first->single() || &*first == &record ||
            first->channels.size() != record.channels.size())
            continue;
        for (std::size_t c = 0; c < record.channels.size(); ++c) {
            const Channel &one = first->channels[c], &other = record.channels[c];
            if (one.measure != other.measure || one.sensor != other.sensor || one.shows_time())
                continue;
            const Signal signal{first->time, one.value};
            double squares = 0, count = 0;
            for (std::size_t k = 0; k < record.time.size(); ++k)
                if (record.time[k] >= first->time.front() && record.time[k] <= first->time.back()) {
                    const double apart = other.value[k] - signal.at(record.time[k]);
                    squares += apart * apart;
                    ++count;
                }
            const double apart = std::sqrt(squares / std::max(1.0, count));
            const auto [low, high] = std::minmax_element(other.value.begin(), other.value.end());
            const double scatter = std::max(scatter_of(other), other.sigma);
            if (apart < no_repeats * scatter || apart < share_apart * (*high - *low))
                continue;
            misread.push_back(
                {{r},
                 {.file = record.file.string(),
                  .key = warning_key::forgotten_set,
                  .what = fmt::format("'{}' has the same set as '{}', and its {} differs from it by {:.0f} times its "
                                      "scatter: was a set forgotten?",
                                      record.name, first->name, other.head, apart / scatter),
                  .fix = "set what differs between the two, or adjust it as a nuisance"}});
            break;
        }
    }
    return misread;
}

std::vector<Misread> misread_in(Model& model, const Noise& noise, const VectorXd& predicted, Problems& warnings) {
    const std::vector<Record>& records = model.records();
    const VectorXd start = model.start();
    std::vector<Misread> misread = exchanged_numbers(records, predicted, noise.sigma);
    const bool each_its_own = std::any_of(model.parameters().begin(), model.parameters().end(),
                                          [](const Parameter& one) { return one.record >= 0 && !one.exact; });
    if (!each_its_own)
        for (Misread& forgotten : forgotten_sets(records))
            misread.push_back(std::move(forgotten));
    std::vector<Simulated> simulated;
    for (std::size_t r = 0; r < records.size(); ++r) {
        if (const auto scene = model.scene_at(start, static_cast<int>(r)))
            if (auto slip = too_short(records[r], scene->duration))
                misread.push_back({{r}, std::move(*slip)});
        if (auto truth = model.signals(start, static_cast<int>(r)))
            simulated.push_back({std::move(*truth), noise.sigma[r]});
    }
    if (simulated.size() != records.size())
        return misread;
    for (std::size_t r = 0; r < records.size(); ++r)
        if (auto held = held_readings(records[r], simulated[r]))
            warnings.push_back(std::move(*held));
    for (Misread& slip : record_slips(records, simulated))
        misread.push_back(std::move(slip));
    return misread;
}

Problems standing(const std::vector<Misread>& misread, const Fit& baseline, const Model& model) {
    std::vector<double> squares(model.records().size(), 0), readings(model.records().size(), 0);
    for (std::size_t k = 0; k < model.rows().size(); ++k) {
        const auto record = static_cast<std::size_t>(model.rows()[k].record);
        const double missed = baseline.residual[static_cast<Eigen::Index>(k)];
        squares[record] += missed * missed;
        ++readings[record];
    }
    std::vector<Misread> sorted = misread;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Misread& a, const Misread& b) { return a.times > b.times; });
    Problems problems;
    for (const Misread& one : sorted)
        if (std::all_of(one.records.begin(), one.records.end(), [&](std::size_t r) {
                return squares[r] > readings[r] * std::max(baseline_misses * baseline_misses, twice * twice * one.left);
            }))
            problems.push_back(one.problem);
    return problems;
}

} // namespace tumble::diagnose
