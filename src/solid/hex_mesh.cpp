#include "solid/hex_mesh.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tumble::solid {

using Eigen::Vector3d;

namespace {

constexpr std::size_t most_named = 20; // problems of one kind; more would say the same

class Finisher {
public:
    explicit Finisher(HexMesh mesh) : mesh_(std::move(mesh)) {}

    Result<HexMesh> finish() {
        number(mesh_.node_numbers, mesh_.nodes.size());
        number(mesh_.hex_numbers, mesh_.hexes.size());
        if (mesh_.hexes.empty())
            say("the mesh has no hexahedra", "a part needs at least one C3D8 element");
        check_nodes();
        check_shapes();
        find_facets();
        if (problems_.empty())
            check_whole();
        if (!problems_.empty())
            return problems_;
        return std::move(mesh_);
    }

private:
    static void number(std::vector<int>& numbers, std::size_t count) {
        if (!numbers.empty() || count == 0)
            return;
        numbers.resize(count);
        std::iota(numbers.begin(), numbers.end(), 1);
    }

    void say(std::string what, std::string fix) {
        problems_.push_back({.file = mesh_.file, .what = std::move(what), .fix = std::move(fix)});
    }

    void check_nodes() {
        std::vector<bool> used(mesh_.nodes.size());
        for (const auto& hex : mesh_.hexes)
            for (const int node : hex)
                used[static_cast<std::size_t>(node)] = true;
        std::string loose;
        std::size_t count = 0;
        for (std::size_t n = 0; n < used.size(); ++n) {
            if (!mesh_.nodes[n].allFinite())
                say(fmt::format("node {} has a coordinate that is not finite", mesh_.node_numbers[n]),
                    "correct the node");
            if (!used[n] && ++count <= most_named)
                loose += fmt::format("{}{}", loose.empty() ? "" : ", ", mesh_.node_numbers[n]);
        }
        if (count > 0 && !mesh_.hexes.empty())
            say(fmt::format("{} to no hexahedron: {}{}",
                            count == 1 ? "1 node belongs" : fmt::format("{} nodes belong", count), loose,
                            count > most_named ? ", ..." : ""),
                "leave them out, or connect them");
    }

    void check_shapes() {
        std::size_t bad = 0;
        for (std::size_t e = 0; e < mesh_.hexes.size() && bad < most_named; ++e) {
            auto corners = mesh_.hexes[e];
            std::sort(corners.begin(), corners.end());
            if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
                say(fmt::format("element {} has a node twice", mesh_.hex_numbers[e]), "give it eight different nodes");
                ++bad;
                continue;
            }
            double least = 1;
            bool sound = true;
            for (int point = 0; point < 8; ++point) {
                const double here =
                    jacobian_at(mesh_.corners_of(static_cast<int>(e)), gauss_point(point)).determinant();
                sound = sound && here > 0 && std::isfinite(here);
                if (!std::isfinite(here) || here < least) // std::min would pass over NaN
                    least = here;
                if (!std::isfinite(here))
                    break;
            }
            if (!sound) {
                say(fmt::format("element {} is inside out or folded: its Jacobian determinant is {:.4g} m3 at an "
                                "integration point",
                                mesh_.hex_numbers[e], least),
                    "list the four nodes of the lower face counter-clockwise seen from the upper one, or mend the "
                    "mesh");
                ++bad;
            }
        }
    }

    /// One body without cracks: each hexahedron hangs by its faces on all others, and no two nodes lie in one place.
    void check_whole() {
        std::string pairs;
        std::size_t count = 0;
        for (const auto& [a, b] : coincident())
            if (++count <= most_named)
                pairs += fmt::format("{}{} and {}", pairs.empty() ? "" : ", ",
                                     mesh_.node_numbers[static_cast<std::size_t>(a)],
                                     mesh_.node_numbers[static_cast<std::size_t>(b)]);
        if (count > 0)
            say(fmt::format("nodes lie in the same place, where the part is cracked: {}{}", pairs,
                            count > most_named ? ", ..." : ""),
                "make one node of each pair (gmsh: Coherence Mesh), or leave one body out");
        for (std::size_t e = 1; e < mesh_.hexes.size() && count == 0; ++e)
            if (body_of(static_cast<int>(e)) != body_of(0))
                return say(fmt::format("the part is in pieces: element {} hangs by no face on element {}",
                                       mesh_.hex_numbers[e], mesh_.hex_numbers[0]),
                           "join the bodies face to face, or leave all but one out");
    }

    /// Pairs of nodes nearer than 1e-9 of the mesh's size, as their order along a line that no mesh is likely to have.
    [[nodiscard]] std::vector<std::pair<int, int>> coincident() const {
        const Vector3d line = Vector3d(0.53, 0.31, 0.79).normalized();
        Eigen::AlignedBox3d box;
        std::vector<std::pair<double, int>> order;
        for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
            box.extend(mesh_.nodes[n]);
            order.emplace_back(line.dot(mesh_.nodes[n]), static_cast<int>(n));
        }
        std::sort(order.begin(), order.end());
        const double near = 1e-9 * box.sizes().norm();
        std::vector<std::pair<int, int>> pairs;
        for (std::size_t k = 0; k < order.size(); ++k)
            for (std::size_t other = k + 1; other < order.size() && order[other].first - order[k].first <= near;
                 ++other) {
                const auto [a, b] = std::minmax(order[k].second, order[other].second);
                if ((mesh_.nodes[static_cast<std::size_t>(a)] - mesh_.nodes[static_cast<std::size_t>(b)]).norm() <=
                    near)
                    pairs.emplace_back(a, b);
            }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    /// The hexahedron that stands for all that hang on this one by faces.
    int body_of(int hex) {
        while (bodies_[static_cast<std::size_t>(hex)] != hex) {
            int& up = bodies_[static_cast<std::size_t>(hex)];
            up = bodies_[static_cast<std::size_t>(up)];
            hex = up;
        }
        return hex;
    }

    void find_facets() {
        bodies_.resize(mesh_.hexes.size());
        std::iota(bodies_.begin(), bodies_.end(), 0);
        struct Use {
            int hex = 0, face = 0, times = 0;
        };
        std::map<std::array<int, 4>, Use> uses;
        for (std::size_t e = 0; e < mesh_.hexes.size(); ++e)
            for (std::size_t face = 0; face < 6; ++face) {
                std::array<int, 4> key = corners_of_face(e, face);
                std::sort(key.begin(), key.end());
                Use& use = uses[key];
                if (use.times++ == 0)
                    use = {static_cast<int>(e), static_cast<int>(face), 1};
                else
                    bodies_[static_cast<std::size_t>(body_of(static_cast<int>(e)))] = body_of(use.hex);
                if (use.times == 3)
                    say(fmt::format("more than two hexahedra share a face of element {}", mesh_.hex_numbers[e]),
                        "two hexahedra lie in the same place");
            }
        std::vector<Use> alone;
        for (const auto& [key, use] : uses)
            if (use.times == 1)
                alone.push_back(use);
        std::sort(alone.begin(), alone.end(),
                  [](const Use& a, const Use& b) { return a.hex != b.hex ? a.hex < b.hex : a.face < b.face; });
        mesh_.facets.clear();
        for (const Use& use : alone)
            mesh_.facets.push_back(
                {corners_of_face(static_cast<std::size_t>(use.hex), static_cast<std::size_t>(use.face)), use.hex,
                 use.face});
    }

    [[nodiscard]] std::array<int, 4> corners_of_face(std::size_t hex, std::size_t face) const {
        std::array<int, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k)
            corners[k] = mesh_.hexes[hex][static_cast<std::size_t>(face_corners[face][k])];
        return corners;
    }

    HexMesh mesh_;
    std::vector<int> bodies_; // per hexahedron: one that it hangs on, or itself
    Problems problems_;
};

} // namespace

Corners HexMesh::corners_of(int hex) const {
    Corners corners;
    for (int k = 0; k < 8; ++k)
        corners.col(k) =
            nodes[static_cast<std::size_t>(hexes[static_cast<std::size_t>(hex)][static_cast<std::size_t>(k)])];
    return corners;
}

Vector3d HexMesh::area_of(int facet) const {
    const auto& [a, b, c, d] = facets[static_cast<std::size_t>(facet)].corners;
    const auto at = [&](int node) -> const Vector3d& { return nodes[static_cast<std::size_t>(node)]; };
    return 0.5 * (at(c) - at(a)).cross(at(d) - at(b));
}

Vector3d HexMesh::centre_of(int facet) const {
    Vector3d sum = Vector3d::Zero();
    for (const int node : facets[static_cast<std::size_t>(facet)].corners)
        sum += nodes[static_cast<std::size_t>(node)];
    return 0.25 * sum;
}

Result<HexMesh> finished(HexMesh mesh) {
    return Finisher(std::move(mesh)).finish();
}

std::vector<std::array<Vector3d, 3>> triangles_of(const HexMesh& mesh) {
    std::vector<std::array<Vector3d, 3>> triangles;
    triangles.reserve(2 * mesh.facets.size());
    for (const Facet& facet : mesh.facets) {
        const auto at = [&](std::size_t k) -> const Vector3d& {
            return mesh.nodes[static_cast<std::size_t>(facet.corners[k])];
        };
        triangles.push_back({at(0), at(1), at(2)});
        triangles.push_back({at(0), at(2), at(3)});
    }
    return triangles;
}

double volume_of(const HexMesh& mesh) {
    double volume = 0;
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        for (int point = 0; point < 8; ++point)
            volume += jacobian_at(mesh.corners_of(static_cast<int>(e)), gauss_point(point)).determinant();
    return volume;
}

} // namespace tumble::solid
