#include "excitation/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::excitation {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr int points = 600;      // of a drawn curve
constexpr double periods = 4;    // of the record that are drawn
constexpr double ringing = 0.25; // s after a knock that are drawn

/// Displacement of all orders at a phase of the fundamental (turns), m.
double place_at(const Excitation& found, std::size_t channel, double turns) {
    double place = 0;
    for (const Line& line : found.lines)
        if (line.halves > 0 && line.on[channel].seen)
            place += (displacement(line, channel) * std::polar(1.0, turn * turns * line.halves / 2)).imag();
    return place;
}

std::size_t strongest(const std::vector<Channel>& channels) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const auto [lo, hi] = std::minmax_element(channels[k].values.begin(), channels[k].values.end());
        if (*hi - *lo > most) {
            most = *hi - *lo;
            best = k;
        }
    }
    return best;
}

/// Recorded points of one channel between two times.
sheet::Curve recorded(const Record& record, std::size_t channel, double from, double to) {
    sheet::Curve curve{"recorded", sheet::Style::points};
    std::size_t inside = 0;
    for (const double t : record.time)
        inside += t >= from && t <= to ? 1 : 0;
    const std::size_t every = std::max<std::size_t>(1, inside / points);
    for (std::size_t k = 0; k < record.time.size(); k += every)
        if (record.time[k] >= from && record.time[k] <= to)
            curve.add(record.time[k] - from, record.channels[channel].values[k]);
    return curve;
}

} // namespace

std::vector<std::pair<std::size_t, std::size_t>> planes_of(const std::vector<Channel>& channels) {
    std::vector<std::pair<std::size_t, std::size_t>> planes;
    for (std::size_t a = 0; a < channels.size(); ++a)
        for (std::size_t b = a + 1; b < channels.size(); ++b)
            if (channels[a].sensor == 0 && channels[b].sensor == 0)
                planes.push_back(channels[a].axis == 1 ? std::pair(b, a) : std::pair(a, b));
    return planes;
}

sheet::Figure orbit_figure(const Record& record, const Excitation& found, std::size_t across, std::size_t up) {
    const char a = "xyz"[record.channels[across].axis], b = "xyz"[record.channels[up].axis];
    sheet::Figure figure{.name = fmt::format("orbit-{}{}", a, b),
                         .title = fmt::format("Orbit of the wall in the {}-{} plane", a, b),
                         .x = {fmt::format("displacement along {}", a), "mm"},
                         .y = {fmt::format("displacement along {}", b), "mm"},
                         // The dashes last: where both are one, they are seen upon the line.
                         .curves = {{"all orders", sheet::Style::line},
                                    {"order 1 alone", sheet::Style::dashes},
                                    {"the record begins", sheet::Style::points},
                                    {"a tenth of a turn later", sheet::Style::points}},
                         .stretch = 1};
    const bool halves =
        std::any_of(found.lines.begin(), found.lines.end(), [](const Line& line) { return line.halves % 2 == 1; });
    const Line& first = found.first_order();
    for (int k = 0; k <= points; ++k) {
        const double turns = (halves ? 2.0 : 1.0) * k / points;
        const auto of_first = [&](std::size_t channel) {
            return 1e3 * (displacement(first, channel) * std::polar(1.0, turn * turns)).imag();
        };
        figure.curves[0].add(1e3 * place_at(found, across, turns), 1e3 * place_at(found, up, turns));
        figure.curves[1].add(of_first(across), of_first(up));
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const double turns = 0.1 * static_cast<double>(k);
        figure.curves[2 + k].add(1e3 * place_at(found, across, turns), 1e3 * place_at(found, up, turns));
    }
    double reach = 0;
    for (const sheet::Curve& curve : figure.curves)
        for (std::size_t k = 0; k < curve.x.size(); ++k)
            reach = std::max({reach, std::abs(curve.x[k]), std::abs(curve.y[k])});
    figure.x.range = figure.y.range = std::array{-1.1 * reach, 1.1 * reach};
    return figure;
}

sheet::Figure spectrum_figure(const Record& record, const Excitation& found) {
    sheet::Figure figure{.name = "lines",
                         .title = "Fitted lines, the largest of all axes",
                         .x = {"frequency", "Hz"},
                         .y = {"acceleration", "m/s2", true}};
    const std::array<std::pair<const char*, int>, 4> kinds{
        {{"orders", 0}, {"half orders", 1}, {"mains", 2}, {"fits nothing", 3}}};
    for (const auto& [label, kind] : kinds) {
        sheet::Curve curve{label, sheet::Style::bars};
        curve.color = static_cast<std::size_t>(kind);
        for (const Line& line : found.lines) {
            const int its = line.halves > 0 ? line.halves % 2 : line.kind == Kind::mains ? 2 : 3;
            double largest = 0;
            for (std::size_t k = 0; k < record.channels.size(); ++k)
                largest = std::max(largest, line.on[k].acceleration);
            if (its == kind)
                curve.add(line.frequency, largest);
        }
        if (!curve.x.empty())
            figure.curves.push_back(std::move(curve));
    }
    figure.x.range = std::array{0.0, 1.1 * found.lines.back().frequency};
    return figure;
}

sheet::Figure record_figure(const Record& record, const Excitation& found) {
    const std::size_t channel = strongest(record.channels);
    const double from = record.time.front(), to = std::min(record.time.back(), from + periods / found.fundamental);
    sheet::Figure figure{.name = "record",
                         .title = fmt::format("The first periods of {}", record.channels[channel].name),
                         .x = {"time", "s"},
                         .y = {"acceleration", "m/s2"},
                         .curves = {recorded(record, channel, from, to), {"fitted lines", sheet::Style::line}}};
    for (int k = 0; k <= points; ++k) {
        const double t = (to - from) * k / points;
        double a = found.offset[channel];
        for (const Line& line : found.lines)
            if (line.on[channel].seen)
                a += line.on[channel].acceleration * std::sin(turn * line.frequency * t + line.on[channel].phase);
        figure.curves[1].add(t, a);
    }
    return figure;
}

sheet::Figure ringing_figure(const Record& record, const Ringing& rings) {
    const std::size_t channel = strongest(record.channels);
    const double from = rings.knocks.front() - 0.05 * ringing;
    sheet::Figure figure{.name = "ringing",
                         .title = fmt::format("{} after the first knock", record.channels[channel].name),
                         .x = {"time", "s"},
                         .y = {"acceleration", "m/s2"},
                         .curves = {recorded(record, channel, from, from + 1.05 * ringing)}};
    figure.curves[0].style = sheet::Style::line;
    return figure;
}

} // namespace tumble::excitation
