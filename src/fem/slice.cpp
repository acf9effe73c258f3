#include "fem/slice.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>

namespace tumble::fem {

using Eigen::Vector3d;

namespace {

constexpr double across_axis = 0.9; // cosine between a facet's normal and the axis from which on it is an end's
constexpr double most_along = 0.9;  // of an axis, along z, that leaves enough of z across it

/// Of a side at one of its nodes.
struct Surface {
    Vector3d outward = Vector3d::Zero(); // m2, along the normal
    double area = 0;                     // m2
};

struct Line {
    Vector3d from, way; // m
};

/// Edges that one facet of a side has alone.
std::vector<Line> ends_of(const solid::HexMesh& mesh, const std::vector<int>& side) {
    std::map<std::pair<int, int>, int> facets; // by the edge's nodes
    for (const int facet : side)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto& corners = mesh.facets[static_cast<std::size_t>(facet)].corners;
            ++facets[std::minmax({corners[k], corners[(k + 1) % 4]})];
        }
    std::vector<Line> lines;
    for (const auto& [edge, count] : facets) {
        const Vector3d& from = mesh.nodes[static_cast<std::size_t>(edge.first)];
        if (count == 1)
            lines.push_back({from, mesh.nodes[static_cast<std::size_t>(edge.second)] - from});
    }
    return lines;
}

double distance(const Vector3d& place, const Line& line) {
    const Vector3d off = place - line.from;
    return (off - std::clamp(off.dot(line.way) / line.way.squaredNorm(), 0.0, 1.0) * line.way).norm();
}

/// Seen from above along y, x lies to the right then.
Vector3d up_across(const Vector3d& axis) {
    const Vector3d way = std::abs(axis.z()) < most_along ? Vector3d(-Vector3d::UnitZ()) : Vector3d(Vector3d::UnitY());
    return (way - axis.dot(way) * axis).normalized();
}

std::string names_of(const std::map<std::string, std::vector<int>>& sets) {
    std::string names;
    for (const auto& [name, members] : sets)
        names += (names.empty() ? "" : ", ") + name;
    return names;
}

Stress stress_at(const solid::Inside& inside, const solid::HexMesh& mesh, const Eigen::VectorXd& stress) {
    Stress sum = Stress::Zero();
    for (std::size_t k = 0; k < 8; ++k)
        sum += inside.shares[static_cast<Eigen::Index>(k)] *
               stress.segment<6>(6 * mesh.hexes[static_cast<std::size_t>(inside.hex)][k]);
    return sum;
}

} // namespace

Result<Slice> slice_of(const solid::HexMesh& mesh, const solid::Locator& locator, const std::string& side,
                       const Vector3d& axis, double depth) {
    const auto found = mesh.facet_sets.find(side);
    if (found == mesh.facet_sets.end())
        return Problem{.what = fmt::format("the part has no side '{}'", side),
                       .fix = "it has " + names_of(mesh.facet_sets)};
    std::map<int, Surface> nodes;
    const auto is_across = [&](int facet) {
        return std::abs(mesh.area_of(facet).dot(axis)) > across_axis * mesh.area_of(facet).norm();
    };
    const bool across = is_across(found->second.front());
    for (const int facet : found->second) {
        const Vector3d area = mesh.area_of(facet);
        const solid::Facet& of = mesh.facets[static_cast<std::size_t>(facet)];
        if (is_across(facet) != across)
            return Problem{.what = fmt::format("side '{}' lies {} the axis at element {}, and {} it elsewhere", side,
                                               across ? "along" : "across",
                                               mesh.hex_numbers[static_cast<std::size_t>(of.hex)],
                                               across ? "across" : "along"),
                           .fix = "slices lie beneath sides along the axis, or beneath ends across it"};
        for (const int node : of.corners) {
            nodes[node].outward += area;
            nodes[node].area += area.norm() / 4;
        }
    }
    const std::vector<Line> ends = ends_of(mesh, found->second);
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest; // m, along the axis
    for (const Vector3d& node : mesh.nodes) {
        lowest = std::min(lowest, node.dot(axis));
        highest = std::max(highest, node.dot(axis));
    }
    Slice slice{side, depth, {}, across ? up_across(axis) : axis};
    for (const auto& [node, surface] : nodes) {
        const Vector3d normal = surface.outward.normalized();
        SlicePoint point{node,
                         surface.area,
                         mesh.nodes[static_cast<std::size_t>(node)] - depth * normal,
                         {},
                         directions_of(normal, slice.up)};
        const auto inside = locator.find(point.place);
        if (!inside)
            return Problem{.what = fmt::format("{:.4g} m beneath side '{}' at node {} the part ends", depth, side,
                                               mesh.node_numbers[static_cast<std::size_t>(node)]),
                           .fix = "take a smaller depth"};
        point.inside = *inside;
        const Vector3d& above = mesh.nodes[static_cast<std::size_t>(node)];
        for (const Line& end : ends)
            point.edge = std::min(point.edge, distance(above, end));
        point.height = (above.dot(axis) - lowest) / (highest - lowest);
        slice.points.push_back(point);
    }
    return slice;
}

Eigen::Matrix3Xd components_on(const Slice& slice, const solid::HexMesh& mesh, const Eigen::VectorXd& stress) {
    Eigen::Matrix3Xd parts(3, static_cast<Eigen::Index>(slice.points.size()));
    for (std::size_t p = 0; p < slice.points.size(); ++p)
        parts.col(static_cast<Eigen::Index>(p)) =
            components(stress_at(slice.points[p].inside, mesh, stress), slice.points[p].directions);
    return parts;
}

SliceFigures figures_of(const Slice& slice, const Eigen::Matrix3Xd& parts, const Counting& counting) {
    SliceFigures figures;
    double area = 0, edge_area = 0;
    for (std::size_t p = 0; p < slice.points.size(); ++p) {
        const Vector3d part = parts.col(static_cast<Eigen::Index>(p));
        const SlicePoint& point = slice.points[p];
        if (!counting.takes(point))
            continue;
        const double here = point.area;
        const bool at_edge = point.edge <= counting.edge;
        area += here;
        edge_area += at_edge ? here : 0;
        (at_edge ? figures.near_edges : figures.elsewhere) += here * std::abs(part[0]);
        if (std::abs(part[0]) > std::abs(figures.normal)) {
            figures.normal = part[0];
            figures.worst_point = static_cast<int>(p);
        }
        figures.contour = std::max(figures.contour, std::abs(part[1]));
        figures.along = std::max(figures.along, std::abs(part[2]));
        figures.compression = std::min(figures.compression, part[0]);
        figures.tension = std::max(figures.tension, part[0]);
        if (part[0] < -counting.trivial) {
            figures.mean_compression += part[0];
            figures.compressed_area += here;
            ++figures.compressed;
        } else if (part[0] > counting.trivial) {
            figures.mean_tension += part[0];
            figures.stretched_area += here;
            ++figures.stretched;
        }
    }
    if (!(area > 0))
        for (double* figure : {&figures.normal, &figures.contour, &figures.along, &figures.compression,
                               &figures.tension, &figures.mean_compression, &figures.mean_tension})
            *figure = std::numeric_limits<double>::quiet_NaN();
    figures.mean_compression /= std::max(figures.compressed, 1);
    figures.mean_tension /= std::max(figures.stretched, 1);
    figures.compressed_area /= area;
    figures.stretched_area /= area;
    figures.near_edges /= edge_area;
    figures.elsewhere /= area - edge_area;
    return figures;
}

} // namespace tumble::fem
