#include "diagnose/noise.h"

#include "base/column.h"
#include "diagnose/statistics.h"

#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

constexpr double least_correlation = 0.08;
constexpr double outlier = 6;    // standard deviations
constexpr std::size_t reach = 3; // readings to either side that a reading is held against
constexpr double most_outliers = 0.02;

bool follows(const Model& model, std::size_t row) {
    return row > 0 && model.rows()[row].record == model.rows()[row - 1].record &&
           model.rows()[row].channel == model.rows()[row - 1].channel;
}

/// Second differences of white noise scatter sqrt(6) times as much; the median leaves kinks of the motion aside.
double scatter_of(const Channel& channel) {
    std::vector<double> bends;
    for (std::size_t k = 2; k < channel.value.size(); ++k)
        bends.push_back(std::abs(channel.value[k] - 2 * channel.value[k - 1] + channel.value[k - 2]));
    return std::max(1e-12, median(bends) / 0.6745 / std::sqrt(6.0));
}

/// Readings that lie far from the median of the residual around them, alone or nearly so.
std::vector<bool> lone_outliers(const Model& model, const VectorXd& scaled) {
    const std::size_t rows = model.rows().size();
    std::vector<bool> out(rows, false);
    for (std::size_t k = 0; k < rows; ++k) {
        std::vector<double> around;
        for (std::size_t i = k; i > 0 && i + reach > k && follows(model, i); --i)
            around.push_back(scaled[static_cast<Eigen::Index>(i - 1)]);
        for (std::size_t i = k + 1; i < rows && i <= k + reach && follows(model, i); ++i)
            around.push_back(scaled[static_cast<Eigen::Index>(i)]);
        const double middle = median(around);
        const auto far = [&](double value) { return std::abs(value - middle) > outlier; };
        out[k] = far(scaled[static_cast<Eigen::Index>(k)]) && std::count_if(around.begin(), around.end(), far) <= 1;
    }
    return out;
}

/// Scatter and memory of what is left, of each measure. `taken`: of each row, how much of it was projected out.
std::map<std::string, NoiseOfMeasure> by_measure(const Model& model, const VectorXd& rest, const VectorXd& taken) {
    struct Sums {
        double squares = 0, taken = 0, now = 0, next = 0, rows = 0;
    };
    std::map<std::string, Sums> sums;
    for (std::size_t k = 0; k < model.rows().size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        Sums& one = sums[model.channel_of(model.rows()[k]).measure];
        one.squares += rest[i] * rest[i];
        one.taken += taken[i];
        ++one.rows;
        if (!follows(model, k))
            continue;
        one.next += rest[i] * rest[i - 1];
        one.now += 0.5 * (rest[i] * rest[i] + rest[i - 1] * rest[i - 1]);
    }
    std::map<std::string, NoiseOfMeasure> all;
    for (const auto& [measure, one] :
         sums) // smooth directions taken out leave a correlation of about minus their share
        all[measure] = {std::sqrt(one.squares / std::max(1.0, one.rows - one.taken)),
                        std::min(0.95, one.next / one.now + one.taken / one.rows)};
    return all;
}

} // namespace

MatrixXd Noise::whiten(const MatrixXd& columns, const Model& model, double horizon) const {
    MatrixXd white = MatrixXd::Zero(columns.rows(), columns.cols());
    std::vector<std::vector<double>> memory; // [record][channel]
    for (const Record& record : model.records()) {
        memory.emplace_back();
        for (const Channel& channel : record.channels) {
            const auto known = of.find(channel.measure);
            memory.back().push_back(known == of.end() ? 0 : known->second.correlation);
        }
    }
    for (Eigen::Index k = 0; k < columns.rows(); ++k) {
        const auto row = static_cast<std::size_t>(k);
        const Row& one = model.rows()[row];
        const auto record = static_cast<std::size_t>(one.record);
        if (left_out[row] || one.time > horizon * model.records()[record].time.back())
            continue;
        const double scale = 1 / sigma[record][static_cast<std::size_t>(one.channel)];
        const double correlation = memory[record][static_cast<std::size_t>(one.channel)];
        const double fresh = std::sqrt(1 - correlation * correlation);
        if (correlation != 0 && follows(model, row) && !left_out[row - 1])
            white.row(k) = (columns.row(k) - correlation * columns.row(k - 1)) * scale / fresh;
        else
            white.row(k) = columns.row(k) * scale;
    }
    return white;
}

Noise first_noise(const Model& model) {
    Noise noise;
    for (const Record& record : model.records()) {
        noise.sigma.emplace_back();
        for (const Channel& channel : record.channels)
            noise.sigma.back().push_back(channel.sigma > 0 ? channel.sigma : scatter_of(channel));
    }
    noise.left_out.assign(model.rows().size(), false);
    return noise;
}

Noise refined_noise(const Noise& before, const Model& model, const VectorXd& misfit, const MatrixXd& explained,
                    NoiseReport& report) {
    Noise noise = before;
    noise.of.clear();
    VectorXd scaled = noise.whiten(misfit, model);
    noise.left_out = lone_outliers(model, scaled);
    report.left_out = static_cast<int>(std::count(noise.left_out.begin(), noise.left_out.end(), true));
    if (report.left_out > most_outliers * static_cast<double>(model.rows().size()))
        noise.left_out.assign(model.rows().size(), false);
    for (std::size_t k = 0; k < noise.left_out.size(); ++k)
        if (noise.left_out[k])
            scaled[static_cast<Eigen::Index>(k)] = 0;

    const Projector projector(explained.topRows(scaled.size()));
    report.of = by_measure(model, projector.out(scaled), projector.leverages());
    noise.of = report.of;
    for (auto& [measure, one] : noise.of)
        if (one.correlation <= least_correlation)
            one.correlation = 0;

    double stated = 0, used = 0, counted = 0;
    for (std::size_t r = 0; r < model.records().size(); ++r)
        for (std::size_t c = 0; c < model.records()[r].channels.size(); ++c) {
            noise.sigma[r][c] *= report.of[model.records()[r].channels[c].measure].ratio;
            if (model.records()[r].channels[c].measure != model.records()[0].channels[0].measure)
                continue;
            stated += model.records()[r].channels[c].sigma;
            used += noise.sigma[r][c];
            ++counted;
        }
    report.stated = stated / counted;
    report.used = used / counted;
    return noise;
}

double scatter_of_repeats(const Noise& noise, const Model& model, const VectorXd& misfit) {
    const VectorXd white = noise.whiten(misfit, model);
    std::vector<Eigen::Index> first_row;
    Eigen::Index next = 0;
    for (const Record& record : model.records()) {
        first_row.push_back(next);
        next += static_cast<Eigen::Index>(record.time.size() * record.channels.size());
    }
    double sum = 0, count = 0;
    for (std::size_t a = 0; a < model.records().size(); ++a)
        for (std::size_t b = a + 1; b < model.records().size(); ++b) {
            const Record &one = model.records()[a], &other = model.records()[b];
            if (one.condition != other.condition || one.time != other.time ||
                one.channels.size() != other.channels.size())
                continue;
            const auto rows = static_cast<Eigen::Index>(one.time.size() * one.channels.size());
            for (Eigen::Index k = 0; k < rows; ++k) {
                const Eigen::Index i = first_row[a] + k, j = first_row[b] + k;
                if (noise.left_out[static_cast<std::size_t>(i)] || noise.left_out[static_cast<std::size_t>(j)])
                    continue;
                sum += 0.5 * (white[i] - white[j]) * (white[i] - white[j]);
                ++count;
            }
        }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

} // namespace tumble::diagnose
