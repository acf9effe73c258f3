#include "diagnose/data_doubts.h"

#include "base/column.h"
#include "diagnose/noise.h"
#include "diagnose/warning_key.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace tumble::diagnose {

namespace {

constexpr std::size_t few_levels = 50;
constexpr std::size_t flat_run = 3; // equal readings in a row, of a sensor whose steps are fine
constexpr double one_in_ten_thousand = 1e-4;
constexpr double clear = 10;           // standard errors: a single number nearer to 0 than that tells no unit
constexpr double unit_within = 0.2;    // of a unit's factor, in logarithms
constexpr double far_too_long = 100;   // times what the scene lasts
constexpr std::size_t fewest_lost = 3; // equal readings that stand apart from all others
constexpr double leap = 2;             // times the longest step that the other readings take
constexpr double beyond_scatter = 10;  // times the scatter of a reading
constexpr double share_doubled = 6;    // one reading of so many, or more
constexpr double step_beyond = 2;      // scatters, of the next reading
constexpr std::size_t most_told = 3;   // stretches of lost readings
constexpr double as_noise = 1.5;       // times their scatter that two columns may differ
constexpr double clear_of_noise = 15;  // scatters that readings must span: noise alone spans some seven

enum class Kind { any, angle, way, acceleration };

/// A factor by which a unit is most often wrong, and what was probably meant.
struct Slip {
    double factor;
    const char* meaning;
    Kind of = Kind::any;
    bool surely = true; // no scene is wrong by that much; else it may be
};
constexpr Slip usual_slips[] = {
    {1000, "thousandths, such as mm or ms, read as SI"},
    {1e-3, "SI read as thousandths"},
    {100, "hundredths, such as cm, read as SI"},
    {1e-2, "SI read as hundredths", Kind::any, false}, // what sticks early goes as short a way
    {10, "millimetres read as centimetres", Kind::way, false},
    {0.1, "centimetres read as millimetres", Kind::way, false},
    {25.4, "millimetres read as inches", Kind::way, false},
    {1 / 25.4, "inches read as millimetres", Kind::way, false},
    {9.80665, "m/s2 read as multiples of g", Kind::acceleration, false},
    {1 / 9.80665, "multiples of g read as m/s2", Kind::acceleration, false},
    {57.29578, "degrees read as radians", Kind::angle},
    {1 / 57.29578, "radians read as degrees", Kind::angle}};

Kind kind_of(const std::string& unit) {
    return unit == "deg" || unit == "rad_s" ? Kind::angle
           : unit == "m_s2"                 ? Kind::acceleration
           : unit == "m" || unit == "m_s"   ? Kind::way
                                            : Kind::any;
}

bool is_of(const Slip& slip, Kind kind) {
    return slip.of == kind || (slip.of == Kind::any && kind != Kind::angle);
}

void doubt_time(const Record& record, Problems& warnings) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < record.time.size(); ++k)
        steps.push_back(record.time[k] - record.time[k - 1]);
    std::vector<double> sorted = steps;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double usual = sorted[sorted.size() / 2];
    const auto gaps = std::count_if(steps.begin(), steps.end(), [&](double step) { return step > 1.5 * usual; });
    const auto uneven =
        std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) > 0.1 * usual; });
    if (gaps > 0)
        warnings.push_back({.file = record.file.string(),
                            .key = "gaps",
                            .what = fmt::format("{} gap(s) in time: readings are missing", gaps),
                            .fix = "nothing, if their times are right; readings are used where they stand"});
    else if (uneven > static_cast<std::ptrdiff_t>(steps.size() / 20))
        warnings.push_back(
            {.file = record.file.string(),
             .key = "jitter",
             .what = fmt::format("{} of {} steps in time differ by more than a tenth", uneven, steps.size()),
             .fix = "check the clock; readings are used at the times given"});
}

/// What all readings are whole multiples of, from the lowest on; 0: there is no such step. They may have been printed
/// with few digits: the least difference of neighbours shows the step roughly, the larger ones ever better.
double step_of(const std::set<double>& levels) {
    std::vector<double> differences;
    for (auto it = levels.begin(); std::next(it) != levels.end(); ++it)
        differences.push_back(*std::next(it) - *it);
    std::sort(differences.begin(), differences.end());
    double step = differences.empty() ? 0 : differences[0], way = 0, steps = 0;
    for (const double difference : differences) {
        way += difference;
        steps += std::round(difference / step);
        step = way / steps;
    }
    return std::all_of(
               levels.begin(), levels.end(),
               [&](double level) { return std::abs(std::remainder(level - *levels.begin(), step)) < 0.1 * step; })
               ? step
               : 0;
}

/// How many equal readings in a row chance gives to one sensor in ten thousand: of a body at rest two neighbours, each
/// rounded to the step, are equal with a probability of step / (2 sqrt(pi) sigma).
std::size_t suspicious_run(double step, double sigma) {
    if (step == 0 || sigma == 0)
        return flat_run;
    const double equal = std::min(0.9, step / (3.544907701811032 * sigma));
    return std::max(flat_run, 1 + static_cast<std::size_t>(std::ceil(std::log(one_in_ten_thousand) / std::log(equal))));
}

std::string times_of(const Record& record, const Stretch& stretch) {
    return stretch.length == 1 ? fmt::format("{:g} s", record.time[stretch.first])
                               : fmt::format("{:g} to {:g} s", record.time[stretch.first],
                                             record.time[stretch.first + stretch.length - 1]);
}

/// Runs of readings that are `value`.
std::vector<Stretch> runs_of(const std::vector<double>& readings, double value) {
    std::vector<Stretch> runs;
    for (std::size_t k = 0; k < readings.size(); ++k)
        if (readings[k] == value && k > 0 && readings[k - 1] == value)
            ++runs.back().length;
        else if (readings[k] == value)
            runs.push_back({k, 1});
    return runs;
}

/// Readings that are the one before once more, though the next is not.
std::size_t doubled_in(const Channel& channel) {
    std::size_t pairs = 0;
    for (std::size_t k = 1; k + 1 < channel.value.size(); ++k)
        pairs += channel.value[k] == channel.value[k - 1] &&
                 std::abs(channel.value[k + 1] - channel.value[k]) > step_beyond * channel.sigma;
    return pairs;
}

/// 0, or -1, or nines such as -999, in whatever unit: what programs write where there is nothing to read.
bool stands_for_nothing(double value) {
    if (value == 0)
        return true;
    const double digits = std::abs(value) * std::pow(10, 9 - std::floor(std::log10(std::abs(value)) + 1e-9) - 1);
    const auto nines = [&](int count) { return std::round(digits) == std::round((1 - std::pow(10, -count)) * 1e9); };
    return (value < 0 && std::round(digits) == 1e8) || nines(2) || nines(3) || nines(4) || nines(5);
}

/// A step that no reading takes but those from and to lost ones, which are all `lost`.
double farthest_step(const Channel& channel, double lost) {
    double longest = beyond_scatter * std::max(channel.sigma, scatter_of(channel));
    for (std::size_t k = 1; k < channel.value.size(); ++k)
        if (channel.value[k] != lost && channel.value[k - 1] != lost)
            longest = std::max(longest, leap * std::abs(channel.value[k] - channel.value[k - 1]));
    return longest;
}

/// Into a run from what is before it. A place leaps to nowhere, so that its record may begin or end with a run; a speed
/// may stop.
bool leaps_to(const Channel& channel, const Stretch& run, double longest) {
    return run.first == 0 ? channel.unit == "m"
                          : std::abs(channel.value[run.first - 1] - channel.value[run.first]) > longest;
}

bool leaps_from(const Channel& channel, const Stretch& run, double longest) {
    const std::size_t behind = run.first + run.length;
    return behind == channel.value.size() ? channel.unit == "m"
                                          : std::abs(channel.value[behind] - channel.value[run.first]) > longest;
}

void doubt_channel(const Record& record, const Channel& channel, Problems& warnings) {
    const auto warn = [&](std::string key, const std::string& what, std::string fix) {
        warnings.push_back({.file = record.file.string(),
                            .key = std::move(key),
                            .what = channel.head + ": " + what,
                            .fix = std::move(fix)});
    };
    const std::set<double> levels(channel.value.begin(), channel.value.end());
    if (levels.size() == 1)
        warn(warning_key::dead, fmt::format("all {} readings are equal", channel.value.size()),
             "find out whether the sensor ran; a body at rest would let its readings scatter");
    const double step = step_of(levels);
    const bool few = levels.size() <= few_levels && channel.value.size() > 2 * levels.size();
    const bool repeat = 10 * levels.size() <= 9 * channel.value.size();
    const bool coarse = (few && levels.size() > 1) || (channel.sigma > 0 && step > channel.sigma && repeat);
    if (coarse)
        warn("quantised",
             step > 0 ? fmt::format("only {} different readings, in steps of {:.3g} {} (ins.quant)", levels.size(),
                                    step, channel.unit)
                      : fmt::format("only {} different readings: coarse steps (ins.quant)", levels.size()),
             "record with more digits; a step adds a scatter of step / sqrt(12), which the scatter found contains");
    const std::size_t suspicious = suspicious_run(step, channel.sigma);
    for (const double extreme : {*levels.begin(), *levels.rbegin()}) {
        std::size_t run = 0, longest = 0;
        for (const double value : channel.value)
            longest = std::max(longest, run = value == extreme ? run + 1 : 0);
        if (longest >= suspicious && !coarse && levels.size() > 1)
            warn(warning_key::clipped, fmt::format("{} equal readings in a row at the end of the range", longest),
                 "the sensor was at its limit: choose a larger range");
    }
    if (const std::size_t pairs = doubled_in(channel);
        !coarse && channel.sigma > 0 &&
        share_doubled * static_cast<double>(pairs) > static_cast<double>(channel.value.size()))
        warn(warning_key::doubled,
             fmt::format("{} of {} readings are the one before once more, between steps of more than its scatter",
                         pairs, channel.value.size()),
             "find out whether frames were doubled; if so, leave one of each two out");
    if (channel.sigma == 0)
        warn("sigma missing", "its scatter is not stated", "give sigma; it is estimated from the residual instead");
}

/// Two columns that should read the same.
void doubt_pair(const Record& record, const Channel& one, const Channel& other, Problems& warnings) {
    if (one.measure != other.measure || one.sensor != other.sensor || one.shows_time())
        return;
    double products = 0, squares = 0, apart = 0;
    for (std::size_t k = 0; k < one.value.size(); ++k) {
        products += one.value[k] * other.value[k];
        squares += one.value[k] * one.value[k];
        apart += (other.value[k] - one.value[k]) * (other.value[k] - one.value[k]);
    }
    const auto scatter = [](const Channel& channel) { return channel.sigma > 0 ? channel.sigma : scatter_of(channel); };
    const double far =
        std::sqrt(apart / static_cast<double>(one.value.size())) / std::hypot(scatter(one), scatter(other));
    if (far > as_noise)
        warnings.push_back({.file = record.file.string(),
                            .key = "columns differ",
                            .what = fmt::format("{} and {} show the same measure and differ by {:.1f} times what they "
                                                "scatter; the best factor between them is {:.4g}",
                                                one.head, other.head, far, products / std::max(1e-300, squares)),
                            .fix = "if two instruments read them, name each column's (sensor = \"...\"): what is wrong "
                                   "with one of them is told then"});
}

/// From the lowest to the highest reading; of a single number its magnitude.
template <class Readings> double span_of(const Readings& readings) {
    const auto [lowest, highest] = std::minmax_element(readings.begin(), readings.end());
    return readings.size() == 1 ? std::abs(*lowest) : *highest - *lowest;
}

} // namespace

void doubt_record(const Record& record, Problems& warnings) {
    if (record.single())
        return;
    doubt_time(record, warnings);
    for (const Channel& channel : record.channels)
        doubt_channel(record, channel, warnings);
    for (std::size_t k = 1; k < record.channels.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            doubt_pair(record, record.channels[i], record.channels[k], warnings);
}

std::optional<Problem> time_slip(const Record& record, double scene_lasts) {
    if (record.time.front() > far_too_long * scene_lasts)
        return Problem{.file = record.file.string(),
                       .key = "time",
                       .what = fmt::format("'{}' begins at {:.10g} s, and the scene ends at {:g} s", record.name,
                                           record.time.front(), scene_lasts),
                       .fix = "let its time count from the moment at which the scene begins"};
    const double lasts = record.single() ? record.time.back() : record.time.back() - record.time.front();
    if (lasts < far_too_long * scene_lasts)
        return std::nullopt;
    return Problem{.file = record.file.string(),
                   .key = "time",
                   .what =
                       fmt::format("'{}' lasts {:g} s, {:.0f} times as long as the scene, {:g} s: milliseconds read "
                                   "as seconds?",
                                   record.name, lasts, lasts / scene_lasts, scene_lasts),
                   .fix = "correct the unit of time, or let the scene last longer (duration_s)"};
}

Problems lost_readings(const std::vector<Record>& records) {
    Problems problems;
    for (const Record& record : records)
        for (const Channel& channel : record.channels) {
            std::map<double, std::size_t> counts;
            for (const double value : channel.value)
                if (stands_for_nothing(value))
                    ++counts[value];
            for (const auto& [value, count] : counts) {
                if (count < fewest_lost || count == channel.value.size() || channel.shows_time())
                    continue;
                const std::vector<Stretch> runs = runs_of(channel.value, value);
                const double longest = farthest_step(channel, value);
                if (!std::all_of(runs.begin(), runs.end(), [&](const Stretch& run) {
                        return leaps_to(channel, run, longest) && leaps_from(channel, run, longest);
                    }))
                    continue;
                std::vector<std::string> where;
                for (std::size_t k = 0; k < std::min(most_told, runs.size()); ++k)
                    where.push_back(times_of(record, runs[k]));
                problems.push_back(
                    {.file = record.file.string(),
                     .key = "series.column",
                     .what = fmt::format("{} is {:g} {} in {} readings far from all others (at {}{}): lost readings?",
                                         channel.head, value, channel.unit, count, fmt::join(where, ", "),
                                         runs.size() > most_told ? ", ..." : ""),
                     .fix = "leave those rows out: what was not read is no reading"});
            }
        }
    return problems;
}

Problems equal_columns(const std::vector<Record>& records) {
    Problems problems;
    std::vector<std::pair<const Record*, const Channel*>> seen;
    for (const Record& record : records) {
        if (record.single()) // two drops may rebound alike
            continue;
        for (const Channel& channel : record.channels) {
            if (channel.value == record.time && !channel.shows_time())
                problems.push_back({.file = record.file.string(),
                                    .key = "series.column",
                                    .what = channel.head + " holds the same numbers as time",
                                    .fix = "store the readings themselves"});
            for (const auto& [other, theirs] : seen)
                if (theirs->value == channel.value && !channel.shows_time())
                    problems.push_back(
                        {.file = record.file.string(),
                         .key = "series.column",
                         .what = fmt::format("{} of '{}' holds the same numbers as {} of '{}' ({})", channel.head,
                                             record.name, theirs->head, other->name, other->file.string()),
                         .fix = "store each record once, under its own name"});
            seen.emplace_back(&record, &channel);
        }
    }
    return problems;
}

bool usual_slip(double ratio) {
    return std::any_of(std::begin(usual_slips), std::end(usual_slips), [&](const Slip& slip) {
        return slip.of != Kind::angle && std::abs(std::log(ratio / slip.factor)) < unit_within;
    });
}

Problems unit_slips(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                    std::vector<Misread>& misread) {
    Problems problems;
    std::set<std::size_t> otherwise; // agree if they are read otherwise
    for (const Misread& one : misread)
        if (one.times > 1 && std::isfinite(one.times))
            otherwise.insert(one.records.begin(), one.records.end());
    std::set<std::pair<std::string, std::string>> told; // files and heads: a table has many rows
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records.size(); ++r)
        for (const Channel& channel : records[r].channels) {
            const Record& record = records[r];
            const auto count = static_cast<Eigen::Index>(record.time.size());
            const double ratio = span_of(channel.value) / std::max(1e-300, span_of(predicted.segment(row, count)));
            row += count;
            const bool near_nothing = record.single()
                                          ? span_of(predicted.segment(row - count, count)) < clear * channel.sigma
                                          : span_of(channel.value) < clear_of_noise * scatter_of(channel);
            for (const Slip& slip : usual_slips) {
                if (near_nothing || otherwise.contains(r) || !is_of(slip, kind_of(channel.unit)) ||
                    std::abs(std::log(ratio / slip.factor)) > unit_within ||
                    !told.insert({record.file.string(), channel.head}).second)
                    continue;
                Problem problem{.file = record.file.string(),
                                .key = slip.surely ? channel.head : std::string(warning_key::unit),
                                .what = fmt::format("{} {} {:.3g} times what the simulation does: {}?", channel.head,
                                                    record.single() ? "is" : "spans", ratio, slip.meaning),
                                .fix = "correct the unit in the head of the column"};
                if (slip.surely)
                    problems.push_back(std::move(problem));
                else
                    misread.push_back({{r}, std::move(problem)});
            }
        }
    return problems;
}

} // namespace tumble::diagnose
