#include "render/kernels.h"

namespace tumble::render {

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

const Kernels* kernels_named(std::string_view name) {
#if defined(TUMBLE_HAS_isa_v4)
    if (name == "x86-64-v4" && __builtin_cpu_supports("x86-64-v4"))
        return &isa_v4::kernels();
#endif
#if defined(TUMBLE_HAS_isa_v3)
    if (name == "x86-64-v3" && __builtin_cpu_supports("x86-64-v3"))
        return &isa_v3::kernels();
#endif
    return name == "baseline" ? &isa_baseline::kernels() : nullptr;
}

const Kernels& choose_kernels() {
    for (const char* name : {"x86-64-v4", "x86-64-v3"})
        if (const Kernels* found = kernels_named(name))
            return *found;
    return isa_baseline::kernels();
}

} // namespace tumble::render
