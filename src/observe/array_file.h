#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// Files of named arrays that other tools can read: docs/run-folder.md describes every byte.
namespace tumble::observe {

/// What the rows of an array are made of: doubles, 64-bit integers or bytes.
enum class ArrayType { real, whole, byte };

/// Rows of `width` numbers; one of the three holds the content.
struct Array {
    std::string name; // unit included
    std::size_t width = 1;
    ArrayType type = ArrayType::real;
    std::vector<double> reals{};
    std::vector<std::int64_t> integers{};
    std::string bytes{};

    [[nodiscard]] std::size_t rows() const;
};

struct ArrayFile {
    std::string kind;    // "frame", "layout", "checkpoint"
    nlohmann::json head; // further plain facts
    std::vector<Array> arrays;

    /// The array with this name, type and width as asked, or a problem that says what is there instead.
    [[nodiscard]] Result<const Array*> find(const std::string& name, std::size_t width, ArrayType type) const;
};

/// The bytes of the file.
std::string to_bytes(const ArrayFile& content);

/// Problems: not such a file, a newer version, another kind, cut off, changed (checksum), arrays outside the file.
/// `file` only names the file in problems.
Result<ArrayFile> from_bytes(const std::string& bytes, const std::string& kind, const std::filesystem::path& file);

/// What a file says of itself: its head, without any array's content. Its length must be that which the head asks for,
/// so that a file that was cut off is found out; what was changed is not, because the checksum is one of all bytes and
/// is left to from_bytes. Problems: else as from_bytes.
Result<nlohmann::json> read_head(const std::filesystem::path& file, const std::string& kind);

} // namespace tumble::observe
