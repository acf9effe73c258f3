#include "stress/recorded.h"

#include "base/text.h"
#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"
#include "run/mesh_copies.h"
#include "scene/load.h"
#include "scene/specimen.h"
#include "scene/to_toml.h"
#include "solid/facet_load.h"
#include "solid/inp.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::stress {

namespace fs = std::filesystem;

namespace {

/// Names the specimen that the folder's loads are on.
fs::path part_file(const fs::path& folder) {
    return folder / "part.txt";
}

/// m, of the box about all nodes.
Eigen::Vector3d extent_of(const solid::HexMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& node : mesh.nodes)
        box.extend(node);
    return box.sizes();
}

/// Keys of a specimen that its mesh alone depends on; a file's size is compared.
const std::vector<std::string> mesh_keys{"around",       "along",        "shell_rings", "inner_rings", "shell_m",
                                         "corner_cells", "middle_cells", "corner_m",    "inp",         "scale"};

/// Of "KEY=VALUE".
std::optional<Problem> refuse_other_part(const fs::path& folder, const std::string& set) {
    const std::string key(trimmed(std::string_view(set).substr(0, set.find('='))));
    if (std::find(mesh_keys.begin(), mesh_keys.end(), key) != mesh_keys.end())
        return std::nullopt;
    return Problem{.file = folder.string(),
                   .key = key,
                   .what = fmt::format("--remesh {} makes it another part", key),
                   .fix = fmt::format("the mesh has {}; `tumble stress SCENE --set ...` runs another part",
                                      fmt::join(mesh_keys, ", "))};
}

/// Whether instants are missing at the end of the run, by the longest time between two of them.
bool ends_early(const run::PartLoads& loads, const scene::Scene& scene) {
    double every = 0; // s
    for (std::size_t k = 1; k < loads.instants.size(); ++k)
        every = std::max(every, loads.instants[k].time - loads.instants[k - 1].time);
    return every > 0 && scene.duration - loads.instants.back().time > every + 2 * scene.time_step;
}

} // namespace

const scene::SpecimenShape& Recorded::specimen() const {
    return std::get<scene::SpecimenShape>(scene.walls[static_cast<std::size_t>(wall)].shape);
}

const std::string& Recorded::name() const {
    return scene.walls[static_cast<std::size_t>(wall)].name;
}

Result<Recorded> specimen_in(scene::Scene scene, const std::string& part) {
    const auto wall = run::find_specimen(scene, part);
    if (!wall)
        return wall.problems();
    return Recorded{std::move(scene), *wall, {}, {}};
}

bool holds_loads(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / "contacts.csv", ignored);
}

bool holds_begun(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(part_file(folder), ignored);
}

Result<Done> write_what_runs(const Recorded& recorded, const fs::path& folder) {
    const auto meshes = run::read_meshes(recorded.scene);
    if (!meshes)
        return meshes.problems();
    if (const auto written = run::write_meshes(*meshes, {folder}); !written)
        return written;
    const std::string toml = scene::to_toml(recorded.scene, run::names_of(*meshes));
    if (const auto written = observe::write_whole(folder / "scene.toml", toml); !written)
        return written;
    return observe::write_whole(part_file(folder), recorded.name() + "\n");
}

Result<Done> write_recorded(const Recorded& recorded, const fs::path& folder) {
    if (const auto written = write_what_runs(recorded, folder); !written)
        return written;
    return run::write_loads(recorded.loads, recorded.specimen(), folder);
}

Result<Recorded> read_recorded(const fs::path& folder, const std::string& part) {
    if (!holds_loads(folder) && holds_begun(folder))
        return Problem{.file = folder.string(),
                       .what = "holds no loads on a part yet: its run was killed, or goes on",
                       .fix = fmt::format("`tumble stress SCENE --out {} --resume` goes on with it", folder.string())};
    if (!holds_loads(folder))
        return Problem{.file = folder.string(),
                       .what = "holds no loads on a part",
                       .fix = "`tumble stress SCENE` leaves a folder that does"};
    auto scene = scene::load_scene(folder / "scene.toml");
    if (!scene)
        return scene.problems();
    const Result<std::string> line = observe::read_whole(part_file(folder)); // older folders have none
    const std::string loaded = line ? line->substr(0, line->find('\n')) : part;
    if (!part.empty() && part != loaded)
        return Problem{.file = folder.string(),
                       .what = fmt::format("holds loads on '{}', not on '{}'", loaded, part),
                       .fix = fmt::format("`tumble stress SCENE --part {}` runs it for that part", part)};
    auto recorded = specimen_in(std::move(*scene), loaded);
    if (!recorded)
        return recorded;
    auto loads = run::read_loads(folder, recorded->specimen());
    if (!loads)
        return loads.problems();
    recorded->loads = std::move(*loads);
    recorded->loads.stopped = ends_early(recorded->loads, recorded->scene);
    if (std::error_code ignored; fs::exists(observe::layout_path(folder / "frames"), ignored))
        recorded->frames = folder / "frames";
    return recorded;
}

Result<Recorded> read_remeshed(const fs::path& folder, const std::string& part, const std::vector<std::string>& sets) {
    auto recorded = read_recorded(folder, part);
    if (!recorded)
        return recorded;
    std::vector<scene::Override> overrides;
    for (const std::string& set : sets)
        overrides.push_back({fmt::format("wall.{}.{}", recorded->name(), set)});
    auto changed = scene::load_scene(folder / "scene.toml", overrides);
    if (!changed)
        return changed.problems();
    for (const std::string& set : sets)
        if (const auto problem = refuse_other_part(folder, set))
            return *problem;
    const Eigen::Vector3d before = extent_of(*recorded->specimen().mesh);
    recorded->scene = std::move(*changed);
    const solid::HexMesh& mesh = *recorded->specimen().mesh;
    // A polygon of 12 sides is 3 % narrower than its circle.
    if (const Eigen::Vector3d after = extent_of(mesh);
        (after - before).cwiseAbs().maxCoeff() > 0.05 * before.maxCoeff())
        return Problem{
            .file = folder.string(),
            .what = fmt::format("--remesh makes it another part: {:.4g} x {:.4g} x {:.4g} mm in place of {:.4g} x "
                                "{:.4g} x {:.4g} mm",
                                1e3 * after.x(), 1e3 * after.y(), 1e3 * after.z(), 1e3 * before.x(), 1e3 * before.y(),
                                1e3 * before.z()),
            .fix = "change the mesh, not the part; `tumble stress SCENE --set ...` runs another part"};
    const auto move = [&](double time, std::vector<observe::WallPush>& pushes) -> std::optional<Problem> {
        for (observe::WallPush& push : pushes) {
            const auto moved = solid::moved_to(mesh, {0, push.foot, push.force}, push.normal);
            if (!moved)
                return Problem{.file = folder.string(),
                               .what = fmt::format("a contact at {:.6g} s finds no facet of the new mesh", time),
                               .fix = "change the mesh, not the part"};
            push.triangle = 2 * moved->facet;
            push.foot = moved->point;
        }
        return std::nullopt;
    };
    for (run::LoadInstant& instant : recorded->loads.instants)
        if (const auto problem = move(instant.time, instant.pushes))
            return *problem;
    for (run::MeanLoad& mean : recorded->loads.means)
        if (const auto problem = move(mean.time, mean.pushes))
            return *problem;
    return recorded;
}

void keep_within(run::PartLoads& loads, double from, double to) {
    const auto outside = [&](const auto& load) { return load.time < from || load.time > to; };
    std::erase_if(loads.instants, outside);
    std::erase_if(loads.means, outside);
}

std::string to_calculix(const Recorded& recorded, const std::vector<Eigen::Matrix3Xd>& cases,
                        fem::Formulation formulation, bool means) {
    const scene::SpecimenShape& specimen = recorded.specimen();
    std::vector<solid::InpStep> steps;
    for (std::size_t c = 0; c < cases.size(); ++c) {
        const double time = means ? recorded.loads.means[c].time : recorded.loads.instants[c].time;
        steps.push_back({fmt::format("{} {:.9g} s", means ? "mean until" : "contacts at", time), cases[c]});
    }
    const solid::InpModel model{
        specimen.youngs_modulus,
        specimen.poisson_ratio,
        formulation == fem::Formulation::standard ? "C3D8" : "C3D8I",
        scene::held_sets(specimen),
        false,
        {recorded.scene.title + ": " + recorded.name(),
         means ? "mean loads between instants, a step each" : "contacts at instants, a step each",
         "made by tumble, build " + run::build_mark()}};
    return solid::to_inp(*specimen.mesh, model, steps);
}

} // namespace tumble::stress
