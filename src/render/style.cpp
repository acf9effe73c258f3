#include "render/style.h"

#include "render/camera.h"
#include "render/paper.h"

#include <optional>
#include <string>

namespace tumble::render {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

static Problem bad_range(double lo, double hi) {
    return {.key = "render.range",
            .what = "a colour range from " + std::to_string(lo) + " to " + std::to_string(hi) + " holds no values",
            .fix = "write the smaller value first, both finite and different"};
}

Result<Style> find_style(const scene::Render& settings, int dimension) {
    const auto theme = theme_of(settings);
    const auto quantity = find_quantity(settings.color, dimension);
    const auto map = map_of(settings, quantity.ok() ? *quantity : Quantity{}, theme.ok() ? *theme : Theme{});
    const auto camera = make_camera(settings, AlignedBox3d(Vector3d::Zero(), Vector3d::Ones()), {0, 0, 100, 100});
    Problems problems;
    for (const Problems& found : {theme.problems(), quantity.problems(), map.problems(), camera.problems()}) {
        append(problems, found);
    }
    if (settings.range && !((*settings.range)[1] - (*settings.range)[0] > 0)) {
        problems.push_back(bad_range((*settings.range)[0], (*settings.range)[1]));
    }
    if (!problems.empty()) {
        return problems;
    }
    const auto fixed =
        settings.range ? std::optional<Span>({(*settings.range)[0], (*settings.range)[1]}) : std::nullopt;
    return Style{*theme, *quantity, *map, ColorRange(fixed, quantity->has_sign)};
}

} // namespace tumble::render
