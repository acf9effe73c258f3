#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

const Kernels& kernels() {
    static constexpr Kernels all{near_bodies, near_spheres, touch_spheres, touch_clumps, push_spheres,
                                 push_bodies, push_walls,   integrate,     scan_spheres};
    return all;
}

} // namespace tumble::sim3d::TUMBLE_ISA
