#include "base/table.h"
#include "lab/bench.h"
#include "lab/each.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::lab {

namespace {

constexpr std::array<Unit, 2> force_units{{{"N", 1}, {"kN", 1e3}}};
constexpr double curved = 4; // standard errors of the bend that make the record no straight line

/// Does y bend? A parabola's term beside its standard error, after the straight line.
double bend_in_errors(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<Eigen::Index>(x.size());
    if (n < 5)
        return 0;
    const Eigen::Map<const Eigen::VectorXd> a(x.data(), n), b(y.data(), n);
    const Eigen::VectorXd scaled = (a.array() - a.mean()) / std::max(a.array().abs().maxCoeff(), 1e-300);
    Eigen::MatrixXd basis(n, 3);
    basis << Eigen::VectorXd::Ones(n), scaled, scaled.array().square().matrix();
    const Eigen::Matrix3d gram = basis.transpose() * basis;
    const Eigen::Vector3d fitted = gram.ldlt().solve(basis.transpose() * b);
    const double noise = (b - basis * fitted).squaredNorm() / static_cast<double>(n - 3);
    return std::abs(fitted[2]) / std::sqrt(std::max(noise * gram.inverse()(2, 2), 1e-300));
}

Result<Outcome> evaluate(const Table& table, const Values& values) {
    Problems problems;
    const auto column = [&](Result<std::vector<double>> read) {
        if (read)
            return std::move(*read);
        const Problems more = read.problems();
        problems.insert(problems.end(), more.begin(), more.end());
        return std::vector<double>{};
    };
    const bool across_given =
        std::find(table.heads().begin(), table.heads().end(), "strain_across") != table.heads().end();
    const std::vector<double> force = column(table.quantity("force", force_units)),
                              along = column(table.numbers("strain"));
    const std::vector<double> across = across_given ? column(table.numbers("strain_across")) : std::vector<double>{};
    if (!problems.empty())
        return problems;
    if (force.size() < 3)
        return Problem{.file = table.file(), .what = "fewer than three rows", .fix = "record the load while it rises"};
    const double section = std::numbers::pi / 4 * std::pow(1e-3 * values["diameter_mm"], 2);
    std::vector<double> stress;
    for (const double one : force)
        stress.push_back(one / section);
    const Line elastic = line_through(along, stress);
    if (!std::isfinite(elastic.slope))
        return Problem{.file = table.file(), .what = "the strain never changes", .fix = "check the strain gauge"};

    Outcome outcome;
    Sheet& sheet = outcome.sheet;
    sheet.say(fmt::format(
        "{}: {} rows. Young's modulus is the slope of stress over strain, Poisson's ratio that of the strain across "
        "over the strain along, both with an offset of their own: gauges are zeroed by hand.",
        table.file(), force.size()));
    sheet.formula("E = σ / ε,   ν = −ε_x / ε_y", "(4.2), (4.3)");
    sheet::Grid grid{
        {{""}, {"value", "", 4}, {"±", "", 2}, {"unit"}},
        {{"section", 1e6 * section, 0.0, "mm2"}, {"Young's modulus", elastic.slope, elastic.slope_se, "Pa"}}};
    sheet.fact("youngs_modulus", elastic.slope, "Pa");
    sheet.fact("youngs_modulus_se", elastic.slope_se, "Pa");
    if (across_given) {
        const Line ratio = line_through(along, across);
        grid.rows.push_back({"Poisson's ratio", -ratio.slope, ratio.slope_se, ""});
        sheet.fact("poisson_ratio", -ratio.slope);
        sheet.fact("poisson_ratio_se", ratio.slope_se);
        if (-ratio.slope < 0 || -ratio.slope > 0.5)
            sheet.say("Warning: no elastic and isotropic solid has a Poisson's ratio outside 0 to 0.5: are the two "
                      "gauges swapped, or "
                      "both counted positive?");
    }
    sheet.parts.emplace_back(grid);
    const double bend = bend_in_errors(along, stress);
    sheet.fact("bend_in_errors", bend);
    if (bend > curved)
        sheet.say(fmt::format(
            "Warning: the record bends ({:.3g} standard errors): the specimen slips in its clamps, yields, or is not "
            "yet seated. Cut the record to its straight part.",
            bend));
    sheet::Figure figure{.name = "tension",
                         .title = "Stress over strain",
                         .x = {"strain", "%"},
                         .y = {"stress", "MPa"},
                         .curves = {{"record", sheet::Style::points}, {"straight line", sheet::Style::line}}};
    for (std::size_t k = 0; k < along.size(); ++k) {
        figure.curves[0].add(100 * along[k], 1e-6 * stress[k]);
        figure.curves[1].add(100 * along[k], 1e-6 * (elastic.intercept + elastic.slope * along[k]));
    }
    sheet.parts.emplace_back(figure);
    return outcome;
}

/// Without a record: what a machine would write of a bar that obeys Hooke, evaluated as any record is.
Result<Outcome> perform(const Values& values) {
    const double section = std::numbers::pi / 4 * std::pow(1e-3 * values["diameter_mm"], 2);
    const double largest = values["largest_N"];
    Recording record{"tension", {"force_N", "strain", "strain_across"}};
    for (int k = 0; k <= 50; ++k) {
        const double force = largest * k / 50, strain = force / section / values["youngs_modulus_Pa"];
        record.rows.push_back({force, strain, -values["poisson_ratio"] * strain});
    }
    const Result<Table> table = parse_table(record.csv(), "the bar of these parameters");
    Result<Outcome> outcome = evaluate(*table, values);
    if (!outcome)
        return outcome.problems();
    outcome->sheet.say(
        "A rigid body does not stretch: there is no solver behind this bar, only Hooke's law, so that the evaluation "
        "can be tried. `--record` evaluates a real one; `tumble lab press` presses bodies with the solver.");
    outcome->recordings.push_back(std::move(record));
    return outcome;
}

} // namespace

Experiment tension() {
    return {.name = "tension",
            .title = "Tension and compression records to Young's modulus and Poisson's ratio",
            .parameters = {{"diameter_mm", "mm", 11, {.lo = 0.1, .hi = 1000}, "Diameter of the round specimen"},
                           {"largest_N", "N", 500, {.lo = -1e6, .hi = 1e6}, "Load at the end, of the bar that is made"},
                           modulus_parameter(4.6e9),
                           poisson_parameter()},
            .perform = perform,
            .evaluate = evaluate,
            .record_form = "force_N, strain and perhaps strain_across"};
}

} // namespace tumble::lab
