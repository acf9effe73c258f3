#pragma once

#include "../folder.h"
#include "observe/series.h"
#include "run/run_scene.h"
#include "scene/load.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>
#include <vector>

/// Every shipped scene states a claim; here its run is held to it. A granular bed is chaotic: means are held to the
/// scatter of seeds, parts of a run to a band a little wider than the scene has shown.
namespace tumble::test {

inline scene::Scene loaded(const std::string& name, const std::vector<std::string>& sets = {}) {
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({set});
    const auto scene = scene::load_scene(std::filesystem::path(TUMBLE_ROOT) / "scenes" / name, overrides);
    REQUIRE_MESSAGE(scene.ok(), to_string(scene.problems()));
    return *scene;
}

/// What a run of the scene wrote, a column per measure.
struct Ran {
    Folder folder;
    run::RunSummary summary;
    observe::Series series;

    explicit Ran(const scene::Scene& scene) {
        run::RunOptions options;
        options.folder = folder.path / "run";
        run::RunListener silent;
        const auto done = run::run_scene(scene, options, silent);
        REQUIRE_MESSAGE(done.ok(), to_string(done.problems()));
        summary = *done;
        REQUIRE(summary.state == "finished");
        series = observe::read_series(options.folder / "series.csv").value();
    }

    [[nodiscard]] const std::vector<double>& column(const std::string& name) const {
        const std::vector<double>* found = series.find(name);
        REQUIRE_MESSAGE(found != nullptr, name);
        return *found;
    }
    /// Between two rows, straight.
    [[nodiscard]] double at(const std::string& name, double t) const {
        const std::vector<double>&values = column(name), &time = column("time");
        const auto above = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
        REQUIRE(above > 0);
        REQUIRE(above < time.size());
        const double x = (t - time[above - 1]) / (time[above] - time[above - 1]);
        return (1 - x) * values[above - 1] + x * values[above];
    }
    [[nodiscard]] double mean(const std::string& name, double from, double to) const {
        const std::vector<double>& values = column(name);
        double sum = 0;
        int n = 0;
        for (std::size_t row = 0; row < values.size(); ++row)
            if (column("time")[row] > from - 1e-9 && column("time")[row] < to - 1e-9) {
                sum += values[row];
                ++n;
            }
        REQUIRE(n > 0);
        return sum / n;
    }
};

} // namespace tumble::test
