#include "observe/array_file.h"

#include "base/checksum.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace tumble::observe {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory, little end first");

namespace {

constexpr std::string_view magic("tumble\r\n", 8); // a transfer that changes line ends shows at once
constexpr std::uint32_t version = 1;
constexpr std::size_t preamble = 16; // magic, version, length of the head
constexpr std::size_t trailer = 4;   // checksum

/// What files and problems call a type, and bytes per number.
struct TypeName {
    ArrayType type;
    const char* code; // as numpy has it
    const char* word;
    std::size_t size;
};
constexpr std::array<TypeName, 3> type_names{
    {{ArrayType::real, "<f8", "real", 8}, {ArrayType::whole, "<i8", "whole", 8}, {ArrayType::byte, "|u1", "byte", 1}}};

const TypeName& name_of(ArrayType type) {
    return type_names[static_cast<std::size_t>(type)];
}

std::string_view bytes_of(const Array& array) {
    switch (array.type) {
    case ArrayType::real:
        return {reinterpret_cast<const char*>(array.reals.data()), array.reals.size() * sizeof(double)};
    case ArrayType::whole:
        return {reinterpret_cast<const char*>(array.integers.data()), array.integers.size() * sizeof(std::int64_t)};
    default:
        return array.bytes;
    }
}

std::string four_bytes(std::uint32_t number) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &number, 4);
    return bytes;
}

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + offset, 4);
    return number;
}

/// What the head says about one array, checked against the bytes that follow the head.
struct Entry {
    std::string name;
    TypeName type;
    std::size_t rows = 0;
    std::size_t width = 0;
    std::size_t offset = 0;
};

std::optional<Entry> entry_of(const nlohmann::json& json, std::size_t available) {
    if (!json.is_object() || !json.contains("shape") || !json["shape"].is_array() || json["shape"].size() != 2)
        return std::nullopt;
    for (const char* key : {"name", "type"})
        if (!json.contains(key) || !json[key].is_string())
            return std::nullopt;
    if (!json.contains("offset"))
        return std::nullopt;
    for (const nlohmann::json& number : {json["shape"][0], json["shape"][1], json["offset"]})
        if (!number.is_number_unsigned())
            return std::nullopt;
    const auto type = std::find_if(type_names.begin(), type_names.end(),
                                   [&](const TypeName& known) { return json["type"] == known.code; });
    if (type == type_names.end())
        return std::nullopt;
    const Entry entry{json["name"], *type, json["shape"][0], json["shape"][1], json["offset"]};
    const bool sane = entry.width > 0 && entry.width <= 16 && entry.offset <= available &&
                      entry.rows <= (available - entry.offset) / (type->size * entry.width);
    return sane ? std::optional(entry) : std::nullopt;
}

Array array_of(const Entry& entry, const char* data) {
    Array array{.name = entry.name, .width = entry.width, .type = entry.type.type};
    const std::size_t count = entry.rows * entry.width;
    switch (array.type) {
    case ArrayType::real:
        array.reals.resize(count);
        std::memcpy(array.reals.data(), data + entry.offset, count * sizeof(double));
        break;
    case ArrayType::whole:
        array.integers.resize(count);
        std::memcpy(array.integers.data(), data + entry.offset, count * sizeof(std::int64_t));
        break;
    case ArrayType::byte:
        array.bytes.assign(data + entry.offset, count);
        break;
    }
    return array;
}

} // namespace

std::size_t Array::rows() const {
    return bytes_of(*this).size() / name_of(type).size / width;
}

Result<const Array*> ArrayFile::find(const std::string& name, std::size_t width, ArrayType type) const {
    for (const Array& array : arrays)
        if (array.name == name) {
            if (array.width == width && array.type == type)
                return &array;
            return Problem{.what = fmt::format("array '{}' has {} {} numbers a row, expected {} {}", name, array.width,
                                               name_of(array.type).word, width, name_of(type).word)};
        }
    return Problem{.what = fmt::format("has no array '{}'", name)};
}

std::string to_bytes(const ArrayFile& content) {
    nlohmann::json head = content.head.is_null() ? nlohmann::json::object() : content.head;
    head["kind"] = content.kind;
    head["arrays"] = nlohmann::json::array();
    std::size_t offset = 0;
    for (const Array& array : content.arrays) {
        head["arrays"].push_back({{"name", array.name},
                                  {"type", name_of(array.type).code},
                                  {"shape", {array.rows(), array.width}},
                                  {"offset", offset}});
        offset += bytes_of(array).size();
    }
    std::string text = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    text.resize((text.size() + 15) / 16 * 16, ' '); // arrays then start aligned, so that they can be mapped
    std::string bytes(magic);
    bytes += four_bytes(version) + four_bytes(static_cast<std::uint32_t>(text.size())) + text;
    bytes.reserve(bytes.size() + offset + trailer);
    for (const Array& array : content.arrays)
        bytes += bytes_of(array);
    bytes += four_bytes(crc32(bytes));
    return bytes;
}

namespace {

/// Problems are of that file.
struct In {
    const std::filesystem::path& file;

    [[nodiscard]] Problem wrong(std::string what, std::string fix = "give a file that tumble wrote") const {
        return {.file = file.string(), .what = std::move(what), .fix = std::move(fix)};
    }
    [[nodiscard]] Problem cut_off(std::string what = "is cut off") const {
        return wrong(std::move(what), "remove this file, or run the scene again");
    }
};

/// Length of the head of a file that begins with these bytes and has `size` of them.
Result<std::size_t> head_size(std::string_view bytes, std::uintmax_t size, const In& in) {
    if (bytes.substr(0, magic.size()) != magic)
        return in.wrong("is no tumble file (its first eight bytes differ)");
    if (size < preamble + trailer || bytes.size() < preamble)
        return in.cut_off();
    if (number_at(bytes, 8) != version)
        return in.wrong(
            fmt::format("has version {} of the format, this program reads version {}", number_at(bytes, 8), version));
    const std::size_t length = number_at(bytes, 12);
    if (length > size - preamble - trailer)
        return in.cut_off();
    return length;
}

Result<nlohmann::json> head_of(std::string_view text, const std::string& kind, const In& in) {
    nlohmann::json head = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    if (!head.is_object() || !head.contains("arrays") || !head["arrays"].is_array())
        return in.wrong("has a head that is no JSON object with arrays");
    const std::string found = head.contains("kind") && head["kind"].is_string() ? head["kind"] : "";
    if (found != kind)
        return in.wrong(fmt::format("holds a '{}', not a '{}'", found, kind));
    return head;
}

Problem not_in_it(const nlohmann::json& array, const In& in) {
    return in.wrong("describes an array that is not in it: " + excerpt(array.dump(), 200));
}

} // namespace

Result<ArrayFile> from_bytes(const std::string& bytes, const std::string& kind, const std::filesystem::path& file) {
    const In in{file};
    const auto length = head_size(bytes, bytes.size(), in);
    if (!length)
        return length.problems();
    if (crc32(std::string_view(bytes).substr(0, bytes.size() - trailer)) != number_at(bytes, bytes.size() - trailer))
        return in.cut_off("is cut off or was changed: its checksum does not fit");
    auto head = head_of(std::string_view(bytes).substr(preamble, *length), kind, in);
    if (!head)
        return head.problems();
    ArrayFile content{kind, std::move(*head), {}};
    const std::size_t start = preamble + *length;
    for (const nlohmann::json& json : content.head["arrays"]) {
        const std::optional<Entry> entry = entry_of(json, bytes.size() - trailer - start);
        if (!entry)
            return not_in_it(json, in);
        content.arrays.push_back(array_of(*entry, bytes.data() + start));
    }
    return content;
}

Result<nlohmann::json> read_head(const std::filesystem::path& file, const std::string& kind) {
    const In in{file};
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(preamble, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (error || (!stream && !stream.eof()))
        return Problem{.file = file.string(), .what = "cannot be read", .fix = "look at who may read it"};
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    const auto length = head_size(bytes, size, in);
    if (!length)
        return length.problems();
    std::string text(*length, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream)
        return in.cut_off();
    auto head = head_of(text, kind, in);
    if (!head)
        return head.problems();
    std::size_t end = 0; // of the arrays
    for (const nlohmann::json& json : (*head)["arrays"]) {
        const std::optional<Entry> entry = entry_of(json, size - trailer - preamble - *length);
        if (!entry)
            return not_in_it(json, in);
        end = std::max(end, entry->offset + entry->rows * entry->width * entry->type.size);
    }
    if (end != size - trailer - preamble - *length)
        return in.cut_off("is not as long as it says");
    return head;
}

} // namespace tumble::observe
