#pragma once

#include "base/problem.h"
#include "fem/brick.h"
#include "run/part_loads.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tumble::stress {

/// A scene, its specimen, and the loads on it.
struct Recorded {
    scene::Scene scene;
    int wall = 0; // the specimen, into scene.walls
    run::PartLoads loads;
    std::filesystem::path frames{}; // folder with a frame an instant; empty: none were kept
    std::int64_t first_frame = 0;   // number of the frame of the first of loads.instants

    [[nodiscard]] const scene::SpecimenShape& specimen() const;
    [[nodiscard]] const std::string& name() const;
};

/// Nothing recorded yet. Problems: those of run::find_specimen.
Result<Recorded> specimen_in(scene::Scene scene, const std::string& part);

/// Whether the folder holds loads.
bool holds_loads(const std::filesystem::path& folder);

/// Whether a run of `stress` began in the folder, whether or not it came to its loads.
bool holds_begun(const std::filesystem::path& folder);

/// scene.toml, its meshes, and part.txt with the specimen's name. Problems: the system's.
Result<Done> write_what_runs(const Recorded& recorded, const std::filesystem::path& folder);
/// The same and the files of run::write_loads. Problems: the system's.
Result<Done> write_recorded(const Recorded& recorded, const std::filesystem::path& folder);
/// The same read again, loads.stopped where the run ended an instant or more before its time; `part` is the specimen
/// that part.txt names, or empty. Problems: files that are missing or
/// damaged, loads on another part.
Result<Recorded> read_recorded(const std::filesystem::path& folder, const std::string& part);

/// Instants and means of such a folder on another mesh: `sets` are keys of the specimen's wall, "around=120". Each
/// contact moves to the nearest point of the new surface, those of the means, too, so that all that differs is the
/// mesh. Problems: those of read_recorded and of the scene with its changes; a key that more than the mesh depends on;
/// a part of another size; a contact that finds no facet.
Result<Recorded> read_remeshed(const std::filesystem::path& folder, const std::string& part,
                               const std::vector<std::string>& sets);

/// Leaves the instants, and the means whose window ends, from `from` to `to`, s.
void keep_within(run::PartLoads& loads, double from, double to);

/// The part with a step for every load case as CalculiX reads it.
std::string to_calculix(const Recorded& recorded, const std::vector<Eigen::Matrix3Xd>& cases,
                        fem::Formulation formulation, bool means);

} // namespace tumble::stress
