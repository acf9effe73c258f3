#include "diagnose/noise.h"

#include "base/column.h"
#include "diagnose/statistics.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tumble::diagnose {

namespace {

constexpr double least_correlation = 0.08;
constexpr double most_correlation = 0.95;
constexpr double fewest_free = 10;    // readings that nothing explains, to tell a scatter from
constexpr double few = 200;           // of those: tests that take a scatter for known allow for no less
constexpr double contradicted = 0.01; // chance, two-sided, below which so few speak against what was stated
constexpr int halvings = 12;          // of what a memory may be, until it is known to 0.0002
constexpr double outlier = 6;         // standard deviations
constexpr double part_of_span = 1e-5; // of the readings: no instrument is that good
constexpr double hardly_any = 0.05;   // of the scatter stated: such readings were simulated or smoothed
constexpr std::size_t neighbours = 3; // readings to either side that a reading is held against
constexpr double most_outliers = 0.02;
constexpr double least_beside = 0.05; // of an effect, that nuisances leave

bool follows(const Model& model, std::size_t row) {
    return row > 0 && model.rows()[row].record == model.rows()[row - 1].record &&
           model.rows()[row].channel == model.rows()[row - 1].channel;
}

/// Readings that lie far from the median of the residual around them, alone or nearly so.
std::vector<bool> lone_outliers(const Model& model, const VectorXd& scaled) {
    const std::size_t rows = model.rows().size();
    std::vector<bool> out(rows, false);
    for (std::size_t k = 0; k < rows; ++k) {
        if (model.record_of(model.rows()[k]).single())
            continue;
        std::vector<double> around;
        for (std::size_t i = k; i > 0 && i + neighbours > k && follows(model, i); --i)
            around.push_back(scaled[static_cast<Eigen::Index>(i - 1)]);
        for (std::size_t i = k + 1; i < rows && i <= k + neighbours && follows(model, i); ++i)
            around.push_back(scaled[static_cast<Eigen::Index>(i)]);
        const double middle = median(around);
        const auto far = [&](double value) { return std::abs(value - middle) > outlier; };
        out[k] = far(scaled[static_cast<Eigen::Index>(k)]) && std::count_if(around.begin(), around.end(), far) <= 1;
    }
    return out;
}

/// The rows of one measure that is read over time, in order: where each channel's begin, and what of a basis they hold.
struct Chain {
    std::vector<Eigen::Index> rows{};
    std::vector<bool> first{}; // no reading of this channel comes before
    MatrixXd basis{};          // of what was projected out
    MatrixXd beside{};         // mean of the basis in the readings to either side of each
    MatrixXd own{}, along{};   // products of the basis with itself, and with that
    double pairs = 0;          // of neighbours
};

std::map<std::string, Chain> chains_of(const Model& model, const std::vector<bool>& left_out, const MatrixXd& basis) {
    std::map<std::string, Chain> all;
    for (std::size_t k = 0; k < model.rows().size(); ++k) {
        if (left_out[k] || model.record_of(model.rows()[k]).single())
            continue;
        Chain& chain = all[model.channel_of(model.rows()[k]).measure];
        chain.rows.push_back(static_cast<Eigen::Index>(k));
        chain.first.push_back(!follows(model, k) || left_out[k - 1]);
    }
    for (auto& [measure, chain] : all) {
        chain.basis = basis(chain.rows, Eigen::all);
        MatrixXd beside = MatrixXd::Zero(chain.basis.rows(), chain.basis.cols());
        for (Eigen::Index k = 1; k < chain.basis.rows(); ++k)
            if (!chain.first[static_cast<std::size_t>(k)]) {
                beside.row(k) += 0.5 * chain.basis.row(k - 1);
                beside.row(k - 1) += 0.5 * chain.basis.row(k);
                ++chain.pairs;
            }
        chain.own = chain.basis.transpose() * chain.basis;
        chain.along = chain.basis.transpose() * beside;
        chain.beside = std::move(beside);
    }
    return all;
}

/// Sums of squares of a residual, and of products of neighbours.
struct Sums {
    double squares = 0, next = 0;
};

Sums sums_of(const Chain& chain, const VectorXd& rest) {
    Sums sums;
    for (std::size_t k = 0; k < chain.rows.size(); ++k) {
        sums.squares += rest[chain.rows[k]] * rest[chain.rows[k]];
        if (!chain.first[k])
            sums.next += rest[chain.rows[k]] * rest[chain.rows[k] - 1];
    }
    return sums;
}

/// The covariance of errors with that memory, times the basis.
MatrixXd remembered(const Chain& chain, double memory) {
    MatrixXd before = chain.basis, behind = chain.basis;
    for (Eigen::Index k = 1; k < before.rows(); ++k)
        if (!chain.first[static_cast<std::size_t>(k)])
            before.row(k) += memory * before.row(k - 1);
    for (Eigen::Index k = behind.rows() - 1; k > 0; --k)
        if (!chain.first[static_cast<std::size_t>(k)])
            behind.row(k - 1) += memory * behind.row(k);
    return before + behind - chain.basis;
}

/// What the sums would be of errors of scatter 1 with that memory, once the basis is projected out of them; those of
/// other measures are taken to be white. Smooth directions take more of errors that last than of white ones.
Sums expected_of(const Chain& chain, double memory) {
    const MatrixXd errors = remembered(chain, memory), taken = chain.basis.transpose() * errors;
    const MatrixXd all = taken + MatrixXd::Identity(chain.own.rows(), chain.own.cols()) - chain.own;
    return {static_cast<double>(chain.rows.size()) - 2 * taken.trace() + chain.own.cwiseProduct(all).sum(),
            memory * chain.pairs - 2 * chain.beside.cwiseProduct(errors).sum() + chain.along.cwiseProduct(all).sum()};
}

/// Scatter and memory that leave such sums in the mean; as they were where hardly a reading is left to tell.
NoiseOfMeasure noise_behind(const Chain& chain, const Sums& found) {
    if (expected_of(chain, 0).squares < fewest_free)
        return {};
    double low = 0, high = most_correlation;
    for (int k = 0; k < halvings; ++k) {
        const double middle = (low + high) / 2;
        const Sums sums = expected_of(chain, middle);
        (sums.next * found.squares < found.next * sums.squares ? low : high) = middle;
    }
    const double memory = (low + high) / 2;
    return {std::sqrt(found.squares / std::max(1.0, expected_of(chain, memory).squares)), memory};
}

/// A few readings tell a scatter so badly that tests which take it for known would alarm far too often: what was stated
/// holds until they contradict it.
bool bears_out(const Chain& chain, const NoiseOfMeasure& found) {
    const double free = expected_of(chain, found.correlation).squares;
    const double above = free < few ? chi_square_tail(found.ratio * found.ratio * free, free) : 0;
    return above > contradicted / 2 && above < 1 - contradicted / 2;
}

/// Readings of a measure scatter, at that ratio to what is known of them, by next to nothing of what they span: they
/// were simulated.
bool simulated_alone(const Noise& known, const Model& model, const std::string& measure, double ratio) {
    for (std::size_t r = 0; r < model.records().size(); ++r)
        for (std::size_t c = 0; c < model.records()[r].channels.size(); ++c)
            if (const Channel& channel = model.records()[r].channels[c];
                channel.measure == measure && !hardly_scatters(channel, ratio * known.sigma[r][c]))
                return false;
    return true;
}

bool all_stated(const Model& model, const std::string& measure) {
    for (const Record& record : model.records())
        for (const Channel& channel : record.channels)
            if (channel.measure == measure && !(channel.sigma > 0))
                return false;
    return true;
}

/// The share of a scatter that second differences show of it where neighbours correlate so.
double seen_by_bends(double correlation) {
    return std::sqrt((3 - 4 * correlation + correlation * correlation) / 3);
}

/// Records of one condition, done alike and read alike at the same times.
struct RepeatGroup {
    std::vector<Eigen::Index> first{}; // row, of each record
    Eigen::Index rows = 0;             // of one record
};

std::vector<RepeatGroup> groups_of_repeats(const Model& model) {
    std::map<std::tuple<std::string, std::vector<std::string>, std::vector<double>, std::string>, RepeatGroup> all;
    Eigen::Index next = 0;
    for (const Record& record : model.records()) {
        std::string measures;
        for (const Channel& channel : record.channels)
            measures += channel.measure + " ";
        RepeatGroup& group = all[{record.condition, record.sets, record.time, measures}];
        group.first.push_back(next);
        group.rows = static_cast<Eigen::Index>(record.time.size() * record.channels.size());
        next += group.rows;
    }
    std::vector<RepeatGroup> repeated;
    for (auto& [what, group] : all)
        if (group.first.size() > 1)
            repeated.push_back(std::move(group));
    return repeated;
}

/// Each record's readings less the mean of the group's, a column each; 0 where one of them was left out. `readings`:
/// that are left of each.
MatrixXd apart_in(const RepeatGroup& group, const VectorXd& white, const std::vector<bool>& left_out,
                  double& readings) {
    MatrixXd apart(group.rows, static_cast<Eigen::Index>(group.first.size()));
    for (Eigen::Index k = 0; k < apart.cols(); ++k)
        apart.col(k) = white.segment(group.first[static_cast<std::size_t>(k)], group.rows);
    const VectorXd mean = apart.rowwise().mean();
    apart.colwise() -= mean;
    for (Eigen::Index row = 0; row < group.rows; ++row)
        if (std::any_of(group.first.begin(), group.first.end(),
                        [&](Eigen::Index first) { return left_out[static_cast<std::size_t>(first + row)]; }))
            apart.row(row).setZero();
        else
            ++readings;
    return apart;
}

/// What adjusted nuisances leave of effects, each of length 1; those of which they leave next to nothing are 0.
MatrixXd effects_beside(const MatrixXd& adjusted, const MatrixXd& effects) {
    MatrixXd left = Projector(adjusted).out(effects);
    for (Eigen::Index k = 0; k < left.cols(); ++k)
        if (left.col(k).norm() < least_beside * effects.col(k).norm())
            left.col(k).setZero();
    return unit_columns(std::move(left));
}

/// Squares of standard errors, and how many were free to be what they are.
struct Sum {
    double squares = 0, free = 0;

    void add(double more, double of) {
        squares += more;
        free += of;
    }
    [[nodiscard]] double scatter() const { return free > 0 ? std::sqrt(squares / free) : 0; }
    [[nodiscard]] double chance() const { return free > 0 ? hotelling_tail(squares, free, covariance_known) : 1; }
};

} // namespace

bool hardly_scatters(const Channel& channel, double sigma) {
    const auto [low, high] = std::minmax_element(channel.value.begin(), channel.value.end());
    return channel.take == Take::reading && sigma < part_of_span * (*high - *low);
}

double scatter_of(const Channel& channel) {
    std::vector<double> bends;
    for (std::size_t k = 2; k < channel.value.size(); ++k)
        bends.push_back(std::abs(channel.value[k] - 2 * channel.value[k - 1] + channel.value[k - 2]));
    return std::max(1e-12, median(bends) / 0.6745 / std::sqrt(6.0));
}

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

    MatrixXd directions = explained.topRows(scaled.size());
    for (std::size_t k = 0; k < noise.left_out.size(); ++k)
        if (noise.left_out[k])
            directions.row(static_cast<Eigen::Index>(k)).setZero();
    const Projector projector(directions);
    const VectorXd rest = projector.out(scaled);
    report.of.clear();
    report.above = 0;
    for (const auto& [measure, chain] : chains_of(model, noise.left_out, projector.basis())) {
        NoiseOfMeasure& found = report.of[measure] = noise_behind(chain, sums_of(chain, rest));
        const bool stated = all_stated(model, measure);
        if (stated && found.ratio < hardly_any && simulated_alone(noise, model, measure, found.ratio))
            found = {.kept = found.ratio};
        else if (stated && bears_out(chain, found))
            found.ratio = 1;
        report.above = std::max(report.above, found.ratio * (stated ? 1 : seen_by_bends(found.correlation)));
    }
    noise.of = report.of;
    for (auto& [measure, one] : noise.of)
        if (one.correlation <= least_correlation)
            one.correlation = 0;

    double stated = 0, used = 0, counted = 0; // over the channels whose sigma is stated, where any is
    const auto& first = model.records()[0];
    const bool known = std::any_of(model.records().begin(), model.records().end(), [&](const Record& record) {
        return std::any_of(record.channels.begin(), record.channels.end(), [&](const Channel& channel) {
            return channel.measure == first.channels[0].measure && channel.sigma > 0;
        });
    });
    for (std::size_t r = 0; r < model.records().size(); ++r)
        for (std::size_t c = 0; c < model.records()[r].channels.size() && !model.records()[r].single(); ++c) {
            noise.sigma[r][c] *= report.of[model.records()[r].channels[c].measure].ratio;
            if (model.records()[r].channels[c].measure != model.records()[0].channels[0].measure ||
                (known && !(model.records()[r].channels[c].sigma > 0)))
                continue;
            stated += model.records()[r].channels[c].sigma;
            used += noise.sigma[r][c];
            ++counted;
        }
    report.stated = counted > 0 ? stated / counted : 0;
    report.used = counted > 0 ? used / counted : 0;
    return noise;
}

Repeats repeats_in(const Noise& noise, const Model& model, const VectorXd& misfit, const MatrixXd& adjusted,
                   const MatrixXd& effects) {
    const VectorXd white = noise.whiten(misfit, model);
    Sum all, along;
    for (const RepeatGroup& group : groups_of_repeats(model)) {
        const auto free = static_cast<double>(group.first.size() - 1);
        double readings = 0;
        const MatrixXd apart = apart_in(group, white, noise.left_out, readings);
        all.add(apart.squaredNorm(), readings * free);
        const Projector shown(effects_beside(adjusted.middleRows(group.first[0], group.rows),
                                             effects.middleRows(group.first[0], group.rows)));
        double inside = 0;
        for (Eigen::Index k = 0; k < apart.cols(); ++k)
            inside += shown.inside(apart.col(k));
        along.add(inside, shown.rank() * free);
    }
    return {all.scatter(), all.chance(), along.scatter(), along.chance()};
}

} // namespace tumble::diagnose
