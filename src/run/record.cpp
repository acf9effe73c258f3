#include "run/record.h"

#include "observe/measures.h"
#include "run/schedule.h"
#include "run/simulation.h"

#include <cmath>

namespace tumble::run {

Result<observe::Series> record(const scene::Scene& scene, int threads) {
    const Result<std::vector<observe::Measure>> measures = observe::choose_measures(scene.observe.measures);
    if (!measures)
        return measures.problems();
    Result<SimulationPtr> simulation = simulate(scene, threads);
    if (!simulation)
        return simulation.problems();

    observe::Series series;
    series.columns = {"time_s"};
    for (const observe::Measure& measure : *measures)
        series.columns.push_back(measure.column());
    series.values.resize(series.columns.size());
    Schedule rows(scene.observe.every, scene.time_step);
    const std::int64_t last = std::llround(scene.duration / scene.time_step);
    for (std::int64_t step = 0;; step = rows.next()) {
        step = std::min(step, last);
        if (const auto problem = (*simulation)->advance(step - (*simulation)->steps()))
            return *problem;
        const observe::Frame frame = (*simulation)->frame();
        const observe::Seen seen(frame, (*simulation)->books());
        std::vector<double> row{frame.time};
        for (const observe::Measure& measure : *measures)
            row.push_back(measure.value(seen));
        series.append(row);
        if (step == last)
            return series;
        rows.pass(step);
    }
}

} // namespace tumble::run
