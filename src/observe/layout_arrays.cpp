#include "observe/array_rows.h"
#include "observe/frame_arrays.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <type_traits>

namespace tumble::observe {

namespace {

using Eigen::Vector3d;

nlohmann::json three(const Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

template <class T, std::size_t n>
std::optional<std::array<T, n>> head_list(const nlohmann::json& head, const char* key) {
    if (!head.contains(key) || !head[key].is_array() || head[key].size() != n)
        return std::nullopt;
    std::array<T, n> values{};
    for (std::size_t i = 0; i < n; ++i) {
        const nlohmann::json& item = head[key][i];
        if (!(std::is_same_v<T, bool> ? item.is_boolean() : item.is_number()))
            return std::nullopt;
        values[i] = item.template get<T>();
    }
    return values;
}

std::vector<std::string> head_names(const nlohmann::json& head, const char* key, std::size_t count) {
    std::vector<std::string> names(count);
    if (head.contains(key) && head[key].is_array())
        for (std::size_t i = 0; i < count && i < head[key].size(); ++i)
            if (head[key][i].is_string())
                names[i] = head[key][i];
    return names;
}

void read_domain(const nlohmann::json& head, FrameLayout& layout, Problems& problems) {
    const auto lo = head_list<double, 3>(head, "domain_lo_m");
    const auto hi = head_list<double, 3>(head, "domain_hi_m");
    const auto periodic = head_list<bool, 3>(head, "periodic");
    if (!lo || !hi || !periodic) {
        problems.push_back({.what = "has no domain_lo_m, domain_hi_m and periodic in its head"});
        return;
    }
    layout.domain_lo = Vector3d(lo->data());
    layout.domain_hi = Vector3d(hi->data());
    layout.periodic = *periodic;
}

void read_shapes(Taker& taker, const nlohmann::json& head, FrameLayout& layout) {
    const Array& mass = taker.take("shape_mass_kg", 1, false);
    const Array& inertia = taker.take("shape_inertia_kg_m2", 3, false);
    const Array& spheres = taker.take("shape_spheres", 1, true);
    const Array& centre = taker.take("sphere_centre_m", 3, false);
    const Array& radius = taker.take("sphere_radius_m", 1, false);
    taker.same_rows(mass, inertia);
    taker.same_rows(mass, spheres);
    taker.same_rows(centre, radius);
    taker.sums_to(spheres, centre);
    if (!taker.problems.empty())
        return;
    const std::vector<std::string> names = head_names(head, "shape_names", mass.rows());
    std::size_t sphere = 0;
    for (std::size_t i = 0; i < mass.rows(); ++i) {
        FrameShape shape{
            .name = names[i], .mass = mass.reals[i], .inertia = vector_at(inertia, i), .centres = {}, .radii = {}};
        for (std::int64_t k = 0; k < spheres.integers[i]; ++k, ++sphere) {
            shape.centres.push_back(vector_at(centre, sphere));
            shape.radii.push_back(radius.reals[sphere]);
        }
        layout.shapes.push_back(std::move(shape));
    }
}

void read_walls(Taker& taker, const nlohmann::json& head, FrameLayout& layout) {
    const Array& opacity = taker.take("wall_opacity", 1, false);
    const Array& vertices = taker.take("wall_vertices", 1, true);
    const Array& triangles = taker.take("wall_triangles", 1, true);
    const Array& vertex = taker.take("vertex_m", 3, false);
    const Array& triangle = taker.take("triangle", 3, true);
    const Array& lines = taker.take("wall_lines", 1, true);
    const Array& line = taker.take("line", 2, true);
    taker.same_rows(opacity, vertices);
    taker.same_rows(opacity, triangles);
    taker.same_rows(opacity, lines);
    taker.sums_to(vertices, vertex);
    taker.sums_to(triangles, triangle);
    taker.sums_to(lines, line);
    if (!taker.problems.empty())
        return;
    const std::vector<std::string> names = head_names(head, "wall_names", opacity.rows());
    std::size_t corner = 0;
    std::size_t face = 0;
    std::size_t edge = 0;
    for (std::size_t i = 0; i < opacity.rows(); ++i) {
        FrameWall wall{.name = names[i], .opacity = opacity.reals[i], .vertices = {}, .triangles = {}, .lines = {}};
        for (std::int64_t k = 0; k < vertices.integers[i]; ++k, ++corner)
            wall.vertices.push_back(vector_at(vertex, corner));
        for (std::int64_t k = 0; k < triangles.integers[i]; ++k, ++face) {
            std::array<int, 3> corners{};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::int64_t index = triangle.integers[3 * face + c];
                if (index < 0 || index >= vertices.integers[i]) {
                    taker.say(fmt::format("triangle {} of wall '{}' names a corner that is not there", k, names[i]));
                    return;
                }
                corners[c] = static_cast<int>(index);
            }
            wall.triangles.push_back(corners);
        }
        for (std::int64_t k = 0; k < lines.integers[i]; ++k, ++edge) {
            const std::int64_t from = line.integers[2 * edge], to = line.integers[2 * edge + 1];
            if (std::min(from, to) < 0 || std::max(from, to) >= vertices.integers[i]) {
                taker.say(fmt::format("line {} of wall '{}' names a point that is not there", k, names[i]));
                return;
            }
            wall.lines.push_back({static_cast<int>(from), static_cast<int>(to)});
        }
        layout.walls.push_back(std::move(wall));
    }
}

} // namespace

ArrayFile to_arrays(const FrameLayout& layout) {
    Array mass = reals("shape_mass_kg", 1), inertia = reals("shape_inertia_kg_m2", 3),
          spheres = whole("shape_spheres", 1);
    Array centre = reals("sphere_centre_m", 3), radius = reals("sphere_radius_m", 1);
    Array opacity = reals("wall_opacity", 1), vertices = whole("wall_vertices", 1),
          triangles = whole("wall_triangles", 1);
    Array vertex = reals("vertex_m", 3), triangle = whole("triangle", 3);
    Array lines = whole("wall_lines", 1), line = whole("line", 2);
    nlohmann::json head{{"title", layout.title},
                        {"dimension", layout.dimension},
                        {"domain_lo_m", three(layout.domain_lo)},
                        {"domain_hi_m", three(layout.domain_hi)},
                        {"periodic", layout.periodic},
                        {"shape_names", nlohmann::json::array()},
                        {"wall_names", nlohmann::json::array()}};
    for (const FrameShape& shape : layout.shapes) {
        head["shape_names"].push_back(shape.name);
        mass.reals.push_back(shape.mass);
        push(inertia, shape.inertia);
        spheres.integers.push_back(static_cast<std::int64_t>(shape.centres.size()));
        for (const Vector3d& one : shape.centres)
            push(centre, one);
        radius.reals.insert(radius.reals.end(), shape.radii.begin(), shape.radii.end());
    }
    for (const FrameWall& wall : layout.walls) {
        head["wall_names"].push_back(wall.name);
        opacity.reals.push_back(wall.opacity);
        vertices.integers.push_back(static_cast<std::int64_t>(wall.vertices.size()));
        triangles.integers.push_back(static_cast<std::int64_t>(wall.triangles.size()));
        for (const Vector3d& one : wall.vertices)
            push(vertex, one);
        for (const std::array<int, 3>& corners : wall.triangles)
            triangle.integers.insert(triangle.integers.end(), corners.begin(), corners.end());
        lines.integers.push_back(static_cast<std::int64_t>(wall.lines.size()));
        for (const std::array<int, 2>& ends : wall.lines)
            line.integers.insert(line.integers.end(), ends.begin(), ends.end());
    }
    return {.kind = "layout",
            .head = std::move(head),
            .arrays = {mass, inertia, spheres, centre, radius, opacity, vertices, triangles, vertex, triangle, lines,
                       line}};
}

Result<FrameLayout> layout_from(const ArrayFile& content) {
    Taker taker(content);
    FrameLayout layout;
    if (content.head.contains("title") && content.head["title"].is_string())
        layout.title = content.head["title"];
    if (content.head.contains("dimension") && content.head["dimension"] == 2)
        layout.dimension = 2;
    read_domain(content.head, layout, taker.problems);
    read_shapes(taker, content.head, layout);
    read_walls(taker, content.head, layout);
    if (!taker.problems.empty())
        return taker.problems;
    return layout;
}

} // namespace tumble::observe
