#include "lab/bench.h"
#include "lab/each.h"
#include "run/simulation.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lab {

namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// The thesis' cone of 65 spheres, as its appendix B.5 builds it: five on the axis, then rings on the ground.
struct Ring {
    int count;
    double reach, height, radius; // m
};
constexpr std::array<Ring, 8> cone{{{1, 0, 0.0205, 0.00155},
                                    {1, 0, 0.018, 0.00276},
                                    {1, 0, 0.015, 0.00408},
                                    {1, 0, 0.012, 0.00533},
                                    {1, 0, 0.00721, 0.00721},
                                    {10, 0.0038, 0.00462, 0.00462},
                                    {20, 0.0064, 0.0028, 0.0028},
                                    {30, 0.00815, 0.00153, 0.00153}}};

std::vector<scene::Sphere> cone_of_spheres() {
    std::vector<scene::Sphere> spheres;
    for (const Ring& ring : cone)
        for (int k = 0; k < ring.count; ++k) {
            const double angle = 2 * pi * k / ring.count;
            spheres.push_back(
                {Vector3d(ring.reach * std::cos(angle), ring.height, ring.reach * std::sin(angle)), ring.radius});
        }
    return spheres;
}

/// What the solver makes of it.
Result<run::SimulatedBody> solved(const std::vector<scene::Sphere>& spheres, double density) {
    scene::Scene scene = bench({"body", density, 1e7, 0.3}, {}, 1e-3);
    add_body(scene, spheres);
    const auto world = run::simulate(scene, 1);
    if (!world)
        return world.problems();
    return (*world)->bodies().front();
}

Result<Outcome> perform(const Values& values) {
    const double mass = 1e-3 * values["mass_g"], mass_se = 1e-3 * values["mass_sd_g"] / std::sqrt(values["weighed"]);
    const double height = 1e-3 * values["height_mm"], base = 1e-3 * values["base_mm"];
    const double ruler = 1e-3 * values["caliper_sd_mm"];
    const double turned_d = 1e-3 * values["turned_diameter_mm"], turned_h = 1e-3 * values["turned_length_mm"];
    const double turned_mass = 1e-3 * values["turned_mass_g"];
    const Result<run::SimulatedBody> clump = solved(cone_of_spheres(), values["density_kg_m3"]);
    if (!clump)
        return clump.problems();
    const double ideal = pi / 12 * base * base * height, turned = pi / 4 * turned_d * turned_d * turned_h;

    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(
        "Density is mass over volume, and the volume is what is hard. Three ways, as the thesis went: the particle "
        "taken "
        "for an ideal cone; a closer model of its shape, here the 65 spheres that the solver moves, overlaps counted "
        "once; and a cylinder turned out of the same material on a lathe.");
    sheet.formula("ideal cone V = π d² h / 12,   cylinder V = π d² l / 4");
    // First order: 2 sigma_d / d, sigma_h / h, sigma_m / m.
    const auto error = [&](double rho, double d, double l, double m) {
        return rho * std::sqrt(std::pow(2 * ruler / d, 2) + std::pow(ruler / l, 2) + std::pow(mass_se / m, 2));
    };
    const double by_cone = mass / ideal, by_clump = mass / clump->volume, by_turned = turned_mass / turned;
    sheet.parts.emplace_back(
        sheet::Grid{{{"way"}, {"mass", "g", 4}, {"volume", "mm3", 5}, {"density", "kg/m3", 5}, {"±", "kg/m3", 2}},
                    {{"ideal cone", 1e3 * mass, 1e9 * ideal, by_cone, error(by_cone, base, height, mass)},
                     {"65 spheres", 1e3 * mass, 1e9 * clump->volume, by_clump, by_clump * mass_se / mass},
                     {"turned cylinder", 1e3 * turned_mass, 1e9 * turned, by_turned,
                      error(by_turned, turned_d, turned_h, turned_mass)}}});
    sheet.say(fmt::format(
        "The ideal cone is {:.3g} % smaller than the model and its density as much too high: a real cone of "
        "that height and base has a rounded tip, but bulges. With a density of {:.6g} kg/m3 the model weighs "
        "{:.4g} g; the scale says {:.4g} g.",
        100 * (1 - ideal / clump->volume), values["density_kg_m3"], 1e3 * clump->mass, 1e3 * mass));
    sheet.fact("density_cone", by_cone, "kg/m3");
    sheet.fact("density_model", by_clump, "kg/m3");
    sheet.fact("density_turned", by_turned, "kg/m3");
    sheet.fact("volume_model", 1e9 * clump->volume, "mm3");
    sheet.fact("mass_model", 1e3 * clump->mass, "g");
    outcome.recordings.push_back(
        {"weigh",
         {"mass_kg", "volume_m3", "density_kg_m3"},
         {{mass, ideal, by_cone}, {mass, clump->volume, by_clump}, {turned_mass, turned, by_turned}}});
    return outcome;
}

} // namespace

Experiment weigh() {
    return {.name = "weigh",
            .title = "Weighing: mass and volume to density",
            .parameters = {{"mass_g", "g", 4.7, {.lo = 1e-3, .hi = 1e5}, "Mean mass of a particle"},
                           {"mass_sd_g", "g", 0.1, {.lo = 0, .hi = 1e5}, "Scatter of the masses"},
                           {"weighed", "", 100, {.lo = 1, .hi = 1e6}, "How many were weighed (whole number)"},
                           {"height_mm", "mm", 24, {.lo = 0.1, .hi = 1000}, "Height of the ideal cone"},
                           {"base_mm", "mm", 20, {.lo = 0.1, .hi = 1000}, "Diameter of its base"},
                           {"caliper_sd_mm", "mm", 0.05, {.lo = 0, .hi = 10}, "Error of one length"},
                           {"turned_diameter_mm", "mm", 11, {.lo = 0.1, .hi = 1000}, "Diameter of the turned cylinder"},
                           {"turned_length_mm", "mm", 50, {.lo = 0.1, .hi = 1000}, "Its length"},
                           {"turned_mass_g", "g", 7.915, {.lo = 1e-3, .hi = 1e5}, "Its mass"},
                           density_parameter()},
            .perform = perform};
}

} // namespace tumble::lab
