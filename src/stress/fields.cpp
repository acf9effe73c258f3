#include "stress/fields.h"

#include "stress/roll_out.h"

#include <algorithm>
#include <map>
#include <set>

namespace tumble::stress {

using Eigen::Vector3d;

namespace {

using Lines = std::set<std::pair<int, int>>;

void add_edges(const std::array<int, 4>& corners, Lines& lines) {
    for (std::size_t k = 0; k < 4; ++k)
        lines.insert(std::minmax(corners[k], corners[(k + 1) % 4]));
}

void add_quad(const std::array<int, 4>& corners, render::Field& field) {
    field.triangles.push_back({corners[0], corners[1], corners[2]});
    field.triangles.push_back({corners[0], corners[2], corners[3]});
}

void put(const Lines& lines, render::Field& field) {
    for (const auto& [a, b] : lines)
        field.lines.push_back({a, b});
}

Vector3d placed(const observe::WallPlace& place, const Vector3d& point) {
    return place.rotation * point + place.translation;
}

} // namespace

std::vector<double> at_nodes(const fem::Component& component, const Eigen::VectorXd& stress) {
    std::vector<double> values;
    for (Eigen::Index node = 0; node < stress.size() / 6; ++node)
        values.push_back(component.of(stress.segment<6>(6 * node)));
    return values;
}

render::Field surface_field(const solid::HexMesh& mesh, const observe::WallPlace& place,
                            const std::vector<double>& values) {
    render::Field field;
    for (const Vector3d& node : mesh.nodes)
        field.points.push_back(placed(place, node));
    field.values = values;
    Lines lines;
    for (const solid::Facet& facet : mesh.facets) {
        add_quad(facet.corners, field);
        add_edges(facet.corners, lines);
    }
    put(lines, field);
    return field;
}

render::Field section_field(const solid::HexMesh& mesh, const solid::Section& section, const observe::WallPlace& place,
                            const std::vector<double>& values) {
    render::Field field;
    for (const solid::CutPoint& point : section.points) {
        field.points.push_back(placed(place, point.of(mesh.nodes)));
        field.values.push_back(point.of(values));
    }
    field.triangles = section.triangles;
    field.lines = section.lines;
    return field;
}

render::Field unrolled_field(const solid::HexMesh& mesh, const fem::Slice& slice, const Vector3d& base,
                             const Vector3d& ahead, const std::vector<double>& values) {
    std::map<int, std::size_t> at; // into the slice's points, by node
    for (std::size_t p = 0; p < slice.points.size(); ++p)
        at[slice.points[p].node] = p;
    const RolledOut rolled = rolled_out(mesh, slice, base, ahead);
    render::Field field;
    field.has_sign = true;
    field.unit = "Pa";
    for (const RolledOut::Point& point : rolled.points) {
        const std::size_t p = at.at(point.node);
        field.points.emplace_back(point.along, slice.up.dot(slice.points[p].place - base), 0);
        field.values.push_back(values[p]);
    }
    Lines lines;
    for (const std::array<int, 4>& corners : rolled.facets) {
        add_quad(corners, field);
        add_edges(corners, lines);
    }
    put(lines, field);
    return field;
}

} // namespace tumble::stress
