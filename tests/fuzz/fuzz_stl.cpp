#include "scene/read_stl.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Any bytes give triangles or problems; triangles that are let through are finite and as many as the bytes can hold.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto triangles = tumble::scene::parse_stl(bytes, "fuzz.stl");
    if (!triangles) {
        if (triangles.problems().empty())
            std::abort();
        return 0;
    }
    if (triangles->empty() || triangles->size() * 50 > size + 50)
        std::abort();
    for (const auto& triangle : *triangles)
        for (const auto& corner : triangle)
            if (!corner.allFinite())
                std::abort();
    return 0;
}
