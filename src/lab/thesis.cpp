#include "base/column.h"
#include "lab/bench.h"
#include "lab/each.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

/// The tables of chapter 4 of the thesis (A. Lopez Marrero, LJMU 2020), computed again from their own numbers.
namespace tumble::lab {

namespace {

/// Tables 4.2 to 4.5: ten best drops of a media sphere from 200 mm onto each surface.
struct Surface {
    const char* name;
    std::array<double, 10> rebound; // mm, table 4.2
    std::array<double, 10> printed; // table 4.3
    double mean, sd;                // tables 4.4 and 4.5
};
constexpr double fell = 200; // mm
const std::array<Surface, 3> surfaces{{{"media",
                                        {80, 98, 94, 89, 89, 88, 87, 90, 87, 96},
                                        {0.632, 0.700, 0.686, 0.667, 0.667, 0.663, 0.660, 0.671, 0.660, 0.693},
                                        0.667,
                                        0.019},
                                       {"steel",
                                        {83, 86, 92, 101, 92, 83, 93, 82, 100, 81},
                                        {0.644, 0.656, 0.678, 0.711, 0.678, 0.644, 0.682, 0.640, 0.707, 0.636},
                                        0.668,
                                        0.028},
                                       {"AM titanium",
                                        {129, 120, 128, 128, 124, 129, 125, 128, 127, 125},
                                        {0.803, 0.775, 0.800, 0.800, 0.787, 0.803, 0.791, 0.800, 0.797, 0.791},
                                        0.795,
                                        0.13}}};

/// Would our number, rounded as the print is, be printed as it is?
std::string verdict(double ours, double printed, double unit) {
    return std::abs(ours - printed) <= 0.5 * unit * (1 + 1e-9) ? "as printed" : "differs";
}

void restitutions(Outcome& outcome) {
    Sheet& sheet = outcome.sheet;
    sheet.head("Restitution from rebound heights, tables 4.2 to 4.5");
    sheet.formula("e = sqrt(h₂ / h₁), h₁ = 200 mm", "(4.7)");
    Recording table{"restitution", {"surface", "rebound_m", "restitution", "printed"}};
    sheet::Grid grid{{{"surface"},
                      {"drops as printed"},
                      {"mean e", "", 4},
                      {"printed"},
                      {""},
                      {"standard deviation", "", 3},
                      {"printed"},
                      {""}}};
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const Surface& surface = surfaces[s];
        std::vector<double> e;
        int same = 0;
        for (std::size_t k = 0; k < surface.rebound.size(); ++k) {
            e.push_back(std::sqrt(surface.rebound[k] / fell));
            same += verdict(e.back(), surface.printed[k], 1e-3) == "as printed" ? 1 : 0;
            table.rows.push_back({static_cast<double>(s), 1e-3 * surface.rebound[k], e.back(), surface.printed[k]});
        }
        const Spread spread = spread_of(e);
        const double digit = surface.sd > 0.1 ? 1e-2 : 1e-3;
        grid.rows.push_back({surface.name, fmt::format("{} of {}", same, e.size()), spread.mean,
                             fmt::format("{:.3f}", surface.mean), verdict(spread.mean, surface.mean, 1e-3),
                             spread.deviation, fmt::format("{:g}", surface.sd),
                             verdict(spread.deviation, surface.sd, digit)});
        sheet.fact(fmt::format("mean_{}", s), spread.mean);
        sheet.fact(fmt::format("sd_{}", s), spread.deviation);
        sheet.fact(fmt::format("printed_mean_{}", s), surface.mean);
        sheet.fact(fmt::format("same_{}", s), same);
    }
    sheet.parts.emplace_back(grid);
    sheet.say("Every value of table 4.3 follows from table 4.2. The average for media does not follow from either: the "
              "ten values "
              "average 0.670, not 0.667 (the scripts use 0.67). The standard deviation of AM titanium is 0.0090, not "
              "0.13: the "
              "text's explanation, a rough surface, is for a number that is not there. Titanium scatters least of the "
              "three.");
    sheet.say("What ten drops cannot say: they are the ten best of fifty, chosen for a straight rebound without spin, "
              "and all fell "
              "from one height. A real body keeps back energy for spin, so the choice favours high values; and one "
              "height cannot "
              "tell restitution from drag or from a ruler that is off (`tumble lab drop`).");
    outcome.recordings.push_back(std::move(table));
}

/// How high the thesis' sphere rebounds from 200 mm under this restitution, mm, run by the solver.
Result<double> rebound(double restitution) {
    const Experiment experiment = drop();
    const auto values = read_values(experiment, {{"heights", "1"},
                                                 {"lowest_mm", "200"},
                                                 {"bounces", "1"},
                                                 {"youngs_modulus_Pa", "4.6e8"},
                                                 {"restitution", fmt::format("{:.17g}", restitution)}});
    if (!values)
        return values.problems();
    const Result<Outcome> outcome = experiment.perform(*values);
    if (!outcome)
        return outcome.problems();
    return outcome->sheet.fact("first_rebound");
}

std::optional<Problem> lining(Outcome& outcome) {
    Sheet& sheet = outcome.sheet;
    sheet.head("Restitution on the lining, tables 5.1, 6.2 and 6.3");
    sheet.say("The simulations use 0.159 for media on lining; no drop on lining is printed, and the text says that the "
              "lining "
              "dissipates less than media or steel. Three readings of 0.159, each dropped by the solver from 200 mm:");
    sheet::Grid grid{{{"reading"}, {"e", "", 4}, {"rebound", "mm", 4}, {"e² h", "mm", 4}, {"less lossy than media?"}}};
    const std::array<std::pair<const char*, double>, 3> readings{
        {{"0.159 is e", 0.159},
         {"0.159 is h₂ / h₁, the root forgotten", std::sqrt(0.159)},
         {"0.159 is the share of energy lost", std::sqrt(1 - 0.159)}}};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto& [reading, e] = readings[k];
        const Result<double> seen = rebound(e);
        if (!seen)
            return seen.problems().front();
        grid.rows.push_back({reading, e, *seen, fell * e * e, e > 0.67 ? "yes" : "no"});
        sheet.fact(fmt::format("lining_rebound_{}", k), *seen, "mm");
    }
    sheet.parts.emplace_back(grid);
    sheet.say("Only the last agrees with the text. One drop on the lining, read to a centimetre, would decide.");
    return std::nullopt;
}

void frictions(Outcome& outcome) {
    Sheet& sheet = outcome.sheet;
    Recording table{"friction", {"friction", "friction_sd", "angle_deg", "angle_sd_deg"}};
    sheet.head("Friction from sliding angles, table 4.1");
    sheet.formula("μ = tan α, ± from Δα = Δμ / (1 + μ²)", "4.2.2");
    struct Pair {
        const char* name;
        double friction, sd;
    };
    sheet::Grid grid{
        {{"pair"}, {"friction", "", 3}, {"±", "", 2}, {"angle", "deg", 4}, {"±", "deg", 2}, {"relative", "%", 2}}};
    for (const Pair& pair : {Pair{"media-media", 0.58, 0.039}, Pair{"media-sensor", 0.34, 0.051},
                             Pair{"media-wall", 0.86, 0.094}, Pair{"sensor-wall", 0.86, 0.073}}) {
        const double angle = degrees * std::atan(pair.friction),
                     error = degrees * pair.sd / (1 + pair.friction * pair.friction);
        grid.rows.push_back({pair.name, pair.friction, pair.sd, angle, error, 100 * pair.sd / pair.friction});
        table.rows.push_back({pair.friction, pair.sd, angle, error});
    }
    outcome.recordings.push_back(std::move(table));
    sheet.parts.emplace_back(grid);
    sheet.say("The angles themselves are not printed. The parametric curve of figure 4.7 is the tangent (`tumble lab "
              "slide`), so ten "
              "simulations were not needed to read it. The program of appendix A that is printed stores the time where "
              "it means the "
              "angle (`angLimit = outputData.iloc[i,0]`).");
}

void elasticity(Sheet& sheet) {
    using std::numbers::pi;
    sheet.head("Elasticity, sections 4.1.3 to 4.1.6");
    const double slender = pi / 4 * 0.011 * 0.011, stout = pi / 4 * 0.035 * 0.035;
    sheet.parts.emplace_back(sheet::Grid{
        {{""}, {"ours", "", 4}, {"printed"}, {"unit"}, {""}},
        {{"section of the tensile specimen, 11 mm", slender, "9.5e-5", "m2", verdict(slender, 9.5e-5, 1e-6)},
         {"section of the compression specimen, 35 mm", stout, "9.6e-4", "m2", verdict(stout, 9.6e-4, 1e-5)},
         {"tension beside compression, |0.8 - 4.6| / 4.6", 100 * std::abs(0.821 - 4.6) / 4.6, "82", "%",
          verdict(100 * std::abs(0.821 - 4.6) / 4.6, 82, 1)},
         {"Poisson's ratio of tables 5.1 and 6.2", 0.2887, "0.265", "", verdict(0.2887, 0.265, 1e-3)}}});
    sheet.say(
        "Poisson's ratio was measured as 0.2887 and simulated as that (appendix B.6); tables 5.1 and 6.2 print 0.265.");
}

/// What the thesis prints of masses and densities.
constexpr double turned_density = 1665.71;           // kg/m3, average of its turned cylinders: table 5.1
constexpr double filled_mass = 22.892223;            // kg, of all particles of its simulation: table 5.2
constexpr int filled_count = 4878, points = 100'000; // of them; drawn for each one's volume: ntry of appendix B.6

std::optional<Problem> densities(Sheet& sheet) {
    sheet.head("Density, section 4.3 and table 5.1");
    const Experiment experiment = weigh();
    const Result<Outcome> weighed = experiment.perform(*read_values(experiment));
    if (!weighed)
        return weighed.problems().front();
    const auto found = [&](const char* name) { return weighed->sheet.fact(name); };
    const double by_cone = found("density_cone"), cone_error = found("density_cone_error"),
                 by_model = found("density_model"), model_error = found("density_model_error");
    sheet.parts.emplace_back(sheet::Grid{
        {{"way"}, {"density", "kg/m3", 5}, {"±", "kg/m3", 2}, {"beside 1665.71 kg/m3", "%", 3}},
        {{"ideal cone of 24 mm on 20 mm, 4.7 g", by_cone, cone_error, 100 * (by_cone / turned_density - 1)},
         {"the 65 spheres of appendix B.5, 4.7 g", by_model, model_error, 100 * (by_model / turned_density - 1)},
         {"cylinders turned on a lathe (printed)", turned_density, "not printed", 0.0}}});
    const double volume = found("volume_model"), counted = 1e9 * filled_mass / filled_count / turned_density,
                 share = volume / found("box_model"), chance = std::sqrt((1 - share) / (share * points));
    for (const auto& [name, value] : {std::pair{"density_cone", by_cone}, {"density_model", by_model}})
        sheet.fact(name, value, "kg/m3");
    sheet.fact("density_printed", turned_density, "kg/m3");
    sheet.fact("volume_counted", counted, "mm3");
    sheet.fact("volume_counted_errors", (counted / volume - 1) / chance);
    sheet.say(fmt::format(
        "The values of figure 4.9 are not printed but for the last, and of the cylinders neither size nor mass is: "
        "that "
        "one cannot be computed again. From the printed mass and sizes, with the errors of their last digits, the "
        "ideal cone comes out {:.2g} standard errors too dense, as the text complains; the spheres that were simulated "
        "agree with the lathe within {:.1g}.",
        (by_cone - turned_density) / cone_error, std::abs(by_model - turned_density) / model_error));
    sheet.say(fmt::format(
        "The simulation's own mass, {:.8g} kg in {} particles (table 5.2), is {:.5g} mm3 of {:.6g} kg/m3 each; the "
        "union "
        "of the 65 spheres is {:.5g} mm3. LIGGGHTS counted it with {} points, which makes {:.2g} % of chance: the "
        "difference is {:.2g} %.",
        filled_mass, filled_count, counted, turned_density, volume, points, 100 * chance,
        100 * (counted / volume - 1)));
    return std::nullopt;
}

Result<Outcome> perform(const Values&) {
    Outcome outcome;
    outcome.sheet.say(
        "Chapter 4 of A. Lopez Marrero, \"A New Simulation Tool for the Predictive Assessment of Fluidized and "
        "Circulatory Granular Flow Behaviour\", LJMU 2020: its tables computed again from their own numbers.");
    restitutions(outcome);
    if (auto problem = lining(outcome))
        return *problem;
    frictions(outcome);
    if (auto problem = densities(outcome.sheet))
        return *problem;
    elasticity(outcome.sheet);
    return outcome;
}

} // namespace

Experiment thesis() {
    return {.name = "thesis", .title = "The thesis' own tables, worked through", .parameters = {}, .perform = perform};
}

} // namespace tumble::lab
