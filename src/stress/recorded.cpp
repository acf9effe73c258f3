#include "stress/recorded.h"

#include "observe/frame_file.h"
#include "observe/whole_file.h"
#include "run/mesh_copies.h"
#include "scene/load.h"
#include "scene/specimen.h"
#include "scene/to_toml.h"
#include "solid/facet_load.h"
#include "solid/inp.h"

#include <fmt/format.h>

namespace tumble::stress {

namespace fs = std::filesystem;

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

Result<Done> write_recorded(const Recorded& recorded, const fs::path& folder) {
    const auto meshes = run::read_meshes(recorded.scene);
    if (!meshes)
        return meshes.problems();
    if (const auto written = run::write_meshes(*meshes, {folder}); !written)
        return written;
    const std::string toml = scene::to_toml(recorded.scene, run::names_of(*meshes));
    if (const auto written = observe::write_whole(folder / "scene.toml", toml); !written)
        return written;
    return run::write_loads(recorded.loads, recorded.specimen(), folder);
}

Result<Recorded> read_recorded(const fs::path& folder, const std::string& part) {
    if (!holds_loads(folder))
        return Problem{.file = folder.string(),
                       .what = "holds no loads on a part",
                       .fix = "`tumble stress SCENE` leaves a folder that does"};
    auto scene = scene::load_scene(folder / "scene.toml");
    if (!scene)
        return scene.problems();
    auto recorded = specimen_in(std::move(*scene), part);
    if (!recorded)
        return recorded;
    auto loads = run::read_loads(folder, recorded->specimen());
    if (!loads)
        return loads.problems();
    recorded->loads = std::move(*loads);
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
    recorded->scene = std::move(*changed);
    const solid::HexMesh& mesh = *recorded->specimen().mesh;
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

std::string to_calculix(const Recorded& recorded, const std::vector<Eigen::Matrix3Xd>& cases,
                        fem::Formulation formulation, bool means) {
    const scene::SpecimenShape& specimen = recorded.specimen();
    std::vector<solid::InpStep> steps;
    for (std::size_t c = 0; c < cases.size(); ++c) {
        const double time = means ? recorded.loads.means[c].time : recorded.loads.instants[c].time;
        steps.push_back({fmt::format("{} {:.9g} s", means ? "mean until" : "contacts at", time), cases[c]});
    }
    const solid::InpModel model{specimen.youngs_modulus, specimen.poisson_ratio,
                                formulation == fem::Formulation::standard ? "C3D8" : "C3D8I",
                                scene::held_sets(specimen)};
    return solid::to_inp(*specimen.mesh, model, steps);
}

} // namespace tumble::stress
