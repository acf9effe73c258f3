#include "expect.h"
#include "solid/inp.h"
#include "whole_mesh.h"

/// A mesh that is let through has eight nodes of its own to each hexahedron, and its sets name nodes that are there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto mesh = tumble::solid::parse_inp(fuzz::text_of(data, size), "part.inp");
    if (!mesh) {
        fuzz::expect_helpful(mesh.problems());
        return 0;
    }
    fuzz::expect_whole(*mesh);
    return 0;
}
