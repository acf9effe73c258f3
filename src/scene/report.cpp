#include "scene/report.h"

#include <algorithm>
#include <tuple>

namespace tumble::scene {

Problems Report::sorted(const std::string& scene_file) const {
    Problems all = problems_;
    std::stable_sort(all.begin(), all.end(), [&](const Problem& a, const Problem& b) {
        const bool a_elsewhere = a.file != scene_file;
        const bool b_elsewhere = b.file != scene_file;
        if (a_elsewhere || b_elsewhere)
            return a_elsewhere < b_elsewhere;
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    return all;
}

} // namespace tumble::scene
