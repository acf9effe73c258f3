#include "stress/fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
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

/// Where a slice's points go when it is rolled out, m.
class Rolling {
public:
    Rolling(const fem::Slice& slice, const Vector3d& base, const Vector3d& axis, const Vector3d& ahead)
        : base_(base), axis_(axis), ahead_((ahead - axis.dot(ahead) * axis).normalized()), left_(axis.cross(ahead_)) {
        const Vector3d& first = slice.points.front().directions.normal;
        round_ = std::any_of(slice.points.begin(), slice.points.end(),
                             [&](const fem::SlicePoint& p) { return p.directions.normal.dot(first) < 1 - 1e-9; });
        contour_ = slice.points.front().directions.contour;
    }

    [[nodiscard]] Vector3d operator()(const Vector3d& place) const {
        const Vector3d arm = place - base_;
        const double height = axis_.dot(arm);
        if (!round_)
            return {contour_.dot(arm), height, 0};
        const double x = ahead_.dot(arm), y = left_.dot(arm);
        return {std::hypot(x, y) * std::atan2(y, x), height, 0};
    }
    /// m, from one edge of a slice that goes all the way round to the other; 0 where it is flat.
    [[nodiscard]] double round(const Vector3d& place) const {
        const Vector3d arm = place - base_;
        return round_ ? 2 * std::numbers::pi * std::hypot(ahead_.dot(arm), left_.dot(arm)) : 0;
    }

private:
    Vector3d base_, axis_, ahead_, left_, contour_;
    bool round_ = false;
};

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
                             const Vector3d& axis, const Vector3d& ahead, const std::vector<double>& values) {
    const Rolling rolling(slice, base, axis, ahead);
    render::Field field;
    field.has_sign = true;
    field.unit = "Pa";
    field.values = values;
    std::map<int, int> point_of; // by node
    for (const fem::SlicePoint& point : slice.points) {
        point_of[point.node] = static_cast<int>(field.points.size());
        field.points.push_back(rolling(point.place));
    }
    Lines lines;
    std::map<int, int> again; // points before the cut, once more behind it
    for (const int facet : mesh.facet_sets.at(slice.side)) {
        std::array<int, 4> corners{};
        double most = -std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 4; ++k) {
            corners[k] = point_of.at(mesh.facets[static_cast<std::size_t>(facet)].corners[k]);
            most = std::max(most, field.points[static_cast<std::size_t>(corners[k])].x());
        }
        for (int& corner : corners) {
            const auto from = static_cast<std::size_t>(corner);
            const double round = from < slice.points.size() ? rolling.round(slice.points[from].place) : 0;
            if (round == 0 || most - field.points[from].x() < 0.5 * round)
                continue;
            const auto [found, fresh] = again.try_emplace(corner, static_cast<int>(field.points.size()));
            if (fresh) {
                field.points.push_back(field.points[from] + Vector3d(round, 0, 0));
                field.values.push_back(values[from]);
            }
            corner = found->second;
        }
        add_quad(corners, field);
        add_edges(corners, lines);
    }
    put(lines, field);
    return field;
}

} // namespace tumble::stress
