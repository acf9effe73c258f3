#include "render/paper.h"

#include "render/layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/core.h>

namespace tumble::render {

double letter_unit(const scene::Paper& paper) {
    // Layout measures letters by their reach, typographers by their size.
    return paper.font_pt / points_per_inch * paper.dpi * reach_of_letters / small_letters;
}

double dots_per_metre(const scene::Render& settings) {
    return settings.paper ? settings.paper->dpi * 1e3 / mm_per_inch : 0;
}

Result<Done> check_room(const std::vector<Crowded>& crowded, const scene::Render& settings) {
    if (!settings.paper || crowded.empty()) {
        return Done{};
    }
    const auto least = std::min_element(crowded.begin(), crowded.end(),
                                        [](const Crowded& a, const Crowded& b) { return a.share < b.share; });
    const scene::Paper& paper = *settings.paper;
    // What stands around the words takes room too, and letters come in halves of a point.
    const double share = std::clamp(least->share, 0.2, 0.95);
    const double larger = std::ceil(1 / share * 10) / 10;
    const double smaller = std::floor(2 * share * paper.font_pt) / 2;
    return Problem{.key = "render.font_pt",
                   .what = fmt::format("'{}' would be cut off: it has no room in {:g} x {:g} mm with letters of {:g} "
                                       "pt",
                                       least->words, paper.width_mm, paper.height_mm, paper.font_pt),
                   .fix = fmt::format("try --size-mm {:.0f}x{:.0f}{}", std::ceil(larger * paper.width_mm),
                                      std::ceil(larger * paper.height_mm),
                                      smaller >= 5 ? fmt::format(", or --font-pt {:g}", smaller) : "")};
}

Result<Theme> theme_of(const scene::Render& settings) {
    return find_theme(settings.paper ? "white" : settings.background);
}

Result<ColorMap> map_of(const scene::Render& settings, const Quantity& quantity, const Theme& theme) {
    auto map = find_color_map(settings.colormap, quantity.has_sign);
    if (map && quantity.label.empty()) {
        return plain_color_map(theme.plain);
    }
    return map;
}

void paste(const Picture& part, int left, int top, Picture& whole) {
    for (int y = 0; y < part.height; ++y) {
        std::copy_n(part.rgba.begin() + std::ptrdiff_t{4} * y * part.width, std::ptrdiff_t{4} * part.width,
                    whole.rgba.begin() + std::ptrdiff_t{4} * (std::ptrdiff_t{top + y} * whole.width + left));
    }
}

} // namespace tumble::render
