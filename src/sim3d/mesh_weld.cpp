#include "sim3d/mesh_weld.h"

#include "scene/extent.h"
#include "sim3d/mesh_junctions.h"
#include "sim3d/mesh_topology.h"
#include "sim3d/wall_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <unordered_map>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

using Corners = std::array<Vector3d, 3>;

/// Gives near points one number: a grid of cells as wide as the tolerance, looked up with its neighbours.
class Welder {
public:
    explicit Welder(double tolerance) : tolerance_(tolerance) {}

    int weld(const Vector3d& point) {
        const std::array<std::int64_t, 3> cell = cell_of(point);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k) {
                    const auto found = cells_.find(key({cell[0] + i, cell[1] + j, cell[2] + k}));
                    if (found == cells_.end())
                        continue;
                    for (const int vertex : found->second)
                        if ((vertices[static_cast<std::size_t>(vertex)] - point).norm() < tolerance_)
                            return vertex;
                }
        const int vertex = static_cast<int>(vertices.size());
        vertices.push_back(point);
        cells_[key(cell)].push_back(vertex);
        return vertex;
    }

    std::vector<Vector3d> vertices;

private:
    [[nodiscard]] std::array<std::int64_t, 3> cell_of(const Vector3d& point) const {
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(std::floor(point[axis] / tolerance_));
        return cell;
    }
    /// Cells that share a key are told apart by the distance test.
    static std::uint64_t key(const std::array<std::int64_t, 3>& cell) {
        return static_cast<std::uint64_t>(cell[0]) * 73856093u ^ static_cast<std::uint64_t>(cell[1]) * 19349663u ^
               static_cast<std::uint64_t>(cell[2]) * 83492791u;
    }

    double tolerance_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

Problem problem_of(const scene::MeshShape& shape, std::string what, std::string fix) {
    Problem problem;
    problem.file = shape.file.string();
    problem.what = std::move(what);
    problem.fix = std::move(fix);
    return problem;
}

bool reaches(const Corners& corners, const scene::Domain& domain) {
    for (int axis = 0; axis < 3; ++axis) {
        const double half = (domain.box.hi[axis] - domain.box.lo[axis]) / 2;
        const double lo = std::min({corners[0][axis], corners[1][axis], corners[2][axis]});
        const double hi = std::max({corners[0][axis], corners[1][axis], corners[2][axis]});
        const bool periodic = domain.periodic[static_cast<std::size_t>(axis)];
        if (periodic && (hi < domain.box.lo[axis] - half || lo > domain.box.hi[axis] + half))
            return false;
    }
    return true;
}

/// Finds what is wrong with a triangle that has been welded; keeps the list short however broken the file is.
class Inspector {
public:
    explicit Inspector(const scene::MeshShape& shape) : shape_(shape) {}

    void no_area(std::size_t triangle) {
        report(triangle, "has no area", "export the mesh again without degenerate triangles");
    }
    void twice(std::size_t triangle, std::size_t first) {
        report(triangle, fmt::format("is the same as triangle {}", first + 1),
               "remove one of the two, or export the mesh again without doubled faces");
    }
    Problems finish() {
        if (found_ > most)
            problems_.push_back(
                problem_of(shape_, fmt::format("{} more broken triangles", found_ - most), "export the mesh again"));
        return std::move(problems_);
    }

private:
    void report(std::size_t triangle, const std::string& what, const std::string& fix) {
        if (++found_ <= most)
            problems_.push_back(problem_of(shape_, fmt::format("triangle {} {}", triangle + 1, what), fix));
    }

    static constexpr int most = 10;
    const scene::MeshShape& shape_;
    int found_ = 0;
    Problems problems_;
};

std::array<int, 3> sorted(std::array<int, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

} // namespace

namespace {

Result<WeldedMesh> weld(const scene::MeshShape& shape, const std::vector<MeshPiece>& pieces,
                        const scene::Domain& domain, const scene::Box& bounds, double tolerance) {
    Welder welder(tolerance);
    Inspector inspector(shape);
    WeldedMesh mesh;
    std::map<std::array<int, 3>, int> known;
    for (const Vector3d& shift : periodic_shifts(bounds, domain))
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Corners corners = pieces[i].corners;
            for (Vector3d& corner : corners)
                corner += shift;
            const bool copy = !shift.isZero(0);
            if (copy && !reaches(corners, domain))
                continue;
            if (!copy && without_area(corners, tolerance)) {
                inspector.no_area(pieces[i].triangle);
                continue;
            }
            const std::array<int, 3> welded{welder.weld(corners[0]), welder.weld(corners[1]), welder.weld(corners[2])};
            if (welded[0] == welded[1] || welded[1] == welded[2] || welded[2] == welded[0]) {
                if (!copy)
                    inspector.no_area(pieces[i].triangle);
                continue;
            }
            const auto [place, fresh] = known.emplace(sorted(welded), static_cast<int>(mesh.triangles.size()));
            if (fresh) {
                mesh.triangles.push_back(welded);
                mesh.original.push_back(static_cast<int>(i));
            } else if (copy) {
                mesh.coincident.push_back({place->second, static_cast<int>(i)});
            } else {
                const int first = mesh.original[static_cast<std::size_t>(place->second)];
                inspector.twice(pieces[i].triangle, pieces[static_cast<std::size_t>(first)].triangle);
            }
        }
    if (Problems problems = inspector.finish(); !problems.empty())
        return problems;
    mesh.vertices = std::move(welder.vertices);
    return mesh;
}

} // namespace

Result<WeldedMesh> weld_mesh(const scene::MeshShape& shape, const scene::Domain& domain) {
    if (shape.triangles.empty())
        return problem_of(shape, "there are no triangles in the mesh", "export the mesh again");
    std::vector<MeshPiece> pieces;
    for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
        for (const Vector3d& corner : shape.triangles[i])
            if (!corner.allFinite())
                return problem_of(shape, fmt::format("triangle {} has a coordinate that is not a number", i + 1),
                                  "export the mesh again");
        pieces.push_back({shape.triangles[i], i});
    }
    const scene::Box bounds = scene::extent_of(shape);
    const double tolerance = weld_share * (bounds.hi - bounds.lo).norm();
    Result<WeldedMesh> mesh = weld(shape, pieces, domain, bounds, tolerance);
    for (int side = 0; side < 3 && mesh.ok() && split_at_junctions(*mesh, tolerance, pieces); ++side)
        mesh = weld(shape, pieces, domain, bounds, tolerance);
    return mesh;
}

} // namespace tumble::sim3d
