#include "scene/read_clump.h"
#include "scene/read_table.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// Any text gives spheres or problems, and the same for the other tables of numbers that a scene reads.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto spheres = tumble::scene::parse_clump(text, "fuzz.csv");
    if (!spheres && spheres.problems().empty())
        std::abort();
    if (spheres)
        for (const auto& sphere : *spheres)
            if (!(sphere.radius > 0) || !sphere.centre.allFinite())
                std::abort();
    const auto table = tumble::scene::parse_motion_table(text, "fuzz.csv");
    if (table && (table->time.size() < 2 || table->time.size() != table->displacement.size()))
        std::abort();
    const auto harmonics = tumble::scene::parse_harmonics(text, "fuzz.csv");
    if (harmonics)
        for (const auto& harmonic : *harmonics)
            if (harmonic.axis < 0 || harmonic.axis > 2 || !(harmonic.frequency > 0))
                std::abort();
    return 0;
}
