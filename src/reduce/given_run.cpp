#include "reduce/given_run.h"

#include "observe/series.h"
#include "observe/whole_file.h"
#include "run/build_mark.h"
#include "run/mesh_copies.h"
#include "run/run_folder.h"
#include "run/run_report.h"
#include "run/scene_changes.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <set>

namespace tumble::reduce {

namespace {

Problem no_reference(const run::RunFolder& folder, std::string what, std::string fix) {
    return {.file = folder.root.string(), .what = std::move(what), .fix = std::move(fix)};
}

/// That it is a run of this scene.
std::optional<Problem> other_scene(const run::RunFolder& folder, const scene::Scene& scene) {
    const Result<std::string> before = observe::read_whole(folder.scene());
    const auto meshes = run::read_meshes(scene);
    if (!before || !meshes)
        return (before ? meshes.problems() : before.problems()).front();
    auto changes = run::changes_of_motion(*before, scene::to_toml(scene, run::names_of(*meshes)));
    if (!changes)
        return changes.problems().front();
    const auto own = scene::load_scene(folder.scene());
    const auto own_meshes = own ? run::read_meshes(*own) : own.problems();
    if (!own_meshes)
        return own_meshes.problems().front();
    const auto marks = run::marks_of(*meshes), own_marks = run::marks_of(*own_meshes);
    for (std::size_t k = 0; changes->empty() && k < std::min(marks.size(), own_marks.size()); ++k)
        if (marks[k].hash != own_marks[k].hash)
            changes->push_back("the content of " + marks[k].name + " differs");
    if (changes->empty())
        return std::nullopt;
    return no_reference(folder, "it is a run of another scene: " + changes->front(),
                        "give a run of the scene that is to be reduced, or --set what it had set");
}

/// That it was that scene all the time, and had all its bodies.
std::optional<Problem> unlike_others(const run::RunFolder& folder, const nlohmann::json& summary) {
    for (const auto& resumption : summary.value("resumed", nlohmann::json::array()))
        if (!resumption.value("changes", nlohmann::json::array()).empty())
            return no_reference(folder, "its scene was changed in the midst of it (`--accept-changes`)",
                                "give a run that was this scene from its beginning");
    if (!summary.value("unfilled", nlohmann::json::array()).empty())
        return no_reference(folder, "not all bodies found room in it", "give a run that has them all");
    return std::nullopt;
}

double number_in(const nlohmann::json& summary, const char* key) {
    return summary.contains(key) && summary[key].is_number() ? summary[key].get<double>() : 0;
}

/// What makes it look dearer than the rungs.
std::vector<std::string> doubts_of_cost(const nlohmann::json& summary) {
    std::vector<std::string> doubts;
    if (number_in(summary, "processor_s") <= 0)
        doubts.emplace_back("its processor time was not written: the clock's time of all its threads stands for it");
    if (const double pictures = number_in(summary, "pictures"); pictures > 0 || summary.value("video", false))
        doubts.emplace_back("its processor time includes pictures, which rungs do not draw");
    return doubts;
}

/// Of as much as the scene asks for: a run may be longer. One of an older program says only what the clock said.
double processor_time(const nlohmann::json& summary, double duration) {
    const double own = number_in(summary, "processor_s");
    const double spent = own > 0 ? own : number_in(summary, "wall_s") * std::max(1.0, number_in(summary, "threads"));
    return spent * std::min(1.0, duration / std::max(number_in(summary, "time_s"), 1e-300));
}

std::optional<Problem> unfit_series(const run::RunFolder& folder, const Yardstick& stick) {
    const auto series = observe::read_series(folder.series());
    if (!series)
        return series.problems().front();
    const std::vector<double>& times = series->values.front();
    if (times.empty() || times.back() < stick.until() * (1 - 1e-9))
        return no_reference(folder,
                            fmt::format("it has come to t = {:.4g} s, and what counts ends at {:.4g} s",
                                        times.empty() ? 0.0 : times.back(), stick.until()),
                            "let it run to its end (--resume), or give a --time that it has");
    for (const Quantity& quantity : stick.quantities())
        if (!quantity.column.empty() && !series->find(quantity.column))
            return no_reference(folder, fmt::format("its series.csv has no column '{}'", quantity.column),
                                "run it with observe.measures that have it (`tumble list measures`)");
    return std::nullopt;
}

std::optional<Problem> unfit(const run::RunFolder& folder, const nlohmann::json& summary, const scene::Scene& scene,
                             const Yardstick& stick) {
    if (auto problem = other_scene(folder, scene))
        return problem;
    if (auto problem = unfit_series(folder, stick))
        return problem;
    return unlike_others(folder, summary);
}

std::uint64_t seed_of(const nlohmann::json& summary) {
    return static_cast<std::uint64_t>(number_in(summary, "seed"));
}

} // namespace

std::optional<Problem> unfit_reference(const std::vector<std::filesystem::path>& folders, const scene::Scene& scene,
                                       const Yardstick& stick) {
    std::set<std::uint64_t> seeds;
    for (const std::filesystem::path& root : folders) {
        const auto folder = run::find_run(root);
        if (!folder)
            return folder.problems().front();
        const nlohmann::json summary = run::read_summary(*folder);
        if (auto problem = unfit(*folder, summary, scene, stick))
            return problem;
        if (!seeds.insert(seed_of(summary)).second)
            return no_reference(*folder, fmt::format("seed {} is among the references already", seed_of(summary)),
                                "give each run once, and only runs of different seeds");
    }
    return std::nullopt;
}

Result<Seeded> read_given(const std::filesystem::path& root, const scene::Scene& scene, const Yardstick& stick,
                          double mass) {
    const auto folder = run::find_run(root);
    if (!folder)
        return folder.problems();
    const nlohmann::json summary = run::read_summary(*folder);
    if (auto problem = unfit(*folder, summary, scene, stick))
        return *problem;
    auto values = stick.read(root, mass);
    if (!values)
        return values.problems();
    Seeded given{seed_of(summary), processor_time(summary, scene.duration), number_in(summary, "overlap_ratio_max"),
                 std::move(*values), doubts_of_cost(summary)};
    if (summary.contains("warnings") && summary["warnings"].is_array())
        for (const auto& warning : summary["warnings"])
            if (warning.is_string())
                given.doubts.push_back(warning);
    if (!summary.contains("build_mark") || summary["build_mark"] != run::build_mark())
        given.doubts.push_back("another build of the program made it, which may have moved bodies otherwise");
    return given;
}

} // namespace tumble::reduce
