#include "lesson/stage.h"

namespace tumble::lesson {

namespace {

template <class WorldPtr, class State>
Result<WorldPtr> with_bodies(Result<WorldPtr> world, const std::vector<State>& bodies) {
    if (world)
        if (const auto problem = insert(**world, bodies))
            return *problem;
    return world;
}

} // namespace

Result<sim2d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim2d::BodyState>& bodies) {
    return with_bodies(sim2d::build_world(scene, 1), bodies);
}

Result<sim3d::WorldPtr> start(const scene::Scene& scene, const std::vector<sim3d::BodyState>& bodies) {
    return with_bodies(sim3d::build_world(scene, 1), bodies);
}

} // namespace tumble::lesson
