#pragma once

#include "case.h"
#include "diagnose/diagnosis.h"
#include "run/record.h"
#include "scene/read_file.h"
#include "scene/read_toml.h"
#include "told.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

/// A generator's case in tumble's own words, and the diagnosis of it on the real solver.
namespace blind {

namespace dg = tumble::diagnose;

inline dg::SceneText scene_of(Bench bench) {
    const std::filesystem::path file = std::filesystem::path(TUMBLE_ROOT) / "scenes" / scene_of_bench(bench);
    return {*tumble::scene::read_file(file, tumble::scene::largest_scene), file};
}

inline tumble::Result<tumble::observe::Series> on_the_solver(const tumble::scene::Scene& scene) {
    return tumble::run::record(scene);
}

/// As a student would hand it in: files in a folder, read back.
inline tumble::Result<dg::Measurement> handed_in(const Case& made) {
    std::string name = (std::filesystem::temp_directory_path() / "tumble_blind_XXXXXX").string();
    const std::filesystem::path folder = mkdtemp(name.data());
    std::ofstream(folder / "measurement.toml") << made.measurement;
    for (std::size_t k = 0; k < made.files.size(); ++k)
        std::ofstream(folder / made.files[k]) << made.csv[k];
    auto read = dg::load_measurement(folder / "measurement.toml");
    std::filesystem::remove_all(folder);
    return read;
}

inline tumble::Result<dg::Diagnosis> diagnosed(const Case& made) {
    const auto measurement = handed_in(made);
    if (!measurement)
        return measurement.problems();
    return dg::diagnose(scene_of(made.setup.bench), *measurement, on_the_solver);
}

} // namespace blind
