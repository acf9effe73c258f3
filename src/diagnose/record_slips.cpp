#include "diagnose/record_slips.h"

#include "base/column.h"
#include "diagnose/data_doubts.h"
#include "diagnose/noise.h"
#include "diagnose/warning_key.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tumble::diagnose {

namespace {

constexpr double misses_by_far = 10;     // standard errors, of the root mean square
constexpr double share_missed = 0.04;    // of the mean square, that a slip leaves once it is mended
constexpr double clearly_better = 0.9;   // of what the slip before leaves
constexpr double share_of_another = 0.1; // the same, of another condition: nuisances pull at every bounce
constexpr int shifts_tried = 200;        // to either side, up to the record's length
constexpr double least_shift = 0.1; // of the record's length: less is a clock's, which causes and nuisances explain
constexpr int rates_tried = 600;    // from a fifth to five times
constexpr double highest_rate = 5;
constexpr double least_rate = 0.055;   // away from 1: less is a clock's or gravity's
constexpr double as_well_as = 1.5;     // times what a slip for each record leaves: one rate for all does it, too
constexpr double differ_by = 0.2;      // of their mean: zeros that are no instrument's
constexpr double about_a_radius = 0.1; // of it
constexpr double lowest_of_many = 4;   // scatters below
constexpr double clearly_less = 0.1;   // than a radius
constexpr double alike = 0.3;          // of a radius, that half of the heights are from the middle
constexpr double least_steps = 1.5;    // between readings, that frames which were lost take
constexpr double least_factor = 0.15;  // away from 1: less is a gain's
constexpr double a_moment = 0.02;      // s that a clock may be off

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
            const double z = (value - simulated.truth[c].at(t)) / simulated.sigma[c];
            sum += z * z;
            ++count;
        }
    }
    return 2 * count < readings || count == 0 ? INFINITY : sum / static_cast<double>(count);
}

/// What mends a record, and what it then still misses (mean square).
struct Mended {
    double left = INFINITY;
    const char* key = "";
    std::string how{}, fix{};
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

Mended by_another_condition(const std::vector<Record>& records, std::size_t r,
                            const std::vector<Simulated>& simulated) {
    Mended best;
    for (std::size_t s = 0; s < records.size(); ++s) {
        if (s == r || records[s].single() || records[s].sets == records[r].sets || !read_alike(records[r], records[s]))
            continue;
        if (const double left = missed(records[r], {simulated[s].truth, simulated[r].sigma}, {}); left < best.left)
            best = {left, warning_key::condition, fmt::format("it is of the condition of '{}'", records[s].name),
                    "see whether its file or its set is that of another series"};
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
                left < (moved == 0 ? 1 : share_missed) * best.left)
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
            best = {left, warning_key::zero,
                    fmt::format("{:.4g} {} are taken off {}", zero, channel.unit, channel.head),
                    "read it from the scene's origin; or give the zero as a nuisance, instrument = \"bias\", "
                    "per = \"series\""};
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
        best = {.left = left};
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
    const auto squares_if_late = [&](double late) { // of each row
        std::vector<double> squares(rows, 0);
        for (std::size_t c = 0; c < record.channels.size(); ++c)
            for (std::size_t k = 0; k < rows && !record.channels[c].shows_time() && simulated.sigma[c] > 0; ++k) {
                const double t = record.time[k] - late;
                const double z = (record.channels[c].value[k] - simulated.truth[c].at(t)) / simulated.sigma[c];
                squares[k] += z * z;
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
        for (std::size_t k = 0; k + rows / 10 < rows; ++k) {
            sum += before[k] - behind[k];
            if (k > rows / 10 && sum < least) {
                least = sum;
                late = shift;
                from = k + 1;
            }
        }
    }
    return {least / static_cast<double>(rows * record.channels.size()), warning_key::jump,
            fmt::format("its time is {:.3g} s {} from {:.3g} s on", std::abs(late), late > 0 ? "less" : "more",
                        record.time[from]),
            late > 0 ? "see whether the clock jumped there"
                     : "see whether frames were lost there and the rest numbered on"};
}

/// Its first reading is of another place than that where the scene lets the body begin: nothing can mend that.
std::optional<Problem> other_start(const Record& record, const Simulated& simulated) {
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const Channel& channel = record.channels[c];
        if (!channel.measure.starts_with("centre_of_mass_") || record.time.front() > a_moment)
            continue;
        const double t = record.time.front(), begins = simulated.truth[c].at(t);
        const double allowed = misses_by_far * simulated.sigma[c] + a_moment * std::abs(simulated.truth[c].rate_at(t));
        if (std::abs(channel.value[0] - begins) > allowed)
            return Problem{.file = record.file.string(),
                           .key = warning_key::starts,
                           .what = fmt::format("{} of '{}' begins at {:.4g} {}, and the scene there at {:.4g} {}",
                                               channel.head, record.name, channel.value[0], channel.unit, begins,
                                               channel.unit),
                           .fix = "see whether its set is right, and what the column's zero is"};
    }
    return std::nullopt;
}

/// All records have nearly the same zero: that of an instrument, a cause of the library.
bool one_zero(const std::vector<Record>& records, const std::vector<Simulated>& simulated,
              const std::vector<std::size_t>& far) {
    std::vector<double> zeros;
    for (const std::size_t r : far)
        for (std::size_t c = 0; c < records[r].channels.size(); ++c)
            if (records[r].channels[c].measure == records[far[0]].channels[0].measure)
                zeros.push_back(zero_of(records[r], simulated[r], c));
    const Spread spread = spread_of(zeros);
    return zeros.size() > 1 && spread.deviation < differ_by * std::abs(spread.mean);
}

/// One rate for all records: that at which their sum of what is missed is least.
std::optional<Problem> one_rate(const std::vector<Record>& records, const std::vector<Simulated>& simulated,
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
    return Problem{.file = records[far[0]].file.string(),
                   .key = warning_key::rate,
                   .what = fmt::format("{} with the simulation {:.0f} times as well if {} time runs {:.3g} times as "
                                       "fast",
                                       far.size() == 1 ? fmt::format("'{}' agrees", records[far[0]].name)
                                                       : fmt::format("{} records agree", far.size()),
                                       std::sqrt(before / least), far.size() == 1 ? "its" : "their", rate),
                   .fix = "see to the rate of frames or of readings that time was reckoned with"};
}

} // namespace

Problems record_slips(const std::vector<Record>& records, const std::vector<Simulated>& simulated) {
    std::vector<std::size_t> far;
    for (std::size_t r = 0; r < records.size(); ++r)
        if (!records[r].single() && missed(records[r], simulated[r], {}) > misses_by_far * misses_by_far)
            far.push_back(r);
    if (far.empty())
        return {};
    const bool bias = one_zero(records, simulated, far);
    Problems problems;
    double before = 0, after = 0;
    for (const std::size_t r : far) {
        const double as_it_stands = missed(records[r], simulated[r], {});
        Mended best;
        const auto try_it = [&](Mended mended, double share) {
            if (mended.left < share * as_it_stands && mended.left < clearly_better * best.left)
                best = std::move(mended);
        };
        try_it(by_a_factor(records[r], simulated[r]), share_missed);
        try_it(by_a_sign(records[r], simulated[r]), share_missed);
        if (!bias)
            try_it(by_a_zero(records[r], simulated[r]), share_missed);
        try_it(by_a_shift(records[r], simulated[r]), share_missed);
        try_it(by_a_jump(records[r], simulated[r]), share_missed);
        try_it(by_another_condition(records, r, simulated), share_of_another);
        before += as_it_stands;
        after += std::min(as_it_stands, best.left);
        if (!best.how.empty())
            problems.push_back({.file = records[r].file.string(),
                                .key = best.key,
                                .what = fmt::format("'{}' agrees with the simulation {:.0f} times as well if {}",
                                                    records[r].name, std::sqrt(as_it_stands / best.left), best.how),
                                .fix = std::move(best.fix)});
        else if (auto start = other_start(records[r], simulated[r]); start && best.left >= as_it_stands)
            problems.push_back(std::move(*start));
    }
    if (auto rate = one_rate(records, simulated, far, before, after))
        return {std::move(*rate)};
    return problems;
}

Problems exchanged_numbers(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                           const std::vector<std::vector<double>>& sigma) {
    struct Number {
        const Record* record;
        double read, simulated, sigma;
    };
    std::vector<Number> numbers;
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records.size(); ++r) {
        if (records[r].single() && records[r].channels.size() == 1 && sigma[r][0] > 0)
            numbers.push_back({&records[r], records[r].channels[0].value[0], predicted[row], sigma[r][0]});
        row += static_cast<Eigen::Index>(records[r].time.size() * records[r].channels.size());
    }
    const auto square = [](const Number& number, double simulated) {
        const double z = (number.read - simulated) / number.sigma;
        return z * z;
    };
    const auto far = [&](const Number& number) {
        return square(number, number.simulated) > misses_by_far * misses_by_far;
    };
    Problems problems;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t k = i + 1; k < numbers.size(); ++k) {
            const Number &one = numbers[i], &other = numbers[k];
            if (!far(one) || !far(other) || !read_alike(*one.record, *other.record))
                continue;
            const double before = square(one, one.simulated) + square(other, other.simulated);
            const double after = square(one, other.simulated) + square(other, one.simulated);
            if (after < share_missed * before)
                problems.push_back({.file = one.record->file.string(),
                                    .key = warning_key::condition,
                                    .what = fmt::format("{} of '{}' and of '{}' agree with the simulation {:.0f} times "
                                                        "as well if they are exchanged",
                                                        one.record->channels[0].head, one.record->name,
                                                        other.record->name, std::sqrt(before / after)),
                                    .fix = "see whether two rows were mixed up"});
        }
    return problems;
}

std::optional<Problem> lowest_point(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                                    double radius) {
    std::vector<double> below, lower; // m: all readings; the lowest of each series
    double scatter = 0;               // m, of a reading
    const Record* first = nullptr;
    Eigen::Index row = 0;
    for (const Record& record : records)
        for (const Channel& channel : record.channels) {
            const auto count = static_cast<Eigen::Index>(channel.value.size());
            const auto simulated = predicted.segment(row, count);
            row += count;
            if (channel.measure != "centre_of_mass_y")
                continue;
            first = first ? first : &record;
            for (Eigen::Index k = 0; k < count; ++k)
                below.push_back(simulated[k] - channel.value[static_cast<std::size_t>(k)]);
            if (!record.single()) {
                scatter = std::max(scatter, channel.sigma > 0 ? channel.sigma : scatter_of(channel));
                lower.push_back(simulated.minCoeff() - *std::min_element(channel.value.begin(), channel.value.end()));
            }
        }
    const auto a_radius = [&](double way) { return std::abs(way / radius - 1) < about_a_radius; };
    const auto a_radius_and_scatter = [&](double way) { // the lowest of many readings lies low by chance, too
        return way > (1 - about_a_radius) * radius && way < (1 + about_a_radius) * radius + lowest_of_many * scatter;
    };
    std::vector<double> off;
    for (const double way : below)
        off.push_back(std::abs(way - median(below)));
    const bool all = !below.empty() && a_radius(median(below)) && median(off) < alike * radius;
    if (!all && (lower.empty() || scatter > clearly_less * radius ||
                 !std::all_of(lower.begin(), lower.end(), a_radius_and_scatter)))
        return std::nullopt;
    return Problem{
        .file = first->file.string(),
        .key = warning_key::lowest_point,
        .what = fmt::format("heights are {:.3g} mm too low {}, and the ball's radius is {:.3g} mm: are they those of "
                            "its lowest point?",
                            1e3 * median(all ? below : lower), all ? "in the middle of all" : "where they are lowest",
                            1e3 * radius),
        .fix =
            all ? "centre_of_mass_y is the centre's: add the radius"
                : "centre_of_mass_y is the centre's: add the radius, to the height at which the scene lets it go too"};
}

} // namespace tumble::diagnose
