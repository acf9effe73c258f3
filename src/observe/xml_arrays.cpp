#include "observe/xml_arrays.h"

#include <cstring>
#include <fmt/format.h>

namespace tumble::observe {

namespace {

template <class T> std::string encoded(std::span<const T> values) {
    const std::uint64_t count = values.size_bytes();
    std::string bytes(sizeof(count) + count, '\0');
    std::memcpy(bytes.data(), &count, sizeof(count));
    if (count > 0)
        std::memcpy(bytes.data() + sizeof(count), values.data(), count);
    return base64(bytes);
}

template <class T>
std::string element(std::string_view type, std::string_view name, std::span<const T> values, int components) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n", type,
        escaped(name), components, encoded(values));
}

std::string file_of(std::string_view kind, std::string_view piece, double time) {
    return fmt::format("<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                       "<{0}>\n"
                       "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                       "format=\"ascii\">{1}</DataArray>\n</FieldData>\n"
                       "{2}</{0}>\n</VTKFile>\n",
                       kind, time, piece);
}

} // namespace

std::string base64(std::string_view bytes) {
    static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? letters[(group >> (18 - 6 * k)) & 63] : '=';
    }
    return text;
}

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        case '\'':
            safe += "&apos;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

std::string data_array(std::string_view name, std::span<const float> values, int components) {
    return element("Float32", name, values, components);
}

std::string data_array(std::string_view name, std::span<const std::int64_t> values, int components) {
    return element("Int64", name, values, components);
}

std::string data_array(std::string_view name, std::span<const std::uint8_t> values, int components) {
    return element("UInt8", name, values, components);
}

std::string poly_data_file(std::string_view piece, double time) {
    return file_of("PolyData", piece, time);
}

std::string unstructured_grid_file(std::string_view piece, double time) {
    return file_of("UnstructuredGrid", piece, time);
}

} // namespace tumble::observe
