#include "expect.h"
#include "scene/read_table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto text = fuzz::text_of(data, size);
    if (const auto table = tumble::scene::parse_motion_table(text, "table.csv"); !table)
        fuzz::expect_helpful(table.problems());
    if (const auto harmonics = tumble::scene::parse_harmonics(text, "harmonics.csv"); !harmonics)
        fuzz::expect_helpful(harmonics.problems());
    return 0;
}
