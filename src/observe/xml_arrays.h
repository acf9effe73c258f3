#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// The pieces of VTK's XML files that our exports share. Format: "VTK File Formats",
/// vtk.org/wp-content/uploads/2015/04/file-formats.pdf
namespace tumble::observe {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);
/// Quotes, ampersands and angle brackets written as entities, for text and attributes.
std::string escaped(std::string_view text);

/// <DataArray> elements with base64 content behind a 64-bit byte count; one component is a plain scalar.
std::string data_array(std::string_view name, std::span<const float> values, int components);
std::string data_array(std::string_view name, std::span<const std::int64_t> values, int components);
std::string data_array(std::string_view name, std::span<const std::uint8_t> values, int components);

/// The file around one <Piece> of PolyData (.vtp) or of an UnstructuredGrid (.vtu). `time` is stored as the field
/// TimeValue that ParaView shows, s.
std::string poly_data_file(std::string_view piece, double time);
std::string unstructured_grid_file(std::string_view piece, double time);

} // namespace tumble::observe
