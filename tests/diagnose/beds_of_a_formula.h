#pragma once

#include "diagnose/bed_diagnosis.h"
#include "diagnose/verdict.h"
#include "gauss.h"
#include "observe/measures.h"
#include "scene/load.h"

#include <cmath>
#include <fmt/format.h>

/// A bed whose means are known in closed form, so that what a diagnosis finds can be foretold.
namespace tumble::test {

constexpr const char* shaken_box = R"(title = "bed"
dimension = 2
depth_m = 0.1
duration_s = 2
time_step_s = 1e-5
seed = 5
[domain]
lo_m = [-1, -1]
hi_m = [1, 1]
[material.media]
density_kg_m3 = 1000
[pair.media-media]
restitution = 0.5
friction = 0.5
normal_stiffness_N_per_m = 1e5
stiffness_ratio = 0.7
[body.disc]
radius_mm = 5
material = "media"
[[fill]]
body = "disc"
count = 100
region_lo_m = [-0.5, 0]
region_hi_m = [0.5, 1]
[[wall]]
name = "floor"
shape = "segment"
from_m = [-0.9, 0]
to_m = [0.9, 0]
material = "media"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.001
frequency_Hz = 25
[[wall.motion]]
kind = "harmonic"
axis = "x"
amplitude_m = 0.001
frequency_Hz = 25
)";

constexpr double scatter_of_circulation = 0.02; // rad/s, from run to run
constexpr double scatter_of_slope = 1;          // deg

/// circulation = -0.2 sin(phase) (fill / 100), slope = 4 - 3 sin(phase) + 2 tilt deg, and what the seed adds.
inline Result<observe::Series> formula(const scene::Scene& scene) {
    const double phase = scene.walls[0].motion.harmonics[1].phase;
    const double tilt = 57.29577951308232 * std::atan2(scene.gravity.x(), -scene.gravity.y());
    const double fill = static_cast<double>(*scene.fills[0].count) / 100;
    const double all = phase + 3 * tilt + 7 * fill + 11 * scene.pair(0, 0).restitution; // no two beds scatter alike
    Rng rng(scene.seed * 7919 + static_cast<std::uint64_t>(std::llround(1e6 * (all + 100))));
    const double circulation = -0.2 * std::sin(phase) * fill + scatter_of_circulation * gauss(rng);
    const double slope = 4 - 3 * std::sin(phase) + 2 * tilt + scatter_of_slope * gauss(rng);
    observe::Series series;
    series.columns = {"time_s"};
    for (const std::string& name : scene.observe.measures)
        series.columns.push_back(observe::choose_measures({name})->front().column());
    series.values.resize(series.columns.size());
    for (int k = 0; k <= 200; ++k) {
        std::vector<double> row{0.01 * k};
        for (const std::string& name : scene.observe.measures)
            row.push_back(name == "circulation" ? circulation : name == "surface_slope" ? slope : 0);
        series.append(row);
    }
    return series;
}

/// What a laboratory would tell of such a bed: means of so many runs, under two loads.
struct BedLaboratory {
    std::vector<std::string> hidden; // sets that the measurement does not tell of
    int runs = 4;
    std::uint64_t seed = 900;

    [[nodiscard]] diagnose::Measurement measurement() const {
        diagnose::Measurement all;
        all.title = "a bed";
        all.causes = {"exc.phase", "grav.tilt_x", "load.fill", "rest.factor", "grav.tilt_z"};
        for (const char* load : {"fill.0.count=100", "fill.0.count=150"}) {
            diagnose::Bulk bulk{
                .condition = load, .sets = {load}, .from = 1.0, .until = 2.0, .runs = runs, .numbers = {}};
            double circulation = 0, slope = 0;
            for (int k = 0; k < runs; ++k) {
                std::vector<scene::Override> sets{{load},
                                                  {fmt::format("seed={}", seed + static_cast<std::uint64_t>(k))}};
                for (const std::string& set : hidden)
                    sets.push_back({set});
                auto scene = scene::load_scene_text(shaken_box, "box.toml", sets);
                scene->observe.measures = {"circulation", "surface_slope"};
                const auto series = formula(*scene);
                circulation += series->values[1][0] / runs;
                slope += series->values[2][0] / runs;
            }
            bulk.numbers = {{"circulation", "rad_s", circulation, scatter_of_circulation},
                            {"surface_slope", "deg", slope, scatter_of_slope}};
            all.bulks.push_back(std::move(bulk));
        }
        return all;
    }
};

} // namespace tumble::test
