#include "solver/prepare.h"

#include "scene/faults.h"
#include "scene/written.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::solver {

std::vector<contact::PairConstants> pairs_of(const scene::Scene& scene) {
    std::vector<contact::PairConstants> pairs;
    const int materials = static_cast<int>(scene.materials.size());
    for (int a = 0; a < materials; ++a)
        for (int b = 0; b < materials; ++b)
            pairs.push_back(scene.constants(a, b));
    return pairs;
}

bool remember_more(const std::vector<contact::PairConstants>& pairs) {
    return std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) { return !pair.plain(); });
}

Lines<Shift> images_of(const scene::Domain& domain, int dimensions) {
    const Eigen::Vector3d length = domain.box.hi - domain.box.lo;
    Lines<Shift> images(dimensions == 2 ? 9 : 27);
    for (std::size_t image = 0; image < images.size(); ++image) {
        std::size_t digits = image;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis, digits /= 3)
            if (domain.periodic[axis])
                images[image].along[axis] =
                    (static_cast<double>(digits % 3) - 1) * length[static_cast<Eigen::Index>(axis)];
    }
    return images;
}

Problems faults_of_laws(const scene::Scene& scene, int dimensions) {
    Problems problems;
    for (const Problem& fault : scene::faults_of(scene.contact, dimensions))
        problems.push_back(scene::problem_about(scene, "contact." + fault.key, fault.what, fault.fix));
    return problems;
}

Problems faults_of_step(const scene::Scene& scene, const scene::TimeStepReport& report, const char* soften) {
    if (report.stable() || scene.allow_large_step)
        return {};
    return {scene::problem_about(
        scene, "time_step_s",
        fmt::format("a time step of {:.4g} s is above the stable limit of {:.4g} s", report.step, report.limit),
        fmt::format("use at most {:.3g} s, or soften the {}; allow_large_step = true runs it all the same",
                    0.5 * report.limit, soften))};
}

void append(Problems& all, const Problems& more) {
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace tumble::solver
