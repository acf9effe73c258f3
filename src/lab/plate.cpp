#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

constexpr double turn = 2 * std::numbers::pi;
constexpr double shortest = 0.25; // periods: below this a hop, not a flight
constexpr int looks = 400;        // a period

/// Flights in periods of the plate.
struct Flights {
    std::vector<double> lengths;
    double cycles = 0; // watched

    [[nodiscard]] double landings_per_cycle() const { return static_cast<double>(lengths.size()) / cycles; }
    [[nodiscard]] double mean() const {
        double sum = 0;
        for (const double length : lengths)
            sum += length / static_cast<double>(lengths.size());
        return sum;
    }
    /// "1.70", or "1.90 2.07" where they alternate; empty without flights.
    [[nodiscard]] std::string pattern() const {
        std::vector<double> kinds;
        for (const double length : lengths)
            if (std::none_of(kinds.begin(), kinds.end(), [&](double kind) { return std::abs(kind - length) < 0.04; }))
                kinds.push_back(length);
        std::sort(kinds.begin(), kinds.end());
        if (kinds.size() > 4)
            return fmt::format("{:.2f} to {:.2f}, {} kinds", kinds.front(), kinds.back(), kinds.size());
        std::string text;
        for (const double kind : kinds)
            text += fmt::format("{}{:.2f}", text.empty() ? "" : " ", kind);
        return text.empty() ? "none" : text;
    }
};

/// A block that never rebounds, on a plate of peak acceleration gamma g. In units of 1/omega and A: it leaves where the
/// plate falls faster than g, sin(phase) = 1/gamma, flies, and stays where it lands unless the plate already falls too
/// fast there.
Flights of_block(double gamma, double cycles, double skip) {
    Flights flights;
    flights.cycles = cycles - skip;
    if (gamma <= 1)
        return flights;
    const double leaves = std::asin(1 / gamma);
    double phase = leaves;
    while (phase < turn * cycles) {
        const auto gap = [&](double t) {
            return std::sin(phase) + std::cos(phase) * t - t * t / (2 * gamma) - std::sin(phase + t);
        };
        double t = 1e-3;
        while (gap(t) > 0)
            t += 1e-3;
        double lo = t - 1e-3, hi = t;
        for (int k = 0; k < 50; ++k)
            (gap(0.5 * (lo + hi)) > 0 ? lo : hi) = 0.5 * (lo + hi);
        const double lands = phase + lo;
        if (lo / turn > shortest && phase > turn * skip && lands < turn * cycles)
            flights.lengths.push_back(lo / turn);
        const double in_cycle = std::fmod(lands, turn);
        if (in_cycle > leaves && in_cycle < std::numbers::pi - leaves)
            phase = lands; // the plate already falls faster than g: off again at once
        else
            phase = lands + std::fmod(turn + leaves - in_cycle, turn);
        if (phase <= lands)
            phase = lands + 1e-9;
    }
    return flights;
}

struct Shaken {
    Flights flights;
    Recording record;
};

Result<Shaken> shake(double gamma, const Values& values) {
    const double radius = 1e-3 * values["radius_mm"], frequency = values["frequency_Hz"];
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    pair.friction = 0.3;
    scene::Scene scene = bench(material, pair, radius, 0.015);
    place(scene, add_round(scene, radius), {0, radius, 0});
    scene::Harmonic motion;
    motion.amplitude = gamma * gravity / std::pow(turn * frequency, 2);
    motion.frequency = frequency;
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY()).motion.harmonics.push_back(motion);
    const Result<Track> track = watch(scene, values["cycles"] / frequency, 1 / (looks * frequency));
    if (!track)
        return track.problems();
    const double skip = values["skip_cycles"];
    Shaken shaken{{{}, values["cycles"] - skip}, {fmt::format("plate-{:.2f}", gamma), {"t_s", "ball_m", "plate_m"}}};
    double left = -1;
    for (const Seen& seen : *track) {
        const double gap = seen.position.y() - radius - seen.wall.y();
        shaken.record.rows.push_back({seen.time, seen.position.y() - radius, seen.wall.y()});
        if (gap > 0 && left < 0)
            left = seen.time;
        if (gap <= 0 && left >= 0) {
            const double length = (seen.time - left) * frequency;
            if (length > shortest && left * frequency > skip)
                shaken.flights.lengths.push_back(length);
            left = -1;
        }
    }
    return shaken;
}

Result<Outcome> perform(const Values& values) {
    const auto count = static_cast<int>(values["gammas"]);
    const double lowest = values["lowest"], highest = values["highest"];
    if (count > 1 && lowest >= highest)
        return Problem{.key = "--highest",
                       .what = "the highest acceleration is not above the lowest",
                       .fix = "give --highest above --lowest, or --gammas 1"};
    if (values["skip_cycles"] >= values["cycles"])
        return Problem{.key = "--skip_cycles", .what = "all cycles are skipped", .fix = "give fewer than --cycles"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "A ball lies on a plate that shakes up and down. Below one g it stays; above, it is thrown, and with little "
        "restitution it lands dead, as a bed of grains does. Then the flights are those of a block that never "
        "rebounds: one landing a cycle up to Γ = 3.72, flights of two kinds up to 4.6, one landing every second cycle "
        "up to 6.4. A force every second cycle shows as half orders in the spectrum of the plate.");
    sheet.formula("leaves where Γ sin φ = 1,   Γ = A ω² / g");
    sheet::Grid grid{
        {{"Γ"}, {"landings a cycle", "", 3}, {"block", "", 3}, {"flights", "periods"}, {"block", "periods"}}};
    sheet::Figure figure{.name = "plate",
                         .title = "Flights of a ball on a shaken plate",
                         .x = {"peak acceleration of the plate over g"},
                         .y = {"length of a flight", "periods"},
                         .curves = {{"block that never rebounds", sheet::Style::points, {}, {}, 1},
                                    {"solver", sheet::Style::points, {}, {}, 0}}};
    Recording table{"plate", {"gamma", "landings_per_cycle", "mean_flight_periods"}};
    for (int k = 0; k < count; ++k) {
        const double gamma = count == 1 ? lowest : lowest + (highest - lowest) * k / (count - 1);
        Result<Shaken> shaken = shake(gamma, values);
        if (!shaken)
            return shaken.problems();
        const Flights& seen = shaken->flights;
        const Flights block = of_block(gamma, values["cycles"], values["skip_cycles"]);
        grid.rows.push_back(
            {gamma, seen.landings_per_cycle(), block.landings_per_cycle(), seen.pattern(), block.pattern()});
        table.rows.push_back({gamma, seen.landings_per_cycle(), seen.mean()});
        for (const double length : seen.lengths)
            figure.curves[1].add(gamma, length);
        sheet.fact(fmt::format("landings_{:.2f}", gamma), seen.landings_per_cycle());
        sheet.fact(fmt::format("block_{:.2f}", gamma), block.landings_per_cycle());
        outcome.recordings.push_back(std::move(shaken->record));
    }
    for (int k = 0; k <= 200; ++k) {
        const double gamma = lowest + (highest - lowest) * k / 200;
        for (const double length : of_block(gamma, 60, 30).lengths)
            figure.curves[0].add(gamma, length);
    }
    if (figure.curves[1].x.empty())
        figure.curves.pop_back();
    sheet.parts.emplace_back(grid);
    if (!figure.curves[0].x.empty())
        sheet.parts.emplace_back(figure);
    sheet.say(fmt::format("Hops below {:.2g} periods are not counted as flights.", shortest));
    outcome.recordings.push_back(std::move(table));
    return outcome;
}

} // namespace

Experiment plate() {
    return {
        .name = "plate",
        .title = "Ball on a vibrating plate: lift-off and landings",
        .parameters = {{"gammas", "", 13, {.lo = 1, .hi = 60}, "How many accelerations, evenly spaced (whole number)"},
                       {"lowest", "", 0.8, {.lo = 0.1, .hi = 20}, "Least peak acceleration over g"},
                       {"highest", "", 6.8, {.lo = 0.1, .hi = 20}, "Largest peak acceleration over g"},
                       {"frequency_Hz", "Hz", 25, {.lo = 1, .hi = 500}, "Frequency of the plate"},
                       {"cycles", "", 40, {.lo = 5, .hi = 1000}, "Cycles of the plate (whole number)"},
                       {"skip_cycles", "", 20, {.lo = 0, .hi = 900}, "Cycles before flights are counted"},
                       {"radius_mm", "mm", 5, {.lo = 0.1, .hi = 100}, "Radius of the ball"},
                       density_parameter(),
                       modulus_parameter(1e7),
                       poisson_parameter(),
                       restitution_parameter(0.05)},
        .perform = perform};
}

} // namespace tumble::lab
