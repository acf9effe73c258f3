#include "lab/bench.h"
#include "lab/each.h"
#include "run/simulation.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

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

/// Volume of the box that holds the spheres, m3.
double box_of(const std::vector<scene::Sphere>& spheres) {
    Eigen::AlignedBox3d box;
    for (const scene::Sphere& sphere : spheres) {
        box.extend(sphere.centre - Vector3d::Constant(sphere.radius));
        box.extend(sphere.centre + Vector3d::Constant(sphere.radius));
    }
    return box.volume();
}

/// One way to a density, SI.
struct Way {
    std::string name;
    double mass = 0, volume = 0;
    double error = 0; // share, standard

    [[nodiscard]] double density() const { return mass / volume; }
};

/// A body of revolution whose volume is `form` d^2 l: first order of 2 sigma_d / d, sigma_l / l and sigma_m / m.
Way turned_way(const std::string& name, double form, double d, double l, double mass, const Values& values) {
    const double ruler = 1e-3 * values["length_error_mm"], scale = 1e-3 * values["mass_error_g"];
    return {name, mass, form * d * d * l,
            std::sqrt(std::pow(2 * ruler / d, 2) + std::pow(ruler / l, 2) + std::pow(scale / mass, 2))};
}

void say_ways(Sheet& sheet, const std::vector<Way>& ways, double printed) {
    sheet::Grid grid{{{"way"},
                      {"mass", "g", 4},
                      {"volume", "mm3", 5},
                      {"density", "kg/m3", 5},
                      {"±", "kg/m3", 2},
                      {fmt::format("standard errors from {:.6g}", printed), "", 2}}};
    for (const Way& way : ways) {
        const double error = way.error * way.density();
        grid.rows.push_back(
            {way.name, 1e3 * way.mass, 1e9 * way.volume, way.density(), error, (way.density() - printed) / error});
    }
    sheet.parts.emplace_back(grid);
}

/// The cylinder of a lathe, if its size and mass are known; none, or all three of them: else a problem.
Result<std::optional<Way>> cylinder(const Values& values) {
    const double d = 1e-3 * values["turned_diameter_mm"], l = 1e-3 * values["turned_length_mm"],
                 mass = 1e-3 * values["turned_mass_g"];
    if (d == 0 && l == 0 && mass == 0)
        return std::optional<Way>{};
    if (d == 0 || l == 0 || mass == 0)
        return Problem{.key = d == 0   ? "--turned_diameter_mm"
                              : l == 0 ? "--turned_length_mm"
                                       : "--turned_mass_g",
                       .what = "is missing: a turned cylinder has a diameter, a length and a mass",
                       .fix = "give all three, or none"};
    return std::optional<Way>{turned_way("turned cylinder", pi / 4, d, l, mass, values)};
}

Result<Outcome> perform(const Values& values) {
    const double mass = 1e-3 * values["mass_g"], printed = values["density_kg_m3"];
    const std::vector<scene::Sphere> spheres = cone_of_spheres();
    const Result<run::SimulatedBody> clump = solved(spheres, printed);
    if (!clump)
        return clump.problems();
    const auto turned = cylinder(values);
    if (!turned)
        return turned.problems();
    std::vector<Way> ways{
        turned_way("ideal cone", pi / 12, 1e-3 * values["base_mm"], 1e-3 * values["height_mm"], mass, values),
        {"65 spheres", mass, clump->volume, 1e-3 * values["mass_error_g"] / mass}};
    if (*turned)
        ways.push_back(**turned);

    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say("Density is mass over volume, and the volume is what is hard. Three ways, as the thesis went: the "
              "particle taken for an ideal cone; a closer model of its shape, here the 65 spheres that the solver "
              "moves, overlaps counted once; and a cylinder turned out of the same material on a lathe.");
    sheet.formula("ideal cone V = π d² h / 12,   cylinder V = π d² l / 4");
    say_ways(sheet, ways, printed);
    sheet.say(
        fmt::format("The ideal cone's volume is {:.3g} % below the model's, so its density is {:.3g} % above: a real "
                    "cone of that height and base has a rounded tip, but bulges. With a density of {:.6g} kg/m3 "
                    "the model weighs {:.4g} g; the scale says {:.4g} g. The error of the model's density is the "
                    "mass' alone: how well the spheres fill the particle is not known.",
                    100 * (1 - ways[0].volume / ways[1].volume), 100 * (ways[0].density() / ways[1].density() - 1),
                    printed, 1e3 * clump->mass, 1e3 * mass));
    if (!*turned)
        sheet.say("The thesis prints neither size nor mass of its turned cylinders, only the average of "
                  "their densities, 1665.71 kg/m3: nothing can be computed again there. The other two rest "
                  "on what it does print, 4.7 g, 24 mm and 20 mm (table 5.1) and the spheres of appendix "
                  "B.5; their errors are those of the last digit in print. A cylinder of your own: "
                  "--turned_diameter_mm, --turned_length_mm, --turned_mass_g.");
    sheet.fact("density_cone", ways[0].density(), "kg/m3");
    sheet.fact("density_cone_error", ways[0].error * ways[0].density(), "kg/m3");
    sheet.fact("density_model", ways[1].density(), "kg/m3");
    sheet.fact("density_model_error", ways[1].error * ways[1].density(), "kg/m3");
    if (*turned)
        sheet.fact("density_turned", ways[2].density(), "kg/m3");
    sheet.fact("volume_model", 1e9 * clump->volume, "mm3");
    sheet.fact("box_model", 1e9 * box_of(spheres), "mm3");
    sheet.fact("mass_model", 1e3 * clump->mass, "g");
    Recording recording{"weigh", {"mass_kg", "volume_m3", "density_kg_m3"}};
    for (const Way& way : ways)
        recording.rows.push_back({way.mass, way.volume, way.density()});
    outcome.recordings.push_back(std::move(recording));
    return outcome;
}

} // namespace

Experiment weigh() {
    return {
        .name = "weigh",
        .title = "Weighing: mass and volume to density",
        .parameters =
            {{"mass_g", "g", 4.7, {.lo = 1e-3, .hi = 1e5}, "Mean mass of a particle"},
             {"mass_error_g", "g", 0.03, {.lo = 1e-6, .hi = 1e5}, "Standard error of a mass; 0.03: printed to 0.1 g"},
             {"height_mm", "mm", 24, {.lo = 0.1, .hi = 1000}, "Height of the ideal cone"},
             {"base_mm", "mm", 20, {.lo = 0.1, .hi = 1000}, "Diameter of its base"},
             {"length_error_mm", "mm", 0.3, {.lo = 0, .hi = 10}, "Standard error of a length; 0.3: printed to 1 mm"},
             {"turned_diameter_mm", "mm", 0, {.lo = 0, .hi = 1000}, "Diameter of a turned cylinder; 0: there is none"},
             {"turned_length_mm", "mm", 0, {.lo = 0, .hi = 1000}, "Its length"},
             {"turned_mass_g", "g", 0, {.lo = 0, .hi = 1e5}, "Its mass"},
             density_parameter()},
        .perform = perform};
}

} // namespace tumble::lab
