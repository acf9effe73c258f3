#include "render/drawers.h"

#include <utility>

namespace tumble::render {

Result<Drawers> Drawers::open(const scene::Render& settings, const observe::FrameLayout& layout, const Theme& theme,
                              int samples) {
    auto canvas = make_canvas(settings.width, settings.height, samples);
    if (!canvas) {
        return canvas.problems();
    }
    auto spheres = SphereDrawer::open(*canvas);
    auto discs = DiscDrawer::open();
    auto walls = WallDrawer::open(layout, theme, *canvas);
    auto crevices = CreviceShade::open(*canvas);
    auto patches = PatchDrawer::open();
    Problems problems;
    for (const Problems& found :
         {spheres.problems(), discs.problems(), walls.problems(), crevices.problems(), patches.problems()}) {
        problems.insert(problems.end(), found.begin(), found.end());
    }
    if (!problems.empty()) {
        return problems;
    }
    return Drawers{std::move(*canvas), std::move(*spheres),  std::move(*discs),
                   std::move(*walls),  std::move(*crevices), std::move(*patches)};
}

} // namespace tumble::render
