#include "view/plots.h"

#include "observe/series.h"
#include "run/run_folder.h"
#include "run/series_plot.h"
#include "run/tracers.h"

#include <algorithm>

namespace tumble::view {

namespace {

// Beyond so many points every second one goes: a plot is some hundred pixels wide.
constexpr std::size_t most_points = 4000;
constexpr std::size_t height_column = 1; // of TracerReader: y

/// Name of the first body that the scene traces; empty where it traces none.
std::string first_tracer(const scene::Scene& scene) {
    const std::vector<std::string> traced = run::traced_bodies(scene.observe.measures);
    return traced.empty() ? "" : traced.front();
}

render::PlotLine line_of(const observe::Measure& measure, double until) {
    render::PlotLine line;
    line.label = observe::spelled_name(measure.name);
    line.unit = observe::spelled_unit(measure.unit);
    line.until = until;
    return line;
}

render::PlotLine height_line(const std::string& tracer, double until) {
    render::PlotLine line;
    line.label = "height of " + tracer;
    line.unit = "m";
    line.until = until;
    return line;
}

std::vector<observe::Measure> measures_of_plots() {
    auto measures = observe::choose_measures(run::main_measures());
    return measures ? std::move(*measures) : std::vector<observe::Measure>{};
}

} // namespace

Plots Plots::of_simulation(const scene::Scene& scene, const observe::FrameLayout& layout) {
    Plots plots;
    plots.grows_ = true;
    plots.measures_ = measures_of_plots();
    for (const observe::Measure& measure : plots.measures_)
        plots.lines_.push_back(line_of(measure, 0));
    const std::string tracer = first_tracer(scene);
    for (std::size_t s = 0; s < layout.shapes.size(); ++s)
        if (!tracer.empty() && layout.shapes[s].name == tracer) {
            plots.tracer_.emplace(observe::Tracer{.name = tracer, .shape = static_cast<int>(s)});
            plots.lines_.push_back(height_line(tracer, 0));
        }
    return plots;
}

Plots Plots::of_run(const std::filesystem::path& run, const scene::Scene& scene) {
    Plots plots;
    const Result<observe::Series> series = observe::read_series(run::RunFolder{run}.series());
    const std::vector<double>* times = series ? series->find("time_s") : nullptr;
    if (!times)
        return plots;
    const auto add = [&](const std::string& column, render::PlotLine line) {
        const std::vector<double>* values = series->find(column);
        if (!values)
            return;
        line.times = *times;
        line.values = *values;
        plots.lines_.push_back(std::move(line));
    };
    for (const observe::Measure& measure : measures_of_plots())
        add(measure.column(), line_of(measure, scene.duration));
    if (const std::string tracer = first_tracer(scene); !tracer.empty())
        add("tracer:" + tracer + "_y_m", height_line(tracer, scene.duration));
    return plots;
}

void Plots::take(const Moment& moment) {
    const double time = moment.frame.time;
    if (!grows_ || !moment.books || lines_.empty() || (!lines_[0].times.empty() && time <= lines_[0].times.back()))
        return;
    const observe::Seen seen(moment.frame, *moment.books);
    std::vector<double> values;
    for (const observe::Measure& measure : measures_)
        values.push_back(measure.value(seen));
    if (tracer_)
        values.push_back(tracer_->row(moment.frame)[height_column]);
    for (std::size_t i = 0; i < values.size(); ++i) {
        lines_[i].times.push_back(time);
        lines_[i].values.push_back(values[i]);
    }
    if (lines_[0].times.size() > most_points)
        thin_out();
}

void Plots::thin_out() {
    for (render::PlotLine& line : lines_)
        for (std::vector<double>* numbers : {&line.times, &line.values}) {
            const std::size_t half = numbers->size() / 2;
            for (std::size_t i = 0; i < half; ++i)
                (*numbers)[i] = (*numbers)[2 * i];
            numbers->resize(half);
        }
}

} // namespace tumble::view
