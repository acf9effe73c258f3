#pragma once

#include "base/problem.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// What does not hold is a finding, as a crash is.
inline void expect(bool holds, const char* what) {
    if (holds)
        return;
    std::cerr << "does not hold: " << what << "\n";
    std::abort();
}

/// Refusals come with a reason and a remedy, and stay readable however large the input was.
inline void expect_helpful(const tumble::Problems& problems) {
    expect(!problems.empty(), "a refusal has a problem");
    expect(problems.size() <= 1000, "at most a thousand problems");
    for (const tumble::Problem& problem : problems) {
        expect(!problem.what.empty() && !problem.fix.empty(), "a problem says what is wrong and what to do");
        expect(problem.line >= 0 && problem.column >= 0, "lines and columns count from 1, 0 is unknown");
        expect(tumble::to_string(problem).size() < 4000, "a problem is a few lines");
    }
}

} // namespace fuzz
