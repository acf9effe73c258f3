#include "sim2d/kernels/isa.h"

namespace tumble::sim2d::TUMBLE_ISA {

const Kernels& kernels() {
    static constexpr Kernels all{near_discs, touch_discs, push_discs, push_walls, integrate};
    return all;
}

} // namespace tumble::sim2d::TUMBLE_ISA
