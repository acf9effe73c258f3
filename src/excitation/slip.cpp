#include "excitation/slip.h"

#include "base/rng.h"
#include "base/text.h"
#include "scene/read_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <set>

namespace tumble::excitation {

namespace {

constexpr double printed = 2e-3;      // bins: how well printed periods meet whole multiples of the bin width
constexpr int most_parts = 400;       // the lowest line is at most so many bins up
constexpr double range = 0.08;        // of the nominal speed, within which the fundamental may be
constexpr int error = 2;              // bins
constexpr std::size_t enumerated = 8; // so many orders are counted out; more are drawn
constexpr int draws = 400'000;

/// The widest bin that every frequency is a multiple of.
double bin_of(const std::vector<BinnedLine>& lines) {
    double lowest = lines.front().frequency;
    for (const BinnedLine& line : lines)
        lowest = std::min(lowest, line.frequency);
    for (int parts = 1; parts <= most_parts; ++parts) {
        const double bin = lowest / parts;
        if (std::all_of(lines.begin(), lines.end(), [&](const BinnedLine& line) {
                return std::abs(line.frequency / bin - std::round(line.frequency / bin)) < printed;
            }))
            return bin;
    }
    return 0;
}

/// Fundamentals that an order in this bin allows.
Interval allowed_by(double bin, double width, int halves) {
    return {(bin - 0.5) * width * 2 / halves, (bin + 0.5) * width * 2 / halves};
}

bool holds(const Interval& interval, double value) {
    return value >= interval.lo && value <= interval.hi;
}

/// The order nearest to a frequency, for this fundamental.
int halves_of(double frequency, double fundamental) {
    return std::max(1, static_cast<int>(std::lround(2 * frequency / fundamental)));
}

bool fits(const BinnedLine& line, double width, double fundamental) {
    return holds(allowed_by(static_cast<double>(line.bin), width, halves_of(line.frequency, fundamental)), fundamental);
}

std::size_t fitting(const std::vector<BinnedLine>& lines, double width, double fundamental) {
    std::set<long long> bins;
    for (const BinnedLine& line : lines)
        if (fits(line, width, fundamental))
            bins.insert(line.bin);
    return bins.size();
}

/// Where most lines agree. How many do changes only at an end of a line's interval, so the middles between neighbouring
/// ends are all that need be tried.
double most_agreed(const std::vector<BinnedLine>& lines, double width, double nominal) {
    std::vector<double> ends{(1 - range) * nominal, (1 + range) * nominal};
    for (const BinnedLine& line : lines) {
        const int lo = halves_of(line.frequency, (1 + range) * nominal);
        const int hi = halves_of(line.frequency, (1 - range) * nominal);
        for (int halves = lo; halves <= hi; ++halves) {
            const Interval allowed = allowed_by(static_cast<double>(line.bin), width, halves);
            for (const double end : {allowed.lo, allowed.hi})
                if (std::abs(end - nominal) < range * nominal)
                    ends.push_back(end);
        }
    }
    std::sort(ends.begin(), ends.end());
    double best = nominal;
    std::size_t most = 0;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double middle = 0.5 * (ends[k - 1] + ends[k]);
        if (const std::size_t agree = fitting(lines, width, middle); agree > most) {
            most = agree;
            best = middle;
        }
    }
    return best;
}

bool overlap(const std::vector<int>& halves, const std::vector<double>& bins) {
    Interval common{0, 1e300};
    for (std::size_t k = 0; k < halves.size(); ++k) {
        const Interval allowed = allowed_by(bins[k], 1, halves[k]);
        common = {std::max(common.lo, allowed.lo), std::min(common.hi, allowed.hi)};
    }
    return common.hi - common.lo > 1e-9; // meeting in a point has no chance
}

/// Share of all ways to be off by -2 to 2 bins about the nominal frequencies in which the lines agree.
double chance_of(const std::vector<int>& halves, double nominal_bins) {
    std::vector<double> bins(halves.size());
    const auto put = [&](auto&& error_of) {
        for (std::size_t k = 0; k < halves.size(); ++k)
            bins[k] = std::round(nominal_bins * halves[k] / 2) + error_of(k);
        return overlap(halves, bins);
    };
    long long agreed = 0, tried = 0;
    if (halves.size() <= enumerated) {
        const auto ways = static_cast<long long>(std::lround(std::pow(2 * error + 1, halves.size())));
        for (; tried < ways; ++tried) {
            long long digits = tried;
            agreed += put([&](std::size_t) {
                const auto digit = static_cast<double>(digits % (2 * error + 1)) - error;
                digits /= 2 * error + 1;
                return digit;
            });
        }
    } else {
        Rng rng(1);
        for (; tried < draws; ++tried)
            agreed += put([&](std::size_t) { return std::floor(rng.uniform(-error, error + 1)); });
    }
    return static_cast<double>(agreed) / static_cast<double>(tried);
}

} // namespace

Result<BinnedLines> find_slip(std::string_view text, const std::string& source, const Settings& settings) {
    const auto rows = scene::parse_harmonics(text, source);
    if (!rows)
        return rows.problems();
    if (rows->size() < 3)
        return Problem{.file = source,
                       .what = fmt::format("{} lines, too few to find a common fundamental", rows->size()),
                       .fix = "list every line that the spectrum shows, small ones too"};
    BinnedLines found;
    for (const scene::Harmonic& row : *rows)
        found.lines.push_back({row.axis, row.amplitude, row.frequency});
    found.bin = settings.bin > 0 ? settings.bin : bin_of(found.lines);
    if (found.bin == 0)
        return Problem{.file = source,
                       .what = "the frequencies are no multiples of one bin width",
                       .fix = "give frequencies as the analyser printed them, with all digits"};
    double strongest = 0;
    for (BinnedLine& line : found.lines) {
        line.bin = std::llround(line.frequency / found.bin);
        const double acceleration = line.amplitude * line.frequency * line.frequency;
        if (acceleration > strongest) {
            strongest = acceleration;
            found.nominal = line.frequency;
        }
    }
    if (settings.motor > 0)
        found.nominal = settings.motor;
    const double fundamental = most_agreed(found.lines, found.bin, found.nominal);
    found.fundamental = {(1 - range) * found.nominal, (1 + range) * found.nominal};
    std::set<int> halves;
    for (BinnedLine& line : found.lines) {
        const double multiple = std::round(line.frequency / settings.mains);
        if (fits(line, found.bin, fundamental)) {
            line.halves = halves_of(line.frequency, fundamental);
            halves.insert(line.halves);
            const Interval allowed = allowed_by(static_cast<double>(line.bin), found.bin, line.halves);
            found.fundamental = {std::max(found.fundamental.lo, allowed.lo),
                                 std::min(found.fundamental.hi, allowed.hi)};
        } else if (multiple >= 1 && std::abs(line.frequency - multiple * settings.mains) <= 0.5 * found.bin) {
            line.multiple = static_cast<int>(multiple);
        }
    }
    found.orders = fitting(found.lines, found.bin, fundamental);
    found.at_nominal = fitting(found.lines, found.bin, found.nominal);
    found.chance = chance_of({halves.begin(), halves.end()}, found.nominal / found.bin);
    return found;
}

bool is_line_list(std::string_view text) {
    for (const std::string_view line : split(text, '\n'))
        if (const auto head = trimmed(line); !head.empty() && !head.starts_with('#'))
            return head.starts_with("axis,amplitude,period");
    return false;
}

double shown_without_window(double off) {
    const double x = std::numbers::pi * off;
    return x == 0 ? 1 : std::abs(std::sin(x) / x);
}

double shown_with_hann(double off) {
    return shown_without_window(off) / (1 - off * off);
}

} // namespace tumble::excitation
