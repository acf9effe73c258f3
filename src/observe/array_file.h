#pragma once

#include "base/problem.h"

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// Files of named arrays that other tools can read: docs/run-folder.md describes every byte.
namespace tumble::observe {

/// Rows of `width` numbers, either doubles or 64-bit integers.
struct Array {
    std::string name; // unit included
    std::size_t width = 1;
    std::vector<double> reals;
    std::vector<std::int64_t> integers;
    bool whole = false; // integers hold the content

    [[nodiscard]] std::size_t rows() const { return (whole ? integers.size() : reals.size()) / width; }
};

struct ArrayFile {
    std::string kind;    // "frame", "layout"
    nlohmann::json head; // further plain facts
    std::vector<Array> arrays;

    /// The array with this name, real or whole as asked, width as asked, or a problem that says what is there instead.
    [[nodiscard]] Result<const Array*> find(const std::string& name, std::size_t width, bool whole) const;
};

/// The bytes of the file.
std::string to_bytes(const ArrayFile& content);

/// Problems: not such a file, a newer version, another kind, cut off, changed (checksum), arrays outside the file.
/// `file` only names the file in problems.
Result<ArrayFile> from_bytes(const std::string& bytes, const std::string& kind, const std::filesystem::path& file);

} // namespace tumble::observe
