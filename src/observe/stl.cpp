#include "observe/stl.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace tumble::observe {

namespace {

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

template <class Value> void append(std::string& bytes, Value value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

void append(std::string& bytes, const Eigen::Vector3d& vector) {
    for (int k = 0; k < 3; ++k)
        append(bytes, static_cast<float>(vector[k]));
}

} // namespace

std::string stl_bytes(const FrameWall& wall, const WallPlace& place) {
    std::string bytes = "tumble: wall " + wall.name + ", metres"; // not "solid", which some readers take for ASCII
    bytes.resize(80, '\0');
    append(bytes, static_cast<std::uint32_t>(wall.triangles.size()));
    for (const auto& triangle : wall.triangles) {
        std::array<Eigen::Vector3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = place.rotation * wall.vertices[static_cast<std::size_t>(triangle[k])] + place.translation;
        const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        append(bytes, normal);
        for (const Eigen::Vector3d& corner : corners)
            append(bytes, corner);
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

} // namespace tumble::observe
