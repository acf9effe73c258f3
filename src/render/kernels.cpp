#include "render/kernels.h"

namespace tumble::render {

namespace isa_baseline {
void draw_tile(const TileJob& job);
}
#if defined(TUMBLE_HAS_isa_v3)
namespace isa_v3 {
void draw_tile(const TileJob& job);
}
#endif
#if defined(TUMBLE_HAS_isa_v4)
namespace isa_v4 {
void draw_tile(const TileJob& job);
}
#endif

DrawTile tile_drawer_named(std::string_view name) {
#if defined(TUMBLE_HAS_isa_v4)
    if (name == "x86-64-v4" && __builtin_cpu_supports("x86-64-v4"))
        return isa_v4::draw_tile;
#endif
#if defined(TUMBLE_HAS_isa_v3)
    if (name == "x86-64-v3" && __builtin_cpu_supports("x86-64-v3"))
        return isa_v3::draw_tile;
#endif
    return name == "baseline" ? isa_baseline::draw_tile : nullptr;
}

DrawTile choose_tile_drawer() {
    for (const char* name : {"x86-64-v4", "x86-64-v3"})
        if (const DrawTile found = tile_drawer_named(name))
            return found;
    return isa_baseline::draw_tile;
}

} // namespace tumble::render
