#include "render/clip.h"

#include <cmath>
#include <fmt/core.h>

namespace tumble::render {

std::optional<Eigen::AlignedBox3d> clip_of(const scene::Render& settings, const observe::FrameLayout& layout) {
    if (!settings.clip || layout.dimension != 3) {
        return std::nullopt;
    }
    return Eigen::AlignedBox3d(settings.clip->lo, settings.clip->hi);
}

std::string plane_words(int axis, double place, bool above) {
    const double mm = 1e3 * std::abs(place);
    const bool fine = mm < 10; // to a tenth of a millimetre, or three digits; roundings of what was typed are not told
    const std::string number = mm < 1e-4 ? "0"
                               : fine    ? fmt::format("{:.3g}", mm)
                                         : fmt::format("{:.10g}", std::round(10 * mm) / 10);
    return fmt::format("{} {} {}{} mm", "xyz"[axis], above ? "\u2265" : "\u2264",
                       place < 0 && number != "0" ? "\u2212" : "", number);
}

std::string section_words(int axis, double place, bool above, bool cuts) {
    return (cuts ? "cut: " : "shown: ") + plane_words(axis, place, above);
}

std::vector<std::string> clip_words(const Eigen::AlignedBox3d& clip, bool cuts, const observe::FrameLayout& layout) {
    std::vector<std::string> rows;
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = layout.domain_lo[axis], hi = layout.domain_hi[axis];
        const double least = 1e-9 * (hi - lo); // a face that lies in the domain's own cuts nothing
        for (const bool above : {true, false}) {
            const double place = above ? clip.min()[axis] : clip.max()[axis];
            if (place > lo + least && place < hi - least) {
                rows.push_back(section_words(axis, place, above, cuts));
            }
        }
    }
    return rows;
}

} // namespace tumble::render
