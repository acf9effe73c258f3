#include "render/bare.h"

#include <fmt/core.h>

namespace tumble::render {

std::string bare_words(Bare bare, const std::string& where) {
    switch (bare) {
    case Bare::no:
        return "";
    case Bare::without_bodies:
        return fmt::format("no body is to be seen in {}: there is none at that time; --time chooses another", where);
    case Bare::clipped_away:
        return fmt::format("no body is to be seen in {}: the clip or cut leaves none; move its corners or its place",
                           where);
    case Bare::out_of_view:
        return fmt::format("no body is to be seen in {}: all lie outside of what the camera shows; --eye and --target "
                           "place it, --camera free without them has everything in the picture",
                           where);
    case Bare::out_of_corners:
        return fmt::format("no body is to be seen in {}: all lie outside of render.view_lo_m to render.view_hi_m; "
                           "move these corners, or leave them away to have everything in the picture",
                           where);
    }
    return "";
}

} // namespace tumble::render
