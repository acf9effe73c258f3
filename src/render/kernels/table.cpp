#include "render/kernels/lanes.h"

namespace tumble::render::TUMBLE_ISA {

void draw_tile(const TileJob& job);
void measure_distances(const CreviceJob& job);
void gather_sky(const CreviceJob& job);
void blur_sky(const CreviceJob& job);

const Kernels& kernels() {
    static constexpr Kernels all{draw_tile, measure_distances, gather_sky, blur_sky};
    return all;
}

} // namespace tumble::render::TUMBLE_ISA
