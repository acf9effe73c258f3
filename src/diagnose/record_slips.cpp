#include "base/column.h"
#include "diagnose/data_doubts.h"
#include "diagnose/misread.h"
#include "diagnose/warning_key.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <tuple>

namespace tumble::diagnose {

namespace {

constexpr std::size_t enough_readings = 400;
constexpr std::size_t fewest_held = 5;
constexpr double misses_by_far = 10;     // standard errors, of the root mean square
constexpr double share_missed = 0.04;    // of the mean square, that a slip leaves once it is mended
constexpr double half_as_much = 0.5;     // a second number must halve what the first leaves
constexpr double clearly_better = 0.9;   // of what the slip before leaves
constexpr double share_of_another = 0.1; // the same, of another condition: nuisances pull at every bounce
constexpr int shifts_tried = 200;        // to either side, up to the record's length
constexpr double least_shift = 0.1; // of the record's length: less is a clock's, which causes and nuisances explain
constexpr int rates_tried = 600;    // from a fifth to five times
constexpr double highest_rate = 5;
constexpr double least_rate = 0.055;  // away from 1: less is a clock's or gravity's
constexpr double as_well_as = 1.5;    // times what a slip for each record leaves: one rate for all does it, too
constexpr double differ_by = 0.2;     // of their mean: zeros that are no instrument's
constexpr double least_steps = 1.5;   // between readings, that frames which were lost take
constexpr double least_factor = 0.15; // away from 1: less is a gain's
constexpr double as_others = 12;      // times the mean square that is left
constexpr double than_others = 5;     // times as far off at first
constexpr double a_moment = 0.02;     // s that a clock may be off

/// How a record is read: its time, s, is (t - late) * rate, and one channel may be turned or moved.
struct Reading {
    double late = 0, rate = 1;
    std::size_t channel = 0;
    double factor = 1, zero = 0; // of that channel
};

/// Mean square, in standard errors, of what readings miss if they are read so; infinite where less than half of them
/// lie in what was simulated. Before that every body stands where the scene has it.
double missed(const Record& record, const Simulated& simulated, const Reading& reading) {
    double sum = 0;
    std::size_t count = 0, readings = 0;
    const bool as_it_stands = reading.late == 0 && reading.rate == 1;
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        if (record.channels[c].shows_time() || simulated.sigma[c] <= 0)
            continue;
        const double factor = c == reading.channel ? reading.factor : 1;
        const double zero = c == reading.channel ? reading.zero : 0;
        readings += record.time.size();
        for (std::size_t k = 0; k < record.time.size(); ++k) {
            const double t = (record.time[k] - reading.late) * reading.rate;
            if (!as_it_stands && (t < 0 || t > simulated.truth[c].time.back()))
                continue;
            const double value = factor * record.channels[c].value[k] - zero;
            const double z = (value - simulated.truth[c].at(t)) / (std::abs(factor) * simulated.sigma[c]);
            sum += z * z;
            ++count;
        }
    }
    return 2 * count < readings || count == 0 ? INFINITY : sum / static_cast<double>(count);
}

/// Some hundred readings of a record are enough to tell what mends it.
Record thinned(const Record& record) {
    if (record.single() || record.time.size() <= enough_readings)
        return record;
    const std::size_t every = (record.time.size() + enough_readings - 1) / enough_readings;
    Record thin = record;
    const auto thin_out = [&](std::vector<double>& values) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < values.size(); k += every)
            values[kept++] = values[k];
        values.resize(kept);
    };
    thin_out(thin.time);
    for (Channel& channel : thin.channels)
        thin_out(channel.value);
    return thin;
}

/// What mends a record, and what it then still misses (mean square).
struct Mended {
    double left = INFINITY;
    const char* key = "";
    std::string how{}, fix{};
    std::size_t channel = 0;
    double number = 0; // the zero or the factor of that channel
};

Mended by_a_shift(const Record& record, const Simulated& simulated) {
    const double lasts = record.time.back() - record.time.front();
    double least = INFINITY, late = 0;
    const auto look_about = [&](double from, double reach) {
        for (int k = -shifts_tried; k <= shifts_tried; ++k) {
            const double shift = from + reach * k / shifts_tried;
            if (const double left = missed(record, simulated, {.late = shift}); left < least) {
                least = left;
                late = shift;
            }
        }
    };
    look_about(0, lasts);
    look_about(record.time.front(), lasts);
    look_about(late, 2 * lasts / shifts_tried);
    if (std::abs(late) < least_shift * lasts)
        return {};
    return {least, warning_key::shifted,
            fmt::format("its time begins {:.3g} s {}", std::abs(late), late > 0 ? "earlier" : "later"),
            "let its time count from the moment at which the scene begins"};
}

bool read_alike(const Record& one, const Record& other) {
    return std::equal(
        one.channels.begin(), one.channels.end(), other.channels.begin(), other.channels.end(),
        [](const Channel& a, const Channel& b) { return a.measure == b.measure && a.sensor == b.sensor; });
}

/// Of whose condition a record agrees best, and what it then misses.
std::pair<std::size_t, double> best_condition(const std::vector<Record>& records, std::size_t r,
                                              const std::vector<Simulated>& simulated) {
    std::pair<std::size_t, double> best{r, INFINITY};
    for (std::size_t s = 0; s < records.size(); ++s) {
        if (s == r || records[s].single() || records[s].sets == records[r].sets || !read_alike(records[r], records[s]))
            continue;
        if (const double left = missed(records[r], {simulated[s].truth, simulated[r].sigma}, {}); left < best.second)
            best = {s, left};
    }
    return best;
}

/// The mean by which a column, times a factor, differs from what was simulated.
double zero_of(const Record& record, const Simulated& simulated, std::size_t c, double factor = 1) {
    double sum = 0;
    for (std::size_t k = 0; k < record.time.size(); ++k)
        sum += factor * record.channels[c].value[k] - simulated.truth[c].at(record.time[k]);
    return sum / static_cast<double>(record.time.size());
}

/// With or without another zero: heights may be read downwards from the ceiling.
Mended by_a_sign(const Record& record, const Simulated& simulated) {
    Mended best;
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const Channel& channel = record.channels[c];
        if (channel.shows_time())
            continue;
        const double zero = zero_of(record, simulated, c, -1);
        for (const double moved : {0.0, zero})
            if (const double left = missed(record, simulated, {.channel = c, .factor = -1, .zero = moved});
                left < (moved == 0 ? 1 : half_as_much) * best.left)
                best = {left, warning_key::turned,
                        fmt::format("the sign of {} is turned{}", channel.head,
                                    moved == 0 ? "" : fmt::format(" and {:.4g} {} added", -moved, channel.unit)),
                        "read it along the scene's axis, from the scene's origin"};
    }
    return best;
}

Mended by_a_zero(const Record& record, const Simulated& simulated) {
    Mended best;
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const Channel& channel = record.channels[c];
        if (channel.shows_time())
            continue;
        const double zero = zero_of(record, simulated, c);
        if (const double left = missed(record, simulated, {.channel = c, .zero = zero}); left < best.left)
            best = {.left = left,
                    .key = warning_key::zero,
                    .how = fmt::format("{:.4g} {} are taken off {}", zero, channel.unit, channel.head),
                    .fix = "read it from the scene's origin; or give the zero as a nuisance, instrument = \"bias\", "
                           "per = \"series\"",
                    .channel = c,
                    .number = zero};
    }
    return best;
}

/// The factor by which a column agrees best; those of units are told elsewhere.
Mended by_a_factor(const Record& record, const Simulated& simulated) {
    Mended best;
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        double products = 0, squares = 0;
        for (std::size_t k = 0; k < record.time.size(); ++k) {
            products += record.channels[c].value[k] * simulated.truth[c].at(record.time[k]);
            squares += record.channels[c].value[k] * record.channels[c].value[k];
        }
        const double factor = products / std::max(1e-300, squares);
        const double left = missed(record, simulated, {.channel = c, .factor = factor});
        if (factor <= 0 || std::abs(factor - 1) < least_factor || left >= best.left)
            continue;
        best = {.left = left, .channel = c, .number = factor};
        if (!usual_slip(1 / factor)) {
            best.key = warning_key::scale;
            best.how = fmt::format("{} is {:.3g} times as large", record.channels[c].head, factor);
            best.fix = "see to its scale or its unit";
        }
    }
    return best;
}

/// From some moment on the time is late or early, as where frames were lost and the rest numbered on.
Mended by_a_jump(const Record& record, const Simulated& simulated) {
    const std::size_t rows = record.time.size();
    const double lasts = record.time.back() - record.time.front();
    const auto squares_if_late = [&](double late) { // of each row; those beyond what was simulated have none
        std::vector<double> squares;
        for (std::size_t k = 0; k < rows && record.time[k] - late <= simulated.truth[0].time.back(); ++k) {
            squares.push_back(0);
            for (std::size_t c = 0; c < record.channels.size(); ++c)
                if (!record.channels[c].shows_time() && simulated.sigma[c] > 0) {
                    const double z = (record.channels[c].value[k] - simulated.truth[c].at(record.time[k] - late)) /
                                     simulated.sigma[c];
                    squares.back() += z * z;
                }
        }
        return squares;
    };
    const std::vector<double> before = squares_if_late(0);
    double least = INFINITY, late = 0;
    std::size_t from = 0;
    for (int step = -shifts_tried; step <= shifts_tried; ++step) {
        const double shift = 0.5 * lasts * step / shifts_tried;
        if (std::abs(shift) < least_steps * lasts / static_cast<double>(rows - 1))
            continue;
        const std::vector<double> behind = squares_if_late(shift);
        double sum = std::accumulate(behind.begin(), behind.end(), 0.0);
        for (std::size_t k = 0; k + rows / 10 < behind.size() && 2 * behind.size() > rows; ++k) {
            sum += before[k] - behind[k];
            if (const double mean = sum / static_cast<double>(behind.size()); k > rows / 10 && mean < least) {
                least = mean;
                late = shift;
                from = k + 1;
            }
        }
    }
    const auto read = std::count_if(record.channels.begin(), record.channels.end(),
                                    [](const Channel& channel) { return !channel.shows_time(); });
    return {least / static_cast<double>(read), warning_key::jump,
            fmt::format("its time is {:.3g} s {} from {:.3g} s on", std::abs(late), late > 0 ? "less" : "more",
                        record.time[from]),
            late > 0 ? "see whether the clock jumped there"
                     : "see whether frames were lost there and the rest numbered on"};
}

/// How far a record's first reading of a place lies from where the scene lets the body begin, m; nothing where none is
/// read so early.
std::optional<double> off_at_first(const Record& record, const Simulated& simulated, std::size_t c) {
    if (!record.channels[c].measure.starts_with("centre_of_mass_") || record.time.front() > a_moment ||
        record.channels[c].value[0] == record.channels[c].value[1]) // cut off
        return std::nullopt;
    return std::abs(record.channels[c].value[0] - simulated.truth[c].at(record.time.front()));
}

/// A record that begins at another place than the scene's, by far more than the others do: nothing can mend that.
std::optional<Problem> other_start(const std::vector<Record>& records, const std::vector<Simulated>& simulated,
                                   std::size_t r) {
    for (std::size_t c = 0; c < records[r].channels.size(); ++c) {
        const auto off = off_at_first(records[r], simulated[r], c);
        std::vector<double> others;
        for (std::size_t s = 0; s < records.size(); ++s)
            if (s != r && !records[s].single() && read_alike(records[r], records[s]))
                if (const auto one = off_at_first(records[s], simulated[s], c))
                    others.push_back(*one);
        if (!off || others.empty())
            continue;
        const Channel& channel = records[r].channels[c];
        const Signal& truth = simulated[r].truth[c];
        const double t = records[r].time.front();
        if (*off < misses_by_far * simulated[r].sigma[c] + a_moment * std::abs(truth.rate_at(t)) ||
            *off < than_others * median(others))
            continue;
        return Problem{.file = records[r].file.string(),
                       .key = warning_key::starts,
                       .what =
                           fmt::format("{} of '{}' begins at {:.4g} {}, and the scene there at {:.4g} {}", channel.head,
                                       records[r].name, channel.value[0], channel.unit, truth.at(t), channel.unit),
                       .fix = "see whether its set is right, and what the column's zero is"};
    }
    return std::nullopt;
}

/// What mends one record each.
using Mends = std::map<std::size_t, Mended>;

/// A zero that all records have alike is that of an instrument, a cause of the library; so is that of one record alone.
/// A scale that they have not alike is none: friction that is a little wrong changes the way down a slope, too.
void leave_out_by_all(Mends& mends, const std::vector<Record>& records) {
    using Sensed = std::tuple<const char*, std::string, std::string>; // what mends, of a measure and a sensor
    std::map<Sensed, std::vector<double>> numbers;
    const auto whose = [&](std::size_t r, const Mended& mended) {
        const Channel& channel = records[r].channels[mended.channel];
        return Sensed{mended.key, channel.measure, channel.sensor};
    };
    for (const auto& [r, mended] : mends)
        numbers[whose(r, mended)].push_back(mended.number);
    std::erase_if(mends, [&](const auto& one) {
        const auto& [key, measure, sensor] = whose(one.first, one.second);
        const auto read = static_cast<std::size_t>(
            std::count_if(records.begin(), records.end(), [&, &by = measure, &from = sensor](const Record& record) {
                return std::any_of(record.channels.begin(), record.channels.end(), [&](const Channel& channel) {
                    return channel.measure == by && channel.sensor == from;
                });
            }));
        const auto& found = numbers[whose(one.first, one.second)];
        const Spread spread = spread_of(found);
        const bool alike = found.size() == read && spread.deviation <= differ_by * std::abs(spread.mean);
        return (key == warning_key::zero && alike) || (key == warning_key::scale && !alike);
    });
}

/// A record whose time jumps is, once that is mended, as the others are that do not: whatever changes a bounce brings
/// the next earlier, in all of them.
void leave_other_jumps_out(Mends& mends, const std::vector<Record>& records, const std::vector<Simulated>& simulated) {
    std::vector<double> others;
    for (std::size_t r = 0; r < records.size(); ++r)
        if (!records[r].single() && !(mends.contains(r) && mends[r].key == warning_key::jump))
            others.push_back(missed(records[r], simulated[r], {}));
    std::erase_if(mends, [&](const auto& one) {
        return one.second.key == warning_key::jump && (others.empty() || median(others) > as_others * one.second.left);
    });
}

/// Records that were mixed up among each other: each agrees best with the condition of the next, the last with that of
/// the first, better than any other mending does. Their own mendings give way.
void exchange(Mends& mends, const std::vector<Record>& records, const std::vector<Simulated>& simulated,
              const std::vector<std::size_t>& far) {
    std::map<std::size_t, std::pair<std::size_t, double>> next;
    for (const std::size_t r : far)
        next[r] = best_condition(records, r, simulated);
    for (const std::size_t first : far) {
        std::vector<std::size_t> cycle;
        double before = 0, after = 0, otherwise = 0;
        std::size_t at = first;
        do {
            cycle.push_back(at);
            const double stands = missed(records[at], simulated[at], {});
            before += stands;
            after += next[at].second;
            otherwise += mends.contains(at) ? mends[at].left : stands;
            at = next[at].first;
        } while (at != first && next.contains(at) && cycle.size() <= far.size());
        if (at != first || cycle.size() < 2 || after > share_of_another * before || after > clearly_better * otherwise)
            continue;
        for (const std::size_t r : cycle)
            mends[r] = {next[r].second, warning_key::condition,
                        fmt::format("it is of the condition of '{}'", records[next[r].first].name),
                        "see whether its file or its set is that of another series"};
    }
}

/// One rate for all records: that at which their sum of what is missed is least.
std::optional<Misread> one_rate(const std::vector<Record>& records, const std::vector<Simulated>& simulated,
                                const std::vector<std::size_t>& far, double before, double mended_singly) {
    double least = INFINITY, rate = 1;
    const auto look_about = [&](double from, double reach) { // in logarithms
        for (int k = -rates_tried; k <= rates_tried; ++k) {
            const double tried = from * std::exp(reach * k / rates_tried);
            double left = 0;
            for (const std::size_t r : far)
                left += missed(records[r], simulated[r], {.rate = tried});
            if (left < least) {
                least = left;
                rate = tried;
            }
        }
    };
    look_about(1, std::log(highest_rate));
    look_about(rate, 2 * std::log(highest_rate) / rates_tried);
    if (least > share_missed * before || least > as_well_as * mended_singly || std::abs(rate - 1) < least_rate)
        return std::nullopt;
    return Misread{far,
                   {.file = records[far[0]].file.string(),
                    .key = warning_key::rate,
                    .what = fmt::format("{} with the simulation {:.0f} times as well if {} time runs {:.3g} times as "
                                        "fast",
                                        far.size() == 1 ? fmt::format("'{}' agrees", records[far[0]].name)
                                                        : fmt::format("{} records agree", far.size()),
                                        std::sqrt(before / least), far.size() == 1 ? "its" : "their", rate),
                    .fix = "see to the rate of frames or of readings that time was reckoned with"},
                   std::sqrt(before / least),
                   least / static_cast<double>(far.size())};
}

} // namespace

std::vector<Misread> record_slips(const std::vector<Record>& all, const std::vector<Simulated>& simulated) {
    std::vector<Record> records;
    std::vector<std::size_t> far;
    for (std::size_t r = 0; r < all.size(); ++r) {
        records.push_back(thinned(all[r]));
        if (!all[r].single() && missed(records[r], simulated[r], {}) > misses_by_far * misses_by_far)
            far.push_back(r);
    }
    if (far.empty())
        return {};
    Mends mends;
    double before = 0, after = 0;
    for (const std::size_t r : far) {
        const double as_it_stands = missed(records[r], simulated[r], {});
        Mended best;
        for (const auto& by : {by_a_factor, by_a_zero, by_a_sign, by_a_shift, by_a_jump})
            if (Mended mended = by(records[r], simulated[r]);
                mended.left < share_missed * as_it_stands && mended.left < clearly_better * best.left)
                best = std::move(mended);
        before += as_it_stands;
        after += std::min(as_it_stands, best.left);
        if (best.left < as_it_stands)
            mends[r] = std::move(best);
    }
    exchange(mends, records, simulated, far);
    if (auto rate = one_rate(records, simulated, far, before, after))
        return {std::move(*rate)};
    leave_out_by_all(mends, records);
    leave_other_jumps_out(mends, records, simulated);
    std::vector<Misread> misread;
    for (std::size_t r = 0; r < records.size(); ++r) {
        if (mends.contains(r) && !mends[r].how.empty()) {
            const double times = std::sqrt(missed(records[r], simulated[r], {}) / mends[r].left);
            misread.push_back({{r},
                               {.file = records[r].file.string(),
                                .key = mends[r].key,
                                .what = fmt::format("'{}' agrees with the simulation {:.0f} times as well if {}",
                                                    records[r].name, times, mends[r].how),
                                .fix = mends[r].fix},
                               times,
                               mends[r].left});
        } else if (auto start = other_start(records, simulated, r); start && !mends.contains(r)) {
            misread.push_back({{r}, std::move(*start), 1});
        }
    }
    return misread;
}

std::optional<Problem> held_readings(const Record& record, const Simulated& simulated) {
    for (std::size_t c = 0; c < record.channels.size() && !record.single(); ++c) {
        const Channel& channel = record.channels[c];
        const double sigma = channel.sigma;
        const auto [low, high] = std::minmax_element(channel.value.begin(), channel.value.end());
        Stretch run{0, 1};
        for (std::size_t k = 1; k < channel.value.size() && sigma > 0; ++k) {
            const double step = channel.value[k] - channel.value[k - 1];
            if (step == 0) {
                ++run.length;
                continue;
            }
            const double from = record.time[run.first], to = record.time[k - 1];
            const double held = channel.value[k - 1]; // at an end of the range it is cut off
            if (run.length >= fewest_held && held != *low && held != *high && std::abs(step) > misses_by_far * sigma &&
                std::abs(simulated.truth[c].at(to) - simulated.truth[c].at(from)) > misses_by_far * sigma)
                return Problem{.file = record.file.string(),
                               .key = warning_key::stuck,
                               .what = fmt::format("{}: {} equal readings in a row ({:g} to {:g} s), and then a leap, "
                                                   "where the simulation moves",
                                                   channel.head, run.length, from, to),
                               .fix = "find out whether the sensor held on to one; if so, leave those rows out"};
            run = {k, 1};
        }
    }
    return std::nullopt;
}

} // namespace tumble::diagnose
