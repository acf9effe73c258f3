#include "sim3d/mesh_junctions.h"

#include <algorithm>
#include <map>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

/// Ends of edges that only one triangle has, in the order of their places along x.
class LooseEnds {
public:
    explicit LooseEnds(const WeldedMesh& mesh) : mesh_(mesh) {
        for (const auto& corners : mesh.triangles)
            for (std::size_t side = 0; side < 3; ++side)
                ++uses_[edge(corners[side], corners[(side + 1) % 3])];
        for (const auto& [ends, uses] : uses_)
            if (uses == 1)
                ends_.insert(ends_.end(), ends.begin(), ends.end());
        std::sort(ends_.begin(), ends_.end(),
                  [&](int a, int b) { return std::pair(at(a).x(), a) < std::pair(at(b).x(), b); });
        ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    }

    [[nodiscard]] bool is_loose(int a, int b) const { return uses_.at(edge(a, b)) == 1; }

    /// Those within the edge, from a to b, none nearer to an end of it or to each other than vertices are to each
    /// other.
    [[nodiscard]] std::vector<Vector3d> within(int a, int b, double tolerance) const {
        const Vector3d from = at(a), way = at(b) - from;
        const double lo = std::min(from.x(), at(b).x()) - tolerance, hi = std::max(from.x(), at(b).x()) + tolerance;
        std::vector<std::pair<double, int>> found; // share of the way
        for (auto end =
                 std::lower_bound(ends_.begin(), ends_.end(), lo, [&](int v, double x) { return at(v).x() < x; });
             end != ends_.end() && at(*end).x() <= hi; ++end) {
            const double share = (at(*end) - from).dot(way) / way.squaredNorm();
            if (*end != a && *end != b && share > 0 && share < 1 && (from + share * way - at(*end)).norm() < tolerance)
                found.emplace_back(share, *end);
        }
        std::sort(found.begin(), found.end());
        std::vector<Vector3d> places;
        for (const auto& [share, vertex] : found)
            places.push_back(at(vertex));
        return places;
    }

private:
    static std::array<int, 2> edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
    [[nodiscard]] const Vector3d& at(int vertex) const { return mesh_.vertices[static_cast<std::size_t>(vertex)]; }

    const WeldedMesh& mesh_;
    std::map<std::array<int, 2>, int> uses_;
    std::vector<int> ends_;
};

/// The parts of a piece cut from places on one side, 0 ab, 1 bc, 2 ca, to the corner opposite; `places` go from the
/// side's first corner to its second.
std::vector<MeshPiece> parts_of(const MeshPiece& piece, std::size_t side, const std::vector<Vector3d>& places) {
    const Vector3d &last = piece.corners[(side + 1) % 3], &apex = piece.corners[(side + 2) % 3];
    std::vector<MeshPiece> parts;
    Vector3d from = piece.corners[side];
    for (const Vector3d& place : places) {
        parts.push_back({{from, place, apex}, piece.triangle});
        from = place;
    }
    parts.push_back({{from, last, apex}, piece.triangle});
    return parts;
}

} // namespace

bool without_area(const std::array<Vector3d, 3>& corners, double tolerance) {
    const Vector3d ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const double longest = std::max({ab.norm(), (ac - ab).norm(), ac.norm()});
    return ab.cross(ac).norm() <= tolerance * longest;
}

bool split_at_junctions(const WeldedMesh& mesh, double tolerance, std::vector<MeshPiece>& pieces) {
    const LooseEnds ends(mesh);
    std::map<std::size_t, std::vector<MeshPiece>> cut;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<int, 3>& corners = mesh.triangles[t];
        const auto whole = static_cast<std::size_t>(mesh.original[t]);
        // What a periodic copy meets is cut out of the original.
        const Vector3d shift = mesh.vertices[static_cast<std::size_t>(corners[0])] - pieces[whole].corners[0];
        for (std::size_t side = 0; side < 3 && cut.count(whole) == 0; ++side) {
            const int a = corners[side], b = corners[(side + 1) % 3];
            if (!ends.is_loose(a, b))
                continue;
            std::vector<Vector3d> places = ends.within(a, b, tolerance);
            for (Vector3d& place : places)
                place -= shift;
            std::vector<MeshPiece> parts = parts_of(pieces[whole], side, places);
            const bool sound = std::none_of(parts.begin(), parts.end(), [&](const MeshPiece& part) {
                return without_area(part.corners, tolerance);
            });
            if (parts.size() > 1 && sound)
                cut.emplace(whole, std::move(parts));
        }
    }
    std::vector<MeshPiece> all;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (const auto parts = cut.find(i); parts != cut.end())
            all.insert(all.end(), parts->second.begin(), parts->second.end());
        else
            all.push_back(pieces[i]);
    pieces = std::move(all);
    return !cut.empty();
}

} // namespace tumble::sim3d
