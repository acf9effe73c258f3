#include "scene/written.h"

namespace tumble::scene {

Problem placed(const Scene& scene, Problem problem) {
    if (!problem.file.empty())
        return problem;
    problem.file = scene.file.string();
    for (std::string path = problem.key; !path.empty();) {
        if (const auto found = scene.written.find(path); found != scene.written.end()) {
            problem.file = found->second.source;
            problem.line = found->second.line;
            problem.column = found->second.column;
            break;
        }
        const auto dot = path.rfind('.');
        path.erase(dot == std::string::npos ? 0 : dot);
    }
    return problem;
}

Problem problem_about(const Scene& scene, std::string key, std::string what, std::string fix) {
    return placed(scene, {.key = std::move(key), .what = std::move(what), .fix = std::move(fix)});
}

} // namespace tumble::scene
