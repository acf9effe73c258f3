#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;

constexpr double foot = 5e-3;     // m
constexpr double reach = 30;      // feet's radii from the middle: so flat that the sideways pull hardly tips it
constexpr double sideways = 0.02; // of the weight

/// Where the loaded tripod came to rest.
struct Rest {
    double approach = 0, shift = 0; // m, down and sideways
};

Result<Rest> load(double force, const Values& values) {
    const contact::Material material{"body", values["density_kg_m3"], values["youngs_modulus_Pa"],
                                     values["poisson_ratio"]};
    contact::PairProperties pair;
    pair.restitution = 0.2; // only how fast it comes to rest
    pair.friction = 1;      // enough to hold the sideways pull
    scene::Scene scene = bench(material, pair, foot);
    scene.gravity = gravity * Vector3d(sideways, -1, 0);
    std::vector<scene::Sphere> feet = tripod(foot);
    for (scene::Sphere& one : feet)
        one.centre *= reach / tripod_reach;
    const int body = add_body(scene, feet);
    scene.bodies.back().mass = force / gravity;
    place(scene, body, {0, foot, 0});
    add_plane(scene, Vector3d::Zero(), Vector3d::UnitY());
    // Period of the mass on its three contacts at the load's own overlap; a step may be a fiftieth of it.
    const double e_star = material.youngs_modulus / (2 * (1 - std::pow(material.poisson_ratio, 2)));
    const double overlap = std::pow(force / 3 / (4.0 / 3 * e_star * std::sqrt(foot)), 2.0 / 3);
    const double period =
        2 * 3.14159265358979 * std::sqrt(force / gravity / (3 * 2 * e_star * std::sqrt(foot * overlap)));
    scene.time_step = period / 200;
    const Result<Track> track = watch(scene, 60 * period, period);
    if (!track)
        return track.problems();
    return Rest{foot - track->back().position.y(), track->back().position.x()};
}

Result<Outcome> perform(const Values& values) {
    const double E = values["youngs_modulus_Pa"], nu = values["poisson_ratio"];
    const auto loads = static_cast<int>(values["loads"]);
    const double lowest = values["lowest_N"], highest = values["highest_N"];
    if (lowest >= highest)
        return Problem{.key = "--highest_N",
                       .what = "the highest load is not above the lowest",
                       .fix = "give --highest_N above --lowest_N"};
    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "Three spheres, bound into a flat tripod, are pressed onto a plate of their own material by dead weights, each "
        "with a small sideways pull. How far they sink gives the effective modulus after Hertz; how far they shift, "
        "over how far they sink, gives Poisson's ratio after Mindlin.");
    sheet.formula("F/3 = 4/3 E* √R δ^(3/2),   E = 2 (1 − ν²) E*", "Johnson 1985, 4.23");
    sheet.formula("k_t / k_n = 2 (1 − ν) / (2 − ν),   k_n = F / (2 δ),   k_t = F_t / (3 ξ)", "Mindlin 1949");
    sheet::Grid grid{
        {{"load", "N"}, {"sinks", "um", 5}, {"Hertz", "um", 5}, {"shifts", "um", 5}, {"k_t / k_n", "", 5}}};
    sheet::Figure figure{
        .name = "press",
        .title = "Load over approach",
        .x = {"approach", "um"},
        .y = {"load", "N"},
        .curves = {{"Hertz", sheet::Style::line, {}, {}, 0}, {"solver", sheet::Style::points, {}, {}, 1}}};
    Recording record{"press", {"load_N", "approach_m", "shift_m"}};
    const double e_star = E / (2 * (1 - nu * nu));
    std::vector<double> ln_load, ln_sunk;
    double ratio = 0;
    for (int k = 0; k < loads; ++k) {
        const double force = lowest * std::pow(highest / lowest, loads == 1 ? 0 : static_cast<double>(k) / (loads - 1));
        const Result<Rest> rest = load(force, values);
        if (!rest)
            return rest.problems();
        // k_n per contact is 3/2 of the secant (F/3)/delta.
        const double normal = 1.5 * force / 3 / rest->approach, along = sideways * force / 3 / rest->shift;
        grid.rows.push_back({force, 1e6 * rest->approach,
                             1e6 * std::pow(force / 3 / (4.0 / 3 * e_star * std::sqrt(foot)), 2.0 / 3),
                             1e6 * rest->shift, along / normal});
        figure.curves[1].add(1e6 * rest->approach, force);
        record.rows.push_back({force, rest->approach, rest->shift});
        ln_load.push_back(std::log(force));
        ln_sunk.push_back(std::log(rest->approach));
        ratio += along / normal / loads;
    }
    const Line line = line_through(ln_sunk, ln_load);
    // With the exponent held at 3/2 the mean of ln F - 3/2 ln delta is that of the prefactor.
    double prefactor = 0;
    for (std::size_t k = 0; k < ln_load.size(); ++k)
        prefactor += (ln_load[k] - 1.5 * ln_sunk[k]) / static_cast<double>(ln_load.size());
    const double found_star = std::exp(prefactor) / (4 * std::sqrt(foot)), found_nu = (2 - 2 * ratio) / (2 - ratio);
    const double found_E = 2 * (1 - found_nu * found_nu) * found_star;
    for (int k = 1; k <= 60; ++k) {
        const double sunk = 1.05 * std::exp(ln_sunk.back()) * k / 60;
        figure.curves[0].add(1e6 * sunk, 4 * e_star * std::sqrt(foot) * std::pow(sunk, 1.5));
    }
    sheet.parts.emplace_back(grid);
    sheet.parts.emplace_back(figure);
    sheet.parts.emplace_back(sheet::Grid{{{""}, {"from the record", "", 5}, {"put in", "", 5}, {"unit"}},
                                         {{"exponent", line.slope, 1.5, "-"},
                                          {"E*", found_star, e_star, "Pa"},
                                          {"Poisson's ratio", found_nu, nu, "-"},
                                          {"Young's modulus", found_E, E, "Pa"}}});
    sheet.fact("exponent", line.slope);
    sheet.fact("youngs_modulus", found_E, "Pa");
    sheet.fact("poisson_ratio", found_nu);
    outcome.recordings.push_back(std::move(record));
    return outcome;
}

} // namespace

Experiment press() {
    return {.name = "press",
            .title = "Compression: load and approach to Young's modulus and Poisson's ratio",
            .parameters = {{"loads", "", 8, {.lo = 2, .hi = 30}, "How many loads (whole number)"},
                           {"lowest_N", "N", 1, {.lo = 1e-4, .hi = 1e5}, "Least load"},
                           {"highest_N", "N", 100, {.lo = 1e-4, .hi = 1e5}, "Largest load"},
                           modulus_parameter(4.6e9),
                           poisson_parameter(),
                           density_parameter()},
            .perform = perform};
}

} // namespace tumble::lab
