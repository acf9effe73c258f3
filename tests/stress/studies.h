#pragma once

#include "base/text.h"
#include "run/specimens.h"
#include "sheet/show.h"
#include "stress/study.h"
#include "stress/study_sheet.h"

#include <doctest/doctest.h>

/// Studies of a ball on a prism, and what their sheets say.
namespace tumble::test {

using stress::Study;
using stress::StudyOptions;

inline scene::Scene loaded(const std::vector<scene::Override>& sets = {}) {
    auto scene = scene::load_scene_text(test::ball_on_prism, "ball-on-prism.toml", sets);
    REQUIRE_MESSAGE(scene, to_string(scene.problems()));
    return std::move(*scene);
}

/// The prism's sides under a pressure, as a push in the middle of each of their facets; so many instants alike.
inline run::PartLoads squeezed(const scene::SpecimenShape& specimen, double pressure, int instants) {
    run::PartLoads loads;
    const solid::HexMesh& mesh = *specimen.mesh;
    for (int k = 0; k < instants; ++k) {
        run::LoadInstant instant{0.1 * k, {}};
        for (const char* side : {"-x", "+x", "-z", "+z"})
            for (const int facet : mesh.facet_sets.at(side)) {
                observe::WallPush push;
                push.triangle = 2 * facet;
                push.foot = mesh.centre_of(facet);
                push.normal = mesh.area_of(facet).normalized();
                push.force = -pressure * mesh.area_of(facet);
                instant.pushes.push_back(push);
            }
        loads.instants.push_back(std::move(instant));
    }
    return loads;
}

inline Study studied(const scene::Scene& scene, const run::PartLoads& loads, const StudyOptions& options = {}) {
    auto study = stress::study(scene, specimen_of(scene), loads, options);
    REQUIRE_MESSAGE(study, to_string(study.problems()));
    return std::move(*study);
}

inline const sheet::Figure& figure_of(const sheet::Sheet& sheet, const std::string& name) {
    for (const sheet::Figure* figure : sheet.figures())
        if (figure->name == name)
            return *figure;
    FAIL("no figure " << name);
    return *sheet.figures().at(0);
}

/// The sheet as text, in one line.
inline std::string said(const Study& study, const StudyOptions& options = {}) {
    std::string text = sheet::to_text("", stress::sheet_of(study, options));
    std::string line;
    for (const std::string_view word : split_words(text))
        line += std::string(line.empty() ? "" : " ") + std::string(word);
    return line;
}

inline bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

} // namespace tumble::test
