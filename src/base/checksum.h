#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace tumble {

/// CRC-32 as zip and zlib use it (polynomial 0xEDB88320 reflected, start and end inverted), so that other tools can
/// check a file: Python's zlib.crc32 gives the same number. crc32("123456789") = 0xCBF43926.
std::uint32_t crc32(std::string_view bytes);

} // namespace tumble
