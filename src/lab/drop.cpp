#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

/// One fall and its rebounds.
struct Fall {
    double height = 0;          // m, of the lowest point at release
    std::vector<double> tops;   // m, of the lowest point, one per rebound
    std::vector<double> strike; // s, when it touched, between two looks
    Track track;
};

/// Square of the terminal speed of the ball in air of this density, m2/s2; infinite without air.
double terminal_square(const Values& values) {
    const double drags = values["air_density_kg_m3"] * values["drag_coefficient"];
    return 8 * values["density_kg_m3"] * 1e-3 * values["radius_mm"] * gravity / (3 * drags);
}

/// Rebound height (m) from that height by the closed form, drag as the square of the speed: down with v^2 = w^2 (1 -
/// exp(-2 g h / w^2)), up to w^2 / (2 g) ln(1 + v^2 / w^2); e^2 h without air.
double top_after(double height, double e, double w2) {
    if (!std::isfinite(w2))
        return e * e * height;
    const double v2 = -e * e * w2 * std::expm1(-2 * gravity * height / w2);
    return w2 / (2 * gravity) * std::log1p(v2 / w2);
}

Result<Fall> fall_from(double height, const Values& values) {
    const double radius = 1e-3 * values["radius_mm"];
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = values["restitution"];
    scene::Scene scene = bench(material, pair, radius, 0.02);
    scene.air = {values["air_density_kg_m3"], 0, values["drag_coefficient"]};
    place(scene, add_round(scene, radius), {0, radius + height, 0});
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY());

    const auto bounces = static_cast<std::size_t>(values["bounces"]);
    const double e = values["restitution"], down = std::sqrt(2 * height / gravity);
    double longest = down;
    for (std::size_t k = 1; k <= bounces; ++k)
        longest += 2 * down * std::pow(e, k);
    Fall fall{height, {}, {}, {}};
    Result<Track> track = watch(scene, 1.2 * longest, 1 / values["rate_Hz"], [&](const Track& so_far) {
        if (so_far.size() < 2)
            return false;
        const Seen &before = so_far[so_far.size() - 2], &now = so_far.back();
        if (before.velocity.y() < 0 && now.velocity.y() > 0)
            fall.strike.push_back(0.5 * (before.time + now.time));
        // From the last look before the top the rest is free flight.
        if (before.velocity.y() > 0 && now.velocity.y() <= 0)
            fall.tops.push_back(before.position.y() + std::pow(before.velocity.y(), 2) / (2 * gravity) - radius);
        return fall.tops.size() >= bounces;
    });
    if (!track)
        return track.problems();
    fall.track = std::move(*track);
    return fall;
}

Result<Outcome> perform(const Values& values) {
    const auto heights = static_cast<int>(values["heights"]);
    const double lowest = 1e-3 * values["lowest_mm"], highest = 1e-3 * values["highest_mm"], e = values["restitution"];
    if (heights > 1 && lowest >= highest)
        return Problem{.key = "--highest_mm",
                       .what = "the highest fall is not above the lowest",
                       .fix = "give --highest_mm above --lowest_mm, or --heights 1"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "A ball is released at rest above a plate. Its rebound height over the height it fell is the square of the "
        "restitution, (4.7) of the thesis; in free flight nothing else counts, so one number must serve all heights.");
    sheet.formula("e = sqrt(h₂ / h₁),   falls for sqrt(2 h₁ / g)", "(4.7)");
    sheet::Grid grid{{{"fell", "mm"}, {"rebound"}, {"height", "mm", 5}, {"closed form", "mm", 5}, {"e", "", 5}}};
    sheet::Figure figure{
        .name = "drop", .title = "Height of the ball's lowest point", .x = {"time", "s"}, .y = {"height", "mm"}};
    Recording table{"rebounds", {"drop_height_m", "rebound", "rebound_height_m"}};
    double worst = 0, off = 0;
    for (int k = 0; k < heights; ++k) {
        const double height = heights == 1 ? lowest : lowest + (highest - lowest) * k / (heights - 1);
        Result<Fall> fall = fall_from(height, values);
        if (!fall)
            return fall.problems();
        double above = height, theory = height;
        for (std::size_t n = 0; n < fall->tops.size(); ++n) {
            const double top = fall->tops[n], seen = std::sqrt(top / above);
            theory = top_after(theory, e, terminal_square(values));
            grid.rows.push_back({1e3 * height, std::to_string(n + 1), 1e3 * top, 1e3 * theory, seen});
            off = std::max(off, std::abs(top / theory - 1));
            table.rows.push_back({height, static_cast<double>(n + 1), top});
            worst = std::max(worst, std::abs(seen - e));
            above = top;
        }
        sheet::Curve curve{fmt::format("{:.4g} mm", 1e3 * height)};
        Recording record{fmt::format("drop-{:.0f}mm", 1e3 * height), {"t_s", "height_m", "speed_m_s"}};
        for (const Seen& seen : fall->track) {
            const double low = seen.position.y() - 1e-3 * values["radius_mm"];
            curve.add(seen.time, 1e3 * low);
            record.rows.push_back({seen.time, low, seen.velocity.y()});
        }
        figure.curves.push_back(std::move(curve));
        outcome.recordings.push_back(std::move(record));
    }
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.say(
        fmt::format("The largest difference between e and what the heights say is {:.1g}: gravity acts during the "
                    "contact too, and the more so the softer the ball and the lower the fall.",
                    worst));
    sheet.say("One height alone cannot tell restitution from drag, from a wrong ruler or from a restitution that falls "
              "with speed: each of them is absorbed in e. Several heights and a light ball can.");
    sheet.fact("worst_restitution", worst);
    sheet.fact("worst_height", off);
    sheet.fact("first_rebound", 1e3 * table.rows.front()[2], "mm");
    outcome.recordings.push_back(std::move(table));
    return outcome;
}

} // namespace

Experiment drop() {
    return {.name = "drop",
            .title = "Drop: rebound heights to restitution",
            .parameters = {{"heights", "", 4, {.lo = 1, .hi = 20}, "How many heights, evenly spaced (whole number)"},
                           {"lowest_mm", "mm", 200, {.lo = 1, .hi = 5000}, "Lowest height of release"},
                           {"highest_mm", "mm", 800, {.lo = 1, .hi = 5000}, "Highest height of release"},
                           {"bounces", "", 3, {.lo = 1, .hi = 10}, "Rebounds to follow (whole number)"},
                           {"radius_mm", "mm", 12.75, {.lo = 0.1, .hi = 500}, "Radius of the ball"},
                           density_parameter(),
                           modulus_parameter(4.6e8),
                           poisson_parameter(),
                           restitution_parameter(),
                           {"air_density_kg_m3", "kg/m3", 0, {.lo = 0, .hi = 2000}, "Density of the air; 0: none"},
                           drag_parameter(),
                           {"rate_Hz", "Hz", 1000, {.lo = 50, .hi = 1e5}, "Samples a second of the records"}},
            .perform = perform};
}

} // namespace tumble::lab
