#include "diagnose/directions.h"

#include "diagnose/statistics.h"
#include "observe/measures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace tumble::diagnose {

namespace {

constexpr int fewest_readings = 4; // of a block
constexpr int plain_blocks = 6;    // of a record without impacts

/// How one channel moves at its readings, by the simulation.
struct Motion {
    std::vector<double> time, value, rate;
    std::vector<int> impact; // impacts so far
};

Motion motion_of(const Signal& signal, const std::vector<double>& times, const Instrument& instrument) {
    Motion motion;
    const bool many = times.size() > 1;
    const double reading = many ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0;
    const std::vector<double> impacts =
        many ? impacts_of(signal, 2 * fewest_readings * reading) : std::vector<double>{};
    for (const double time : times) {
        const double t = time - instrument.clock_offset;
        motion.time.push_back(time);
        motion.value.push_back(signal.at(t));
        motion.rate.push_back(signal.rate_at(t));
        motion.impact.push_back(
            static_cast<int>(std::upper_bound(impacts.begin(), impacts.end(), t) - impacts.begin()));
    }
    return motion;
}

/// Numbers of the pieces that the readings belong to: halves of flights, or equal parts where nothing impacts.
std::vector<int> pieces_of(const Motion& motion) {
    const std::size_t count = motion.time.size();
    std::vector<int> pieces(count, 0);
    if (motion.impact.back() == 0) {
        for (std::size_t k = 0; k < count; ++k)
            pieces[k] = static_cast<int>(plain_blocks * k / count);
        return pieces;
    }
    int next = 0;
    for (std::size_t begin = 0; begin < count;) {
        std::size_t end = begin;
        while (end < count && motion.impact[end] == motion.impact[begin])
            ++end;
        const std::size_t middle = begin + (end - begin) / 2;
        const bool halves = middle - begin >= fewest_readings;
        for (std::size_t k = begin; k < end; ++k)
            pieces[k] = next + (halves && k >= middle ? 1 : 0);
        if (end - begin >= fewest_readings || begin == 0)
            next += halves ? 2 : 1;
        begin = end;
    }
    return pieces;
}

/// Fills columns row by row; columns grow as they are named.
class Columns {
public:
    Columns(Eigen::Index rows, const Model& model, const Noise& noise) : rows_(rows), model_(model), noise_(noise) {}

    /// `own` and `unit` as Directions has them.
    VectorXd& column(const std::string& name, const std::string& own = "", const std::string& unit = "") {
        const auto [found, added] = index_.try_emplace(name, columns_.size());
        if (added) {
            columns_.push_back(VectorXd::Zero(model_.readings().size()));
            names_.push_back(name);
            own_.push_back(own);
            units_.push_back(unit);
        }
        return columns_[found->second];
    }

    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] const std::vector<std::string>& own() const { return own_; }
    [[nodiscard]] const std::vector<std::string>& units() const { return units_; }

    /// Whitened, with zeros in the rows of priors.
    [[nodiscard]] MatrixXd whitened() const {
        MatrixXd all(model_.readings().size(), static_cast<Eigen::Index>(columns_.size()));
        for (std::size_t k = 0; k < columns_.size(); ++k)
            all.col(static_cast<Eigen::Index>(k)) = columns_[k];
        MatrixXd padded = MatrixXd::Zero(rows_, all.cols());
        padded.topRows(all.rows()) = noise_.whiten(all, model_);
        return padded;
    }

private:
    Eigen::Index rows_;
    const Model& model_;
    const Noise& noise_;
    std::map<std::string, std::size_t> index_;
    std::vector<VectorXd> columns_;
    std::vector<std::string> names_, own_, units_;
};

/// A unit over another as people write it: "s2/m", "1/(m/s)".
std::string over(const std::string& above, const std::string& below) {
    if (below.empty())
        return above;
    const bool compound = below.find('/') != std::string::npos;
    return (above.empty() ? "1" : above) + (compound ? "/(" + below + ")" : "/" + below);
}

/// A direction of no particular cause at one reading, in the measure's unit to that power times s to that one.
struct Print {
    const char* name;
    double value;
    int of_unit, of_s;
};

/// Of the residual's slope along it.
std::string unit_of_slope(const std::string& unit, const Print& print) {
    const int of_unit = 1 - print.of_unit, of_s = -print.of_s;
    const std::string measured = of_unit > 0 ? unit : "";
    if (of_s < 0)
        return measured.find('/') == std::string::npos ? over(measured, "s") : "(" + measured + ")/s";
    const std::string above = of_s == 0 ? measured : of_s == 1 ? "s" : "s\u00b2";
    return of_unit < 0 ? over(above, unit) : above;
}

void add_prints(Columns& prints, const std::string& measure, const std::string& unit, const Motion& motion,
                std::size_t k, Eigen::Index row) {
    const double t = motion.time[k], y = motion.value[k], v = motion.rate[k];
    const int n = motion.impact[k];
    const double turn = n % 2 ? -1 : 1;
    const Print all[] = {{"a constant", 1, 0, 0},
                         {"the reading", y, 1, 0},
                         {"the square of the reading", y * y, 2, 0},
                         {"speed", v, 1, -1},
                         {"the square of speed, with its sign", v * std::abs(v), 2, -2},
                         {"speed without its sign", std::abs(v), 1, -1},
                         {"time", t, 0, 1},
                         {"time times speed", t * v, 1, 0},
                         {"time times the reading", t * y, 1, 1},
                         {"the square of time times speed", t * t * v, 1, 1},
                         {"impacts, one up and one down", turn, 0, 0},
                         {"speed, turned round at every impact", turn * v, 1, -1},
                         {"impacts so far times speed", n * v, 1, -1}};
    for (const Print& one : all)
        prints.column(fmt::format("{} ({})", one.name, measure), "", unit_of_slope(unit, one))[row] = one.value;
}

/// A shared nuisance that would differ in one condition only.
MatrixXd split_by_condition(const Fit& fit, const Model& model, Directions& all) {
    const auto conditions = static_cast<int>(all.conditions.size());
    MatrixXd split = MatrixXd::Zero(fit.residual.size(), 0);
    for (std::size_t k = 0; k < fit.free.size(); ++k) {
        const bool shared = model.parameters()[static_cast<std::size_t>(fit.free[k])].record == -1;
        if (!shared || fit.free[k] >= model.nuisances())
            continue;
        for (int c = 0; c < conditions; ++c) {
            split.conservativeResize(Eigen::NoChange, split.cols() + 1);
            split.col(split.cols() - 1).setZero();
            all.own.push_back(model.parameters()[static_cast<std::size_t>(fit.free[k])].name);
            all.names.push_back(fmt::format("a value of its own of {} in '{}'", all.own.back(),
                                            all.conditions[static_cast<std::size_t>(c)]));
            for (Eigen::Index row = 0; row < model.readings().size(); ++row)
                if (all.condition[static_cast<std::size_t>(row)] == c)
                    split(row, split.cols() - 1) = fit.slopes(row, static_cast<Eigen::Index>(k));
        }
    }
    return split;
}

} // namespace

std::vector<double> impacts_of(const Signal& signal, double shortest_flight) {
    std::vector<double> impacts;
    for (std::size_t k = 1; k + 1 < signal.time.size(); ++k) {
        const bool lowest = signal.value[k] < signal.value[k - 1] && signal.value[k] <= signal.value[k + 1];
        if (lowest && (impacts.empty() || signal.time[k] - impacts.back() > shortest_flight))
            impacts.push_back(signal.time[k]);
    }
    return impacts;
}

Result<Directions> directions_at(Model& model, const Noise& noise, const Fit& fit) {
    Directions all;
    const Eigen::Index rows = fit.residual.size();
    Columns blocks(rows, model, noise), prints(rows, model, noise);
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < model.records().size(); ++r) {
        const Record& record = model.records()[r];
        const auto known = std::find(all.conditions.begin(), all.conditions.end(), record.condition);
        const int condition = static_cast<int>(known - all.conditions.begin());
        if (known == all.conditions.end())
            all.conditions.push_back(record.condition);
        const auto truth = model.signals(fit.values, static_cast<int>(r));
        if (!truth)
            return truth.problems();
        for (std::size_t c = 0; c < record.channels.size(); ++c) {
            const Motion motion = motion_of((*truth)[c], record.time,
                                            model.instrument_at(fit.values, static_cast<int>(r), record.channels[c]));
            const std::vector<int> pieces = pieces_of(motion);
            const std::string& measure = record.channels[c].measure;
            const std::string unit = observe::spelled_unit(record.channels[c].unit);
            all.courses.push_back({measure, row, record.time});
            for (std::size_t k = 0; k < record.time.size(); ++k, ++row) {
                blocks.column(fmt::format("{} {} {}", r, c, pieces[k]))[row] = 1;
                add_prints(prints, measure, unit, motion, k, row);
                prints.column(fmt::format("a constant in '{}' alone ({})", record.condition, measure),
                              "the zero of " + measure, unit)[row] = 1;
                all.condition.push_back(condition);
            }
        }
    }
    all.condition.resize(static_cast<std::size_t>(rows), -1);
    all.blocks = unit_columns(blocks.whitened());
    const MatrixXd usual = prints.whitened();
    all.names = prints.names();
    all.own = prints.own();
    all.units = prints.units();
    const MatrixXd split = split_by_condition(fit, model, all);
    all.units.resize(all.names.size()); // of a nuisance's value: its own
    all.prints.resize(rows, usual.cols() + split.cols());
    all.prints << usual, split;
    all.lengths = all.prints.colwise().norm();
    all.prints = unit_columns(all.prints);
    return all;
}

} // namespace tumble::diagnose
