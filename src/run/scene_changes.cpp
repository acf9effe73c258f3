#include "run/scene_changes.h"

#include "base/hash.h"
#include "base/text.h"
#include "scene/compare.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::run {

namespace {

enum class Weight {
    none,  // how long, what is drawn, words
    some,  // what bodies do from now on
    breaks // what bodies are, where they live, what their state counts on
};

struct Rule {
    std::string_view path; // '*' stands for one name; what stands deeper follows
    Weight weight;
};

/// The first that fits decides.
constexpr Rule rules[] = {
    {"title", Weight::none},
    {"claim", Weight::none},
    {"duration_s", Weight::none},
    {"allow_large_step", Weight::none},
    {"contact.accepted_overlap", Weight::none},
    {"observe.every_s", Weight::none},
    {"render", Weight::none},
    {"wall.*.opacity", Weight::none},
    {"gravity_m_s2", Weight::some},
    {"contact", Weight::some},
    {"pair", Weight::some},
    {"material.*.youngs_modulus_Pa", Weight::some},
    {"material.*.poisson_ratio", Weight::some},
    {"material.*.allow_soft", Weight::some},
    {"wall.*.motion", Weight::some},
};

bool fits(std::string_view rule, std::string_view path) {
    const auto names = split(rule, '.');
    const auto of_path = split(path, '.');
    return of_path.size() >= names.size() &&
           std::equal(names.begin(), names.end(), of_path.begin(),
                      [](std::string_view name, std::string_view given) { return name == "*" || name == given; });
}

Weight weight_of(const scene::Change& change) {
    // Older programs wrote [box2d] of soft scenes as well, which do not read it; another solver is told of by itself.
    if (fits("box2d", change.path) && (change.before.empty() || change.now.empty()))
        return Weight::none;
    for (const Rule& rule : rules)
        if (fits(rule.path, change.path))
            return rule.weight;
    return Weight::breaks;
}

std::string shown(const std::string& value) {
    return value.empty() ? "nothing" : excerpt(value);
}

std::string sentence(const scene::Change& change) {
    return fmt::format("{} was {} and is now {}", excerpt(change.path), shown(change.before), shown(change.now));
}

void compare_meshes(const std::vector<MeshMark>& before, const std::vector<MeshMark>& now,
                    std::vector<scene::Change>& changes) {
    for (const MeshMark& mark : now)
        for (const MeshMark& old : before)
            if (old.name == mark.name && old.hash != mark.hash)
                changes.push_back({"the content of " + mark.name, old.hash, mark.hash});
}

} // namespace

std::vector<MeshMark> marks_of(const std::vector<MeshCopy>& meshes) {
    std::vector<MeshMark> marks;
    for (const MeshCopy& mesh : meshes)
        marks.push_back({mesh.name, Hash64{}.add(mesh.content).hex()});
    return marks;
}

Result<std::vector<std::string>> judge_changes(const Checkpoint& checkpoint, const std::string& scene,
                                               const std::vector<MeshMark>& meshes, bool accept,
                                               const std::filesystem::path& file) {
    auto changes = scene::changes_between(checkpoint.scene, scene);
    if (!changes)
        return changes.problems();
    compare_meshes(checkpoint.meshes, meshes, *changes);
    std::vector<std::string> sentences;
    Problems problems;
    for (const scene::Change& change : *changes) {
        const Weight weight = weight_of(change);
        if (weight == Weight::none)
            continue;
        sentences.push_back(sentence(change));
        if (weight == Weight::some && accept)
            continue;
        problems.push_back(
            {.file = file.string(),
             .what = fmt::format("the scene was changed after t = {:.6g} s: {}", checkpoint.time, sentence(change)),
             .fix = weight == Weight::some ? "put it back, or say --accept-changes to go on with it as it is now"
                                           : "put it back: this cannot change in the midst of a run; --out DIR runs "
                                             "the new scene elsewhere"});
    }
    if (!problems.empty())
        return problems;
    return sentences;
}

Result<std::vector<std::string>> changes_of_motion(const std::string& before, const std::string& now) {
    const auto changes = scene::changes_between(before, now);
    if (!changes)
        return changes.problems();
    std::vector<std::string> sentences;
    for (const scene::Change& change : *changes)
        if (weight_of(change) != Weight::none && change.path != "seed" && !fits("observe", change.path))
            sentences.push_back(sentence(change));
    return sentences;
}

} // namespace tumble::run
