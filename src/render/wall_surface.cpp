#include "render/wall_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tumble::render {

using Eigen::Vector3d;

const double smooth_cosine = std::cos(30 * EIGEN_PI / 180);

namespace {

struct Face {
    std::array<int, 3> corners{};         // of the welded points
    Vector3d normal = Vector3d::Zero();   // unit
    Vector3d weighted = Vector3d::Zero(); // normal times twice the area
    std::array<Vector3d, 3> points{};
};

} // namespace

static std::vector<int> weld(const std::vector<Vector3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : points) {
        box.extend(p);
    }
    const double cell = std::max(1e-7 * box.diagonal().norm(), 1e-12);
    std::map<std::array<long long, 3>, int> seen;
    std::vector<int> names;
    for (const Vector3d& p : points) {
        const Vector3d place = (p - box.min()) / cell;
        const std::array<long long, 3> key{std::llround(place.x()), std::llround(place.y()), std::llround(place.z())};
        names.push_back(seen.try_emplace(key, static_cast<int>(seen.size())).first->second);
    }
    return names;
}

static std::vector<Face> faces_of(const observe::FrameWall& wall) {
    const std::vector<int> names = weld(wall.vertices);
    std::vector<Face> faces;
    for (const auto& triangle : wall.triangles) {
        Face face;
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = triangle[k];
            if (v < 0 || static_cast<std::size_t>(v) >= wall.vertices.size()) {
                inside = false;
                break;
            }
            face.corners[k] = names[static_cast<std::size_t>(v)];
            face.points[k] = wall.vertices[static_cast<std::size_t>(v)];
        }
        face.weighted = (face.points[1] - face.points[0]).cross(face.points[2] - face.points[0]);
        const double area = face.weighted.norm();
        if (inside && area > 0 && std::isfinite(area)) {
            face.normal = face.weighted / area;
            faces.push_back(face);
        }
    }
    return faces;
}

/// Surfaces without an orientation: a neighbour that is wound the other way round counts as turned.
static double bend_cosine(const Vector3d& a, const Vector3d& b) {
    return std::abs(a.dot(b));
}

static void add_triangles(const std::vector<Face>& faces, WallSurface& surface) {
    std::map<int, std::vector<std::size_t>> around;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (const int corner : faces[f].corners) {
            around[corner].push_back(f);
        }
    }
    for (const Face& face : faces) {
        WallSurface::Triangle triangle{face.points, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            Vector3d sum = Vector3d::Zero();
            for (const std::size_t other : around[face.corners[k]]) {
                const Face& neighbour = faces[other];
                if (bend_cosine(face.normal, neighbour.normal) > smooth_cosine) {
                    sum += face.normal.dot(neighbour.normal) > 0 ? neighbour.weighted : Vector3d(-neighbour.weighted);
                }
            }
            triangle.normals[k] = sum.normalized();
        }
        surface.triangles.push_back(triangle);
    }
}

static void add_edges(const std::vector<Face>& faces, WallSurface& surface) {
    std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, std::size_t>>> sides;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = faces[f].corners[k];
            const int b = faces[f].corners[(k + 1) % 3];
            if (a != b) {
                sides[{std::min(a, b), std::max(a, b)}].emplace_back(f, k);
            }
        }
    }
    for (const auto& [ends, users] : sides) {
        const auto [f, k] = users.front();
        WallSurface::Edge edge;
        edge.ends = {faces[f].points[k], faces[f].points[(k + 1) % 3]};
        edge.normals = {faces[f].normal, faces[users.back().first].normal};
        edge.sharp = users.size() != 2 || bend_cosine(edge.normals[0], edge.normals[1]) < smooth_cosine;
        if (edge.normals[0].dot(edge.normals[1]) < 0 && !edge.sharp) {
            edge.normals[1] = -edge.normals[1];
        }
        surface.edges.push_back(edge);
    }
}

/// Where two lines meet whose ways differ by an angle, their outer sides meet beyond the end by tan(angle / 2) of half
/// the thickness; of bends sharper than a right one no more than half the thickness is drawn.
static double beyond_bend(const Vector3d& to_corner, const Vector3d& from_corner) {
    const double cosine = std::clamp(to_corner.dot(from_corner), -1.0, 1.0);
    return cosine > 0 ? std::sqrt((1 - cosine) / (1 + cosine)) : 1;
}

static void add_lines(const observe::FrameWall& wall, WallSurface& surface) {
    struct End {
        std::size_t line = 0;
        std::size_t side = 0;
    };
    const std::vector<int> names = weld(wall.vertices);
    std::map<int, std::vector<End>> corners;
    for (const std::array<int, 2>& line : wall.lines) {
        WallSurface::Edge edge;
        edge.normals = {Vector3d::Zero(), Vector3d::Zero()};
        edge.sharp = true;
        for (std::size_t side = 0; side < 2; ++side) {
            const auto v = static_cast<std::size_t>(line[side]);
            edge.ends[side] = wall.vertices[v];
            corners[names[v]].push_back({surface.edges.size(), side});
        }
        surface.edges.push_back(edge);
    }
    const auto towards = [&](const End& end) {
        const WallSurface::Edge& edge = surface.edges[end.line];
        return Vector3d((edge.ends[end.side] - edge.ends[1 - end.side]).normalized());
    };
    for (const auto& [corner, ends] : corners)
        if (ends.size() == 2)
            for (std::size_t k = 0; k < 2; ++k)
                surface.edges[ends[k].line].beyond[ends[k].side] = beyond_bend(towards(ends[k]), -towards(ends[1 - k]));
}

WallSurface make_wall_surface(const observe::FrameWall& wall) {
    const std::vector<Face> faces = faces_of(wall);
    WallSurface surface;
    add_triangles(faces, surface);
    add_edges(faces, surface);
    add_lines(wall, surface);
    return surface;
}

} // namespace tumble::render
