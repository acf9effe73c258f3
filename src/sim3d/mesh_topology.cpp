#include "sim3d/mesh_topology.h"

#include "base/closest_point.h"
#include "sim3d/mesh_weld.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

/// Which numbers are one: union-find, the smallest number stands for its set.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int i) {
        while (at(i) != i)
            i = at(i) = at(at(i));
        return i;
    }
    void join(int a, int b) {
        a = find(a);
        b = find(b);
        at(std::max(a, b)) = std::min(a, b);
    }

private:
    int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
    std::vector<int> parent_;
};

struct EdgeUse {
    int triangle = 0;
    int side = 0;   // 0 ab, 1 bc, 2 ca
    Vector3d inner; // unit, in the triangle's plane, across the edge into the triangle
    bool in_patch = false;
};

struct Edge {
    int first = 0, second = 0; // vertices, ascending
    std::vector<EdgeUse> uses;
    /// Some triangle ends here or bends away: the sphere can feel it.
    [[nodiscard]] bool active() const {
        return std::any_of(uses.begin(), uses.end(), [](const EdgeUse& use) { return !use.in_patch; });
    }
};

class Builder {
public:
    explicit Builder(const WeldedMesh& mesh)
        : mesh_(mesh), edge_of_(mesh.triangles.size()), patches_(mesh.triangles.size()),
          corners_(mesh.vertices.size()) {}

    MeshTopology build() {
        collect_edges();
        join_patches();
        Sets straight(edges_.size());
        straight_ = std::move(straight);
        join_straight_edges();
        join_copies();
        return number();
    }

private:
    [[nodiscard]] const Vector3d& vertex(int i) const { return mesh_.vertices[static_cast<std::size_t>(i)]; }
    Edge& edge(int i) { return edges_[static_cast<std::size_t>(i)]; }

    void collect_edges() {
        std::map<std::array<int, 2>, int> known;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            for (std::size_t side = 0; side < 3; ++side) {
                const int a = mesh_.triangles[t][side], b = mesh_.triangles[t][(side + 1) % 3];
                const int c = mesh_.triangles[t][(side + 2) % 3];
                const auto [place, fresh] =
                    known.emplace(std::array<int, 2>{std::min(a, b), std::max(a, b)}, static_cast<int>(edges_.size()));
                if (fresh)
                    edges_.push_back({std::min(a, b), std::max(a, b), {}});
                const Vector3d way = (vertex(b) - vertex(a)).normalized(), to_c = vertex(c) - vertex(a);
                EdgeUse use;
                use.triangle = static_cast<int>(t);
                use.side = static_cast<int>(side);
                use.inner = (to_c - to_c.dot(way) * way).normalized();
                edge(place->second).uses.push_back(use);
                edge_of_[t][side] = place->second;
            }
    }

    /// Two triangles on opposite sides of an edge and in one plane belong together, also where a third stands on it.
    void join_patches() {
        for (Edge& edge : edges_)
            for (std::size_t i = 0; i < edge.uses.size(); ++i)
                for (std::size_t j = i + 1; j < edge.uses.size(); ++j)
                    if ((edge.uses[i].inner + edge.uses[j].inner).norm() < flat_angle) {
                        patches_.join(edge.uses[i].triangle, edge.uses[j].triangle);
                        edge.uses[i].in_patch = edge.uses[j].in_patch = true;
                    }
    }

    std::vector<int> patches_at(const Edge& edge) {
        std::vector<int> patches;
        for (const EdgeUse& use : edge.uses)
            patches.push_back(patches_.find(use.triangle));
        std::sort(patches.begin(), patches.end());
        return patches;
    }

    /// A corner where one straight edge goes on between the same patches is no corner.
    void join_straight_edges() {
        std::vector<std::vector<int>> active_at(mesh_.vertices.size());
        for (std::size_t e = 0; e < edges_.size(); ++e)
            if (edges_[e].active())
                for (const int end : {edges_[e].first, edges_[e].second})
                    active_at[static_cast<std::size_t>(end)].push_back(static_cast<int>(e));
        through_.assign(mesh_.vertices.size(), none);
        for (std::size_t v = 0; v < active_at.size(); ++v) {
            if (active_at[v].empty())
                through_[v] = flat;
            if (active_at[v].size() != 2)
                continue;
            const Edge &one = edge(active_at[v][0]), &two = edge(active_at[v][1]);
            const auto away = [&](const Edge& e) {
                const int other = e.first == static_cast<int>(v) ? e.second : e.first;
                return (vertex(other) - mesh_.vertices[v]).normalized();
            };
            if ((away(one) + away(two)).norm() < flat_angle && patches_at(one) == patches_at(two)) {
                straight_.join(active_at[v][0], active_at[v][1]);
                through_[v] = active_at[v][0];
            }
        }
    }

    /// A periodic copy counts as its original, part by part.
    void join_copies() {
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            join_parts(static_cast<int>(t), mesh_.original[t]);
        for (const auto& [kept, original] : mesh_.coincident)
            patches_.join(kept, original);
    }

    void join_parts(int copy, int original) {
        if (copy == original)
            return;
        const auto c = static_cast<std::size_t>(copy), o = static_cast<std::size_t>(original);
        patches_.join(copy, original);
        for (std::size_t k = 0; k < 3; ++k) {
            straight_.join(edge_of_[c][k], edge_of_[o][k]);
            corners_.join(mesh_.triangles[c][k], mesh_.triangles[o][k]);
        }
    }

    MeshTopology number() {
        MeshTopology result;
        result.vertices = mesh_.vertices;
        result.triangles = mesh_.triangles;
        result.features.resize(mesh_.triangles.size());
        const int edges_from = static_cast<int>(mesh_.triangles.size());
        const int corners_from = edges_from + static_cast<int>(edges_.size());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const MeshFeature patch{patches_.find(static_cast<int>(t)), FeatureKind::patch};
            result.features[t].fill(patch);
            for (std::size_t side = 0; side < 3; ++side) {
                const int e = edge_of_[t][side], v = mesh_.triangles[t][side];
                for (const EdgeUse& use : edge(e).uses)
                    if (use.triangle == static_cast<int>(t) && !use.in_patch)
                        result.features[t][edge_ab + side] = {edges_from + straight_.find(e), FeatureKind::edge};
                const int through = through_[static_cast<std::size_t>(v)];
                if (through == none)
                    result.features[t][corner_a + side] = {corners_from + corners_.find(v), FeatureKind::corner};
                else if (through != flat)
                    result.features[t][corner_a + side] = {edges_from + straight_.find(through), FeatureKind::edge};
            }
        }
        return result;
    }

    static constexpr int none = -1, flat = -2;
    const WeldedMesh& mesh_;
    std::vector<Edge> edges_;
    std::vector<std::array<int, 3>> edge_of_; // per triangle
    std::vector<int> through_;                // per vertex: the straight edge that passes it, none, or flat
    Sets patches_, corners_, straight_{0};
};

} // namespace

Result<MeshTopology> mesh_topology(const scene::MeshShape& shape, const scene::Domain& domain) {
    const Result<WeldedMesh> mesh = weld_mesh(shape, domain);
    if (!mesh.ok())
        return mesh.problems();
    return Builder(*mesh).build();
}

} // namespace tumble::sim3d
