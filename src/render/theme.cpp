#include "render/theme.h"

#include <fmt/core.h>

namespace tumble::render {

Result<Theme> find_theme(const std::string& background) {
    Theme theme;
    if (background == "dark") {
        theme.background = {0.085, 0.095, 0.115};
        theme.text = {0.93, 0.94, 0.95};
        theme.faint = {0.60, 0.63, 0.67};
        theme.line = {0.42, 0.76, 0.98};
        theme.wall = {0.66, 0.74, 0.84};
        theme.edge = {0.74, 0.81, 0.89};
        theme.plain = {0.30, 0.33, 0.38};
        theme.plain_edge = {0.17, 0.19, 0.22};
        theme.arrow = {0.98, 0.98, 0.97};
        theme.chain = {1.00, 0.56, 0.28};
        theme.rim = 0.13F;
        return theme;
    }
    if (background == "white") {
        theme.background = {1, 1, 1};
        theme.text = {0.09, 0.10, 0.12};
        theme.faint = {0.42, 0.45, 0.49};
        theme.line = {0.05, 0.36, 0.66};
        theme.wall = {0.46, 0.54, 0.64};
        theme.edge = {0.24, 0.30, 0.38};
        theme.plain = {0.88, 0.89, 0.91};
        theme.plain_edge = {0.66, 0.68, 0.71};
        theme.arrow = {0.05, 0.05, 0.06};
        theme.chain = {0.76, 0.12, 0.10};
        theme.rim = 0.05F;
        return theme;
    }
    return Problem{.key = "render.background",
                   .what = fmt::format("there is no background '{}'", background),
                   .fix = "take dark or white"};
}

} // namespace tumble::render
