#include "expect.h"
#include "scene/read_clump.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto spheres = tumble::scene::parse_clump(fuzz::text_of(data, size), "clump.csv");
    if (!spheres) {
        fuzz::expect_helpful(spheres.problems());
        return 0;
    }
    fuzz::expect(!spheres->empty(), "a body has spheres");
    for (const auto& sphere : *spheres)
        fuzz::expect(sphere.radius > 0 && sphere.centre.allFinite(), "spheres are finite and have a size");
    return 0;
}
