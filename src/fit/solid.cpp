#include "fit/solid.h"

#include "base/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>

namespace tumble::fit {

namespace {

using Eigen::Vector3d;

/// Corners nearer than this share of the solid's size are one: STL files hold single precision.
constexpr double weld_share = 1e-6;

double size_of(const std::vector<Triangle>& faces) {
    Eigen::AlignedBox3d box;
    for (const Triangle& face : faces)
        for (const Vector3d& corner : face)
            box.extend(corner);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// A number for each corner, the same for corners in one place. Places are cells of a grid, and the cells around are
/// asked as well, so that no pair falls apart at a cell's side.
class Corners {
public:
    explicit Corners(double size) : cell_(std::max(size * weld_share, 1e-300)) {}

    int number_of(const Vector3d& corner) {
        const std::array<long long, 3> own = cell_of(corner);
        for (long long x = -1; x <= 1; ++x)
            for (long long y = -1; y <= 1; ++y)
                for (long long z = -1; z <= 1; ++z)
                    if (const auto found = known_.find({own[0] + x, own[1] + y, own[2] + z}); found != known_.end())
                        return found->second;
        return known_.emplace(own, static_cast<int>(known_.size())).first->second;
    }

private:
    [[nodiscard]] std::array<long long, 3> cell_of(const Vector3d& p) const {
        return {std::llround(p.x() / cell_), std::llround(p.y() / cell_), std::llround(p.z() / cell_)};
    }
    double cell_;
    std::map<std::array<long long, 3>, int> known_;
};

/// How often each edge is walked in either direction; a closed, evenly turned surface walks each once there and back.
Problems open_edges(const std::vector<Triangle>& faces) {
    Corners corners(size_of(faces));
    std::map<std::pair<int, int>, std::array<int, 2>> walks;
    for (const Triangle& face : faces) {
        const std::array<int, 3> at{corners.number_of(face[0]), corners.number_of(face[1]), corners.number_of(face[2])};
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = at[k], to = at[(k + 1) % 3];
            ++walks[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1];
        }
    }
    int open = 0, turned = 0;
    for (const auto& [edge, count] : walks) {
        open += count[0] + count[1] != 2 ? 1 : 0;
        turned += count[0] + count[1] == 2 && count[0] != 1 ? 1 : 0;
    }
    Problems problems;
    if (open > 0)
        problems.push_back({.what = fmt::format("the mesh is not closed: {} of its {} edges do not belong to exactly "
                                                "two triangles",
                                                open, walks.size()),
                            .fix = "a body has an inside: close the holes in a mesh editor"});
    if (turned > 0)
        problems.push_back(
            {.what = fmt::format("neighbouring triangles are turned against each other at {} edges", turned),
             .fix = "let a mesh editor make the normals consistent"});
    return problems;
}

/// Integrals over the tetrahedra from the origin to each face (Tonon 2004, "Explicit exact formulas for the 3-D
/// tetrahedron inertia tensor", in its covariance form).
void add_moments(Solid& solid) {
    Vector3d first = Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Triangle& face : solid.faces) {
        const double volume = face[0].dot(face[1].cross(face[2])) / 6;
        const Vector3d sum = face[0] + face[1] + face[2];
        solid.volume += volume;
        solid.area += (face[1] - face[0]).cross(face[2] - face[0]).norm() / 2;
        first += volume / 4 * sum;
        second += volume / 20 *
                  (face[0] * face[0].transpose() + face[1] * face[1].transpose() + face[2] * face[2].transpose() +
                   sum * sum.transpose());
    }
    solid.centre = first / solid.volume;
    solid.second = second - solid.volume * solid.centre * solid.centre.transpose();
}

/// Solid angle of the face seen from the origin, Van Oosterom and Strackee 1983.
double solid_angle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool encloses(const Solid& solid, const Vector3d& point) {
    double angle = 0; // 4 pi inside, 0 outside
    for (const Triangle& face : solid.faces)
        angle += solid_angle(face[0] - point, face[1] - point, face[2] - point);
    return angle > 2 * std::numbers::pi;
}

} // namespace

Result<Solid> solid_of(std::vector<Triangle> faces) {
    if (Problems problems = open_edges(faces); !problems.empty())
        return problems;
    Solid solid;
    solid.faces = std::move(faces);
    add_moments(solid);
    if (solid.volume < 0) { // turned inwards
        for (Triangle& face : solid.faces)
            std::swap(face[1], face[2]);
        solid.volume = solid.area = 0;
        add_moments(solid);
    }
    if (!(solid.volume > 1e-12 * std::pow(size_of(solid.faces), 3)))
        return Problem{.what = "the mesh encloses no volume", .fix = "give a closed surface around the body"};
    return solid;
}

Solid solid_of(const Cone& cone) {
    constexpr int corners = 720;
    const auto rim = [&](int i) {
        const double angle = 2 * std::numbers::pi * (i % corners) / corners;
        return Vector3d(cone.diameter / 2 * std::cos(angle), 0, cone.diameter / 2 * std::sin(angle));
    };
    Solid solid;
    for (int i = 0; i < corners; ++i) {
        solid.faces.push_back({Vector3d::Zero(), rim(i), rim(i + 1)});
        solid.faces.push_back({Vector3d(0, cone.height, 0), rim(i + 1), rim(i)});
    }
    add_moments(solid);
    return solid;
}

double depth_in(const Solid& solid, const Vector3d& point) {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const Triangle& face : solid.faces)
        nearest2 = std::min(nearest2, closest_point(flat_triangle(face[0], face[1], face[2]), point).distance2);
    return encloses(solid, point) ? std::sqrt(nearest2) : -std::sqrt(nearest2);
}

Depths::Depths(const Solid& solid) : solid_(solid) {
    for (const Triangle& face : solid.faces)
        flats_.push_back(flat_triangle(face[0], face[1], face[2]));
    tree_ = TriangleTree(flats_);
    slack_ = 1e-12 * std::pow(size_of(solid.faces), 2);
}

double Depths::distance2(const Vector3d& point, double bound) const {
    return tree_.least(point, bound, slack_, [&](int triangle) {
        return closest_point(flats_[static_cast<std::size_t>(triangle)], point).distance2;
    });
}

bool Depths::inside(const Vector3d& point) const {
    return encloses(solid_, point);
}

double Depths::at(const Vector3d& point) const {
    const double distance = std::sqrt(distance2(point));
    return inside(point) ? distance : -distance;
}

std::vector<Vector3d> surface_points(const Solid& solid, int count) {
    // Along the summed area in even steps, across each triangle by the plane's golden sequence (Roberts 2018).
    constexpr double g = 1.32471795724474602596;
    std::vector<Vector3d> points;
    double before = 0;
    for (const Triangle& face : solid.faces) {
        const double after = before + (face[1] - face[0]).cross(face[2] - face[0]).norm() / 2;
        const auto first = static_cast<int>(std::ceil(before / solid.area * count - 0.5));
        for (int i = first; (i + 0.5) * solid.area < after * count && i < count; ++i) {
            double u = std::fmod(0.5 + i / g, 1.0), v = std::fmod(0.5 + i / (g * g), 1.0);
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            points.push_back(face[0] + u * (face[1] - face[0]) + v * (face[2] - face[0]));
        }
        before = after;
    }
    return points;
}

} // namespace tumble::fit
