#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tumble {

/// 64-bit FNV-1a (Fowler, Noll, Vo; offset basis and prime as in draft-eastlake-fnv), fed piece by piece: the same
/// bytes give the same value however they are cut, on every platform. Finds accidents, not attackers.
class Hash64 {
public:
    Hash64& add(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes)
            add_byte(std::to_integer<std::uint64_t>(byte));
        return *this;
    }
    Hash64& add(std::string_view text) { return add(std::as_bytes(std::span(text.data(), text.size()))); }

    /// Whole numbers count as 8 bytes, lowest first, whatever their type.
    template <std::integral Integer> Hash64& add(Integer number) {
        auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
        for (int i = 0; i < 8; ++i, bits >>= 8)
            add_byte(bits & 0xff);
        return *this;
    }
    /// By bits: 0.0 and -0.0 differ.
    Hash64& add(double number) { return add(std::bit_cast<std::int64_t>(number)); }

    [[nodiscard]] std::uint64_t value() const { return value_; }
    /// 16 hexadecimal digits.
    [[nodiscard]] std::string hex() const;

private:
    void add_byte(std::uint64_t byte) { value_ = (value_ ^ byte) * 0x00000100000001b3u; }

    std::uint64_t value_ = 0xcbf29ce484222325u;
};

} // namespace tumble
