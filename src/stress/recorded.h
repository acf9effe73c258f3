#pragma once

#include "base/problem.h"
#include "fem/brick.h"
#include "run/part_loads.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace tumble::stress {

/// A scene, its specimen, and the loads on it.
struct Recorded {
    scene::Scene scene;
    int wall = 0; // the specimen, into scene.walls
    run::PartLoads loads;
    std::filesystem::path frames{}; // folder with a frame an instant; empty: none were kept

    [[nodiscard]] const scene::SpecimenShape& specimen() const;
    [[nodiscard]] const std::string& name() const;
};

/// Nothing recorded yet. Problems: those of run::find_specimen.
Result<Recorded> specimen_in(scene::Scene scene, const std::string& part);

/// Whether the folder holds loads.
bool holds_loads(const std::filesystem::path& folder);

/// scene.toml and the files of run::write_loads. Problems: the system's.
Result<Done> write_recorded(const Recorded& recorded, const std::filesystem::path& folder);
/// The same read again; `part` names the specimen where the scene has several. Problems: files that are missing or
/// damaged.
Result<Recorded> read_recorded(const std::filesystem::path& folder, const std::string& part);

/// The part with a step for every load case as CalculiX reads it.
std::string to_calculix(const Recorded& recorded, const std::vector<Eigen::Matrix3Xd>& cases,
                        fem::Formulation formulation, bool means);

} // namespace tumble::stress
