#include "expect.h"
#include "solid/msh.h"
#include "whole_mesh.h"

/// As fuzz_inp.cpp, of gmsh's format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto mesh = tumble::solid::parse_msh(fuzz::text_of(data, size), "part.msh");
    if (!mesh) {
        fuzz::expect_helpful(mesh.problems());
        return 0;
    }
    fuzz::expect_whole(*mesh);
    return 0;
}
