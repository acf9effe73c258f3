#include "stress/doubts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tumble::stress {

namespace {

constexpr double missed = 2; // times what any instant saw: then the impacts' peaks lie between the instants

/// Touches are looked at in every step, instants are samples.
std::optional<std::string> doubt_of_instants(const Study& study) {
    double peak = 0, seen = 0; // N
    for (const observe::Touching& touch : study.impacts.hardest)
        peak = std::max(peak, touch.peak_normal);
    for (const Case& now : study.cases)
        if (now.strongest)
            seen = std::max(seen, now.strongest->normal);
    if (!(peak > missed * seen))
        return std::nullopt;
    return fmt::format("touches' peaks reach {:.3g} N, the {} instants saw at most {:.3g} N: the stress of the hardest "
                       "impacts is not among these; a run with a shorter --every sees more of them",
                       peak, study.cases.size(), seen);
}

template <class Parts> void take_start(const Parts& parts, double& first) {
    for (const auto& part : parts)
        first = std::min(first, part.active.start);
}

/// s, when a wall begins to move; infinite: never.
double start_of(const scene::WallMotion& motion) {
    double first = std::numeric_limits<double>::infinity();
    take_start(motion.harmonics, first);
    take_start(motion.rotations, first);
    take_start(motion.rockings, first);
    take_start(motion.linears, first);
    take_start(motion.tables, first);
    return first;
}

/// Filling and settling are part of the run, and seldom of what is asked.
std::optional<std::string> doubt_of_beginning(const scene::Scene& scene, const Study& study) {
    double begins = 0; // s
    std::string what;
    const double last = study.cases.back().time;
    for (const scene::Fill& fill : scene.fills)
        if (fill.until > begins && fill.until < last) {
            begins = fill.until;
            what = "filling ends";
        }
    for (const scene::Wall& wall : scene.walls)
        if (const double start = start_of(wall.motion); start > begins && start < last) {
            begins = start;
            what = fmt::format("'{}' begins to move", wall.name);
        }
    const Case& first = study.cases.front();
    if (!(first.time - first.window < begins - 0.5 * scene.time_step))
        return std::nullopt;
    return fmt::format("the cases begin at {:.4g} s, before {} at {:.4g} s, and all means count them: `--from {:.4g}` "
                       "leaves them out",
                       first.time, what, begins, begins);
}

} // namespace

std::vector<std::string> doubts_of(const scene::Scene& scene, const Study& study, bool means) {
    std::vector<std::string> doubts;
    if (!means)
        if (auto doubt = doubt_of_instants(study))
            doubts.push_back(std::move(*doubt));
    if (auto doubt = doubt_of_beginning(scene, study))
        doubts.push_back(std::move(*doubt));
    return doubts;
}

} // namespace tumble::stress
