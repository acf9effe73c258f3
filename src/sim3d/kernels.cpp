#include "sim3d/kernels.h"

namespace tumble::sim3d {

namespace isa_baseline {
const Kernels& kernels();
}
#if defined(TUMBLE_HAS_isa_v3)
namespace isa_v3 {
const Kernels& kernels();
}
#endif
#if defined(TUMBLE_HAS_isa_v4)
namespace isa_v4 {
const Kernels& kernels();
}
#endif

namespace {

const Kernels* best_first(std::string_view wanted) {
#if defined(TUMBLE_HAS_isa_v4)
    if (wanted != "baseline" && wanted != "x86-64-v3" && __builtin_cpu_supports("x86-64-v4"))
        return &isa_v4::kernels();
    if (wanted == "x86-64-v4")
        return nullptr;
#endif
#if defined(TUMBLE_HAS_isa_v3)
    if (wanted != "baseline" && __builtin_cpu_supports("x86-64-v3"))
        return &isa_v3::kernels();
    if (wanted == "x86-64-v3")
        return nullptr;
#endif
    return &isa_baseline::kernels();
}

} // namespace

const Kernels& choose_kernels() {
    return *best_first("");
}

const Kernels* kernels_named(std::string_view name) {
    return best_first(name);
}

} // namespace tumble::sim3d
