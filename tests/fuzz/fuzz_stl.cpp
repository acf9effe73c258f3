#include "expect.h"
#include "scene/read_stl.h"

/// Triangles that are let through are finite, and as many as the bytes can hold.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto triangles = tumble::scene::parse_stl(fuzz::text_of(data, size), "mesh.stl");
    if (!triangles) {
        fuzz::expect_helpful(triangles.problems());
        return 0;
    }
    fuzz::expect(!triangles->empty() && triangles->size() * 50 <= size, "no more triangles than there is room for");
    for (const auto& triangle : *triangles)
        for (const auto& corner : triangle)
            fuzz::expect(corner.allFinite(), "corners are finite");
    return 0;
}
