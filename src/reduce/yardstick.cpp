#include "reduce/yardstick.h"

#include "observe/cycle.h"
#include "observe/measures.h"
#include "observe/series.h"
#include "run/flow_report.h"
#include "run/run_folder.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <numeric>

namespace tumble::reduce {

namespace {

constexpr int layers_of_a_bowl = 5; // over its wall
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Stretch {
    double from = 0, until = 0; // s
};

/// Between the last start and the first end of all that moves; from the last body put in where nothing does.
Stretch driven(const scene::Scene& scene) {
    Stretch stretch{0, scene.duration};
    bool moves = false;
    const auto take = [&](const auto& parts) {
        for (const auto& part : parts) {
            moves = true;
            stretch.from = std::max(stretch.from, part.active.start);
            stretch.until = std::min(stretch.until, part.active.stop);
        }
    };
    for (const scene::Wall& wall : scene.walls) {
        take(wall.motion.harmonics);
        take(wall.motion.rotations);
        take(wall.motion.rockings);
        take(wall.motion.linears);
        take(wall.motion.tables);
    }
    for (const scene::Fill& fill : scene.fills)
        if (!moves)
            stretch.from = std::max(stretch.from, fill.until);
    return stretch;
}

/// s, of the slowest vibration; 0: there is none.
double slowest_period(const scene::Scene& scene) {
    double period = 0;
    for (const scene::Wall& wall : scene.walls)
        for (const scene::Harmonic& part : wall.motion.harmonics)
            period = std::max(period, 1 / part.frequency);
    return period;
}

/// The second half, by when the bulk has forgotten how it lay. A shaken bed may answer every second shake alike.
Stretch second_half(const scene::Scene& scene) {
    Stretch stretch = driven(scene);
    const double half = (stretch.until - stretch.from) / 2, pair = 2 * slowest_period(scene);
    const double whole = pair > 0 ? std::floor(half / pair + 1e-9) * pair : half;
    stretch.from = stretch.until - (whole > 0 ? whole : half);
    return stretch;
}

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
            return grid;
        }
    return std::nullopt;
}

/// Over rows after `from` up to `until`: a stretch of whole periods holds each phase once. A row stands at the step
/// nearest to its time, so that half of what lies between rows decides. What has no meaning in some rows (a slope while
/// bodies fly) is left out there, and has none at all where it has none in most.
double mean(const std::vector<double>& times, const std::vector<double>& values, const Stretch& stretch, double every) {
    double sum = 0;
    int rows = 0, with_value = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] > stretch.from + every / 2 && times[i] <= stretch.until + every / 2) {
            ++rows;
            if (std::isfinite(values[i])) {
                sum += values[i];
                ++with_value;
            }
        }
    return 2 * with_value > rows ? sum / with_value : nothing;
}

observe::Cycle cycle_in(const std::vector<double>& times, const std::vector<double>& values, const Stretch& stretch) {
    const auto first = std::upper_bound(times.begin(), times.end(), stretch.from) - times.begin();
    const auto skip = static_cast<std::size_t>(first);
    return observe::find_cycle(std::span(times).subspan(skip), std::span(values).subspan(skip));
}

} // namespace

Result<Yardstick> Yardstick::of(const scene::Scene& scene, const std::vector<std::string>& more,
                                std::optional<double> from, std::optional<double> until) {
    using From = Quantity::From;
    Yardstick stick;
    const Stretch stretch = second_half(scene);
    stick.from_ = from.value_or(stretch.from);
    stick.until_ = std::min(until.value_or(stretch.until), scene.duration);
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
    } else {
        (void)add("circulation");
        (void)add("surface_slope");
    }
    for (const std::string& name : scene.observe.measures)
        if (name.starts_with("tracer:")) {
            stick.measures_.push_back(name);
            const std::string body = name.substr(7);
            stick.quantities_.push_back({body + " cycle", "s", From::cycle, name + "_y"});
            stick.quantities_.push_back({body + " amplitude", "m", From::amplitude, name + "_y"});
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
    const Stretch stretch{from_, until_};
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
    const std::vector<double>& times = series->values.front();
    std::vector<double> values;
    for (const Quantity& quantity : quantities_) {
        if (quantity.from == Quantity::From::layer_speed) {
            values.push_back(flow->field.layer(quantity.layer).mean_speed());
            continue;
        }
        const std::vector<double>* column = series->find(quantity.column);
        if (!column)
            values.push_back(nothing);
        else if (quantity.from == Quantity::From::cycle)
            values.push_back(cycle_in(times, *column, stretch).period);
        else if (quantity.from == Quantity::From::amplitude)
            values.push_back(cycle_in(times, *column, stretch).peak_to_peak);
        else
            values.push_back(mean(times, *column, stretch, every_) /
                             (quantity.from == Quantity::From::energy_per_mass ? mass : 1));
    }
    return values;
}

} // namespace tumble::reduce
