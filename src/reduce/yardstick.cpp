#include "reduce/yardstick.h"

#include "observe/cycle.h"
#include "observe/mean_over.h"
#include "observe/measures.h"
#include "run/flow_report.h"
#include "run/run_folder.h"
#include "scene/settled.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::reduce {

namespace {

constexpr int layers_of_a_bowl = 5;  // over its wall
constexpr int rings_of_a_bowl = 5;   // the innermost a twentyfifth of its area
constexpr double least_share = 0.01; // of the mass: a layer with less holds what flies
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::optional<observe::FlowGrid> layers_for(const scene::Scene& scene) {
    for (const scene::Wall& wall : scene.walls)
        if (const auto* bowl = std::get_if<scene::BowlShape>(&wall.shape)) {
            observe::FlowGrid grid;
            grid.axis_x = bowl->base.x();
            grid.axis_z = bowl->base.z();
            grid.radius = bowl->radius;
            grid.lo = bowl->base.y();
            grid.hi = bowl->base.y() + bowl->height;
            grid.layers = layers_of_a_bowl;
            grid.rings = rings_of_a_bowl;
            return grid;
        }
    return std::nullopt;
}

/// How fast the media sink in the innermost ring, all layers together, m/s.
double fall_at_axis(const observe::FlowField& field) {
    observe::FlowCell column;
    for (int layer = 0; layer < field.grid().layers; ++layer)
        column += field.cell(0, layer);
    return -column.mean_velocity().z();
}

/// m/s; NaN where the layer holds next to nothing.
double layer_speed(const observe::FlowField& field, int layer) {
    double mass = 0;
    for (int other = 0; other < field.grid().layers; ++other)
        mass += field.layer(other).mass;
    const observe::FlowCell cell = field.layer(layer);
    return cell.mass < least_share * mass ? nothing : cell.mean_speed();
}

double of_flow(const Quantity& quantity, const observe::FlowField& field) {
    switch (quantity.from) {
    case Quantity::From::vortex_depth:
        return observe::vortex_depth(field);
    case Quantity::From::fall_at_axis:
        return fall_at_axis(field);
    default:
        return layer_speed(field, quantity.layer);
    }
}

/// Of the rows within, which may stand a step late.
observe::Cycle cycle_in(const std::vector<double>& times, const std::vector<double>& values,
                        const scene::Stretch& stretch, double every) {
    const auto row_at = [&](double time) {
        return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time + every / 2) - times.begin());
    };
    const std::size_t first = row_at(stretch.from), count = row_at(stretch.until) - first;
    return observe::find_cycle(std::span(times).subspan(first, count), std::span(values).subspan(first, count));
}

} // namespace

Result<Yardstick> Yardstick::of(const scene::Scene& scene, const std::vector<std::string>& more,
                                std::optional<double> from, std::optional<double> until) {
    using From = Quantity::From;
    Yardstick stick;
    const scene::Stretch stretch = scene::settled(scene);
    stick.from_ = from.value_or(stretch.from);
    stick.until_ = std::min(until.value_or(stretch.until), scene.duration);
    const scene::Stretch driven = scene::driven(scene);
    stick.paths_from_ = from.value_or(driven.from + (driven.until - driven.from) / 4);
    Problems problems;
    if (!(stick.until_ - stick.from_ >= 2 * scene.observe.every))
        problems.push_back({.what = fmt::format("from {:.4g} to {:.4g} s there are fewer than two rows of series.csv",
                                                stick.from_, stick.until_),
                            .fix = "give a longer --time, a longer duration_s or a smaller observe.every_s"});
    stick.every_ = scene.observe.every;
    stick.layers_ = layers_for(scene);
    stick.measures_ = {"kinetic_energy"};
    stick.quantities_.push_back({"kinetic energy per mass", "J/kg", From::energy_per_mass, "kinetic_energy"});
    const auto add = [&](const std::string& name) -> Problems {
        const auto found = observe::choose_measures({name});
        if (!found)
            return found.problems();
        for (const observe::Measure& measure : *found) {
            stick.measures_.push_back(measure.name);
            stick.quantities_.push_back(
                {observe::spelled_name(measure.name), observe::spelled_unit(measure.unit), From::column, measure.name});
        }
        return {};
    };
    if (stick.layers_) {
        (void)add("rms_velocity_y");
        for (int layer = 0; layer < stick.layers_->layers; ++layer) {
            const double height = 1e3 * stick.layers_->layer_height();
            stick.quantities_.push_back({fmt::format("speed {:.0f} to {:.0f} mm", layer * height, (layer + 1) * height),
                                         "m/s", From::layer_speed, "", layer});
        }
        stick.quantities_.push_back({"vortex depth", "m", From::vortex_depth});
        stick.quantities_.push_back({"fall at the axis", "m/s", From::fall_at_axis});
    } else {
        (void)add("circulation");
        (void)add("surface_slope");
    }
    for (const std::string& name : scene.observe.measures)
        if (name.starts_with("tracer:")) {
            stick.measures_.push_back(name);
            const std::string body = name.substr(7);
            stick.quantities_.push_back({body + " cycle", "s", From::cycle, name + "_y"});
            stick.quantities_.push_back({body + " peak to peak", "m", From::peak_to_peak, name + "_y"});
        }
    for (const std::string& name : more)
        for (const Problem& problem : add(name))
            problems.push_back(problem);
    if (!problems.empty())
        return problems;
    return stick;
}

void Yardstick::prepare(scene::Scene& scene) const {
    scene.observe.measures = measures_;
    if (!layers_)
        scene.render.every = scene.duration; // frames are read for layers only
}

Result<std::vector<double>> Yardstick::read(const std::filesystem::path& run, double mass) const {
    const auto series = observe::read_series(run::RunFolder{run}.series());
    if (!series)
        return series.problems();
    std::optional<run::FlowReport> flow;
    if (layers_) {
        run::FlowOptions options{.grid = *layers_, .bodies = {}, .when = {}};
        options.when.from = from_;
        options.when.to = until_;
        auto read = run::read_flow(run, options, [](std::int64_t, std::int64_t) {});
        if (!read)
            return read.problems();
        flow = std::move(*read);
    }
    std::vector<double> values;
    for (const Quantity& quantity : quantities_)
        values.push_back(quantity.column.empty() ? of_flow(quantity, flow->field) : of_series(quantity, *series, mass));
    return values;
}

double Yardstick::of_series(const Quantity& quantity, const observe::Series& series, double mass) const {
    const std::vector<double>& times = series.values.front();
    const std::vector<double>* column = series.find(quantity.column);
    if (!column)
        return nothing;
    if (quantity.from == Quantity::From::cycle)
        return cycle_in(times, *column, {paths_from_, until_}, every_).period;
    if (quantity.from == Quantity::From::peak_to_peak)
        return cycle_in(times, *column, {paths_from_, until_}, every_).peak_to_peak;
    return observe::mean_over(times, *column, from_, until_, every_) /
           (quantity.from == Quantity::From::energy_per_mass ? mass : 1);
}

} // namespace tumble::reduce
