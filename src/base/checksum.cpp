#include "base/checksum.h"

#include <array>
#include <cstddef>

namespace tumble {

namespace {

constexpr std::size_t lanes = 8;
using Tables = std::array<std::array<std::uint32_t, 256>, lanes>;

/// tables[k][b]: what byte b does to the checksum when k more bytes follow it.
constexpr Tables make_tables() {
    Tables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) ? 0xEDB88320u : 0u);
        tables[0][byte] = value;
    }
    for (std::size_t k = 1; k < lanes; ++k)
        for (std::size_t byte = 0; byte < 256; ++byte)
            tables[k][byte] = (tables[k - 1][byte] >> 8) ^ tables[0][tables[k - 1][byte] & 0xFF];
    return tables;
}

constexpr Tables tables = make_tables();

} // namespace

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t value = 0xFFFFFFFFu;
    std::size_t at = 0;
    for (; at + lanes <= bytes.size(); at += lanes) {
        std::uint32_t next = 0;
        for (std::size_t k = 0; k < lanes; ++k) {
            const auto byte = static_cast<unsigned char>(bytes[at + k]);
            const std::uint32_t mixed = k < 4 ? byte ^ ((value >> (8 * k)) & 0xFF) : byte;
            next ^= tables[lanes - 1 - k][mixed & 0xFF];
        }
        value = next;
    }
    for (; at < bytes.size(); ++at)
        value = (value >> 8) ^ tables[0][(value ^ static_cast<unsigned char>(bytes[at])) & 0xFF];
    return value ^ 0xFFFFFFFFu;
}

} // namespace tumble
