#include "solver/sanity.h"

namespace tumble::solver {

std::optional<int> axis_outside(const scene::Domain& domain, std::span<const double> place) {
    for (std::size_t k = 0; k < place.size(); ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        if (!domain.periodic[k] && (place[k] < domain.box.lo[axis] || place[k] > domain.box.hi[axis]))
            return static_cast<int>(k);
    }
    return std::nullopt;
}

std::optional<Problem> refusal_of(std::size_t number, int shape, const char* flaw, std::span<const double> place,
                                  const scene::Scene& scene) {
    const auto problem = [&](const std::string& what, const std::string& fix) {
        return Problem{scene.file.string(), 0, 0, "", fmt::format("body {} to insert {}", number + 1, what), fix};
    };
    if (shape < 0 || static_cast<std::size_t>(shape) >= scene.bodies.size())
        return problem(fmt::format("names shape {}, of {}", shape, scene.bodies.size()), "give an index from 0");
    if (flaw)
        return problem(flaw, "check where the state comes from");
    if (const auto axis = axis_outside(scene.domain, place))
        return problem(fmt::format("stands at {} = {:.6g} m, outside the domain", "xyz"[*axis],
                                   place[static_cast<std::size_t>(*axis)]),
                       "enlarge the domain or move the body");
    return std::nullopt;
}

} // namespace tumble::solver
