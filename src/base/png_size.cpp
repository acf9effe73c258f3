#include "base/png_size.h"

#include "base/checksum.h"

#include <cmath>
#include <cstdint>

namespace tumble {

static void put_whole(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<char>(value >> shift));
}

void insert_png_size(std::string& png, double dots_per_metre) {
    constexpr std::size_t after_header = 8 + 12 + 13; // signature; length, name, sum and content of IHDR
    const auto dots = static_cast<std::uint32_t>(std::lround(dots_per_metre));
    std::string content = "pHYs";
    put_whole(content, dots);
    put_whole(content, dots);
    content.push_back(1); // the unit is the metre
    std::string chunk;
    put_whole(chunk, static_cast<std::uint32_t>(content.size() - 4));
    chunk += content;
    put_whole(chunk, crc32(content));
    png.insert(after_header, chunk);
}

} // namespace tumble
