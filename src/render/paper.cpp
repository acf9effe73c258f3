#include "render/paper.h"

#include "render/layout.h"

#include <algorithm>
#include <cstddef>

namespace tumble::render {

double letter_unit(const scene::Paper& paper) {
    // Layout measures letters by their reach, typographers by their size.
    return paper.font_pt / points_per_inch * paper.dpi * reach_of_letters / small_letters;
}

double dots_per_metre(const scene::Render& settings) {
    return settings.paper ? settings.paper->dpi * 1e3 / mm_per_inch : 0;
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
