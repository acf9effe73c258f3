#pragma once

#include "ball_on_prism.h"
#include "run/part_loads.h"
#include "scene/load.h"

#include <doctest/doctest.h>
#include <variant>

namespace tumble::test {

inline const scene::SpecimenShape& specimen_of(const scene::Scene& scene) {
    return std::get<scene::SpecimenShape>(scene.walls[0].shape);
}

inline run::PartLoads recorded(const scene::Scene& scene, const run::LoadOptions& options = {}) {
    run::RunListener silent;
    auto loads = run::record_loads(scene, 0, options, silent);
    REQUIRE_MESSAGE(loads, to_string(loads.problems()));
    return std::move(*loads);
}

} // namespace tumble::test
