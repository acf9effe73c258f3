#pragma once

#include "base/problem.h"
#include "base/tally.h"
#include "run/simulation.h"
#include "scene/scene.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tumble::run {

/// One body template and how many of it a scene asks for.
struct BodyCheck : SimulatedBody {
    std::string material;
    std::int64_t wanted = 0;
};

struct WallCheck {
    std::string name;
    std::string shape; // "plane", "box", ...
    std::string material;
    Eigen::Vector3d size; // m, of the box around it at rest; infinite where it does not end
};

/// What two materials do to each other that can meet.
struct PairCheck {
    std::string name;       // "media-lining"
    std::string normal;     // law: "hertz", "linear", "box2d"
    std::string tangential; // law: "mindlin", "linear", "none", "box2d"
    contact::PairProperties given;
    contact::PairConstants taken; // by the laws: an addition that the pair gives no size is none
};

/// What a scene means before anything runs.
struct SceneCheck {
    int dimension = 3;
    std::vector<BodyCheck> bodies;
    std::int64_t wanted = 0;   // bodies in all
    std::int64_t placed = 0;   // of them at the start
    std::int64_t too_late = 0; // of them those that would come after the end
    double mass = 0;           // kg, of all wanted
    std::size_t parts = 0;     // spheres or discs of all wanted
    std::vector<WallCheck> walls;
    std::vector<PairCheck> pairs;
    scene::TimeStepReport time_step;
    std::int64_t steps = 0;
    std::int64_t rows = 0;
    std::int64_t frames = 0;
    double memory_bytes = 0; // estimate
    double disk_bytes = 0;   // states and series; pictures come on top
    double body_steps = 0;   // bodies times steps, all bodies from the start
    double hours = 0;        // on one core: at `assumed_rate`, and what steps, rows and frames take without bodies
    double assumed_rate = 0; // body-steps per s
    double assumed_step = 0; // s that a step takes however few the bodies
    std::vector<std::string> warnings;
};

/// The same of a world that is built.
SceneCheck check_built(const scene::Scene& scene, const Simulation& simulation);

/// Builds everything as a run would, takes no step, writes nothing; `tally` hears of each body that found its place.
/// Problems: all that would keep the scene from running, an unstable time step among them.
Result<SceneCheck> check_scene(const scene::Scene& scene, int threads, const Tally& tally = {});

/// Stable keys, units in the names.
nlohmann::ordered_json to_json(const SceneCheck& check);

} // namespace tumble::run
