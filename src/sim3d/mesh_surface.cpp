#include "base/closest_point.h"
#include "base/triangle_tree.h"
#include "sim3d/mesh_topology.h"
#include "sim3d/wall_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory_resource>

namespace tumble::sim3d {

using Eigen::Vector3d;

namespace {

/// A triangle that the sphere overlaps, and where it is nearest.
struct Hit {
    Vector3d away;        // m, from the closest point to the centre
    double distance2 = 0; // m2
    int triangle = 0;
    Region region = face;
    MeshFeature feature;
    bool counts = true;
};

/// Squared distances nearer than this share are equal: the same point, found from two triangles.
constexpr double same = 1e-9;

class Mesh final : public SurfaceParts {
public:
    explicit Mesh(MeshTopology topology)
        : corners_(std::move(topology.triangles)), features_(std::move(topology.features)) {
        for (const auto& [a, b, c] : corners_)
            flats_.push_back(flat_triangle(topology.vertices[static_cast<std::size_t>(a)],
                                           topology.vertices[static_cast<std::size_t>(b)],
                                           topology.vertices[static_cast<std::size_t>(c)]));
        tree_ = TriangleTree(flats_);
    }

    [[nodiscard]] int primitives() const override { return static_cast<int>(flats_.size()); }

    void primitives_near(const Vector3d& centre, double reach, std::vector<int>& out) const override {
        out.clear();
        tree_.near(centre, reach, [&](int triangle) {
            if (distance(triangle, centre) < reach)
                out.push_back(triangle);
        });
        std::sort(out.begin(), out.end());
    }

    [[nodiscard]] double distance(int primitive, const Vector3d& point) const override {
        return std::sqrt(closest_point(flats_[static_cast<std::size_t>(primitive)], point).distance2);
    }

    int touches(const Vector3d& centre, double radius, std::span<const int> primitives,
                std::span<WallTouch> out) const override {
        // A sphere usually overlaps a handful of triangles; only a mesh much finer than the sphere needs the heap.
        std::array<std::byte, 64 * sizeof(Hit)> room;
        std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
        std::pmr::vector<Hit> hits(&memory);
        hits.reserve(std::min<std::size_t>(primitives.size(), 60));
        for (const int triangle : primitives)
            overlap(centre, radius, triangle, hits);

        TouchList list(out);
        if (hits.size() > 1)
            choose(hits);
        for (const Hit& hit : hits)
            if (hit.counts)
                list.add(touch(hit, radius));
        return list.count();
    }

private:
    template <class Hits> void overlap(const Vector3d& centre, double radius, int triangle, Hits& hits) const {
        const auto t = static_cast<std::size_t>(triangle);
        if (std::abs((centre - flats_[t].a).dot(flats_[t].normal)) >= radius)
            return;
        const ClosestPoint closest = closest_point(flats_[t], centre);
        if (closest.distance2 < radius * radius)
            hits.push_back({closest.away, closest.distance2, triangle, closest.region,
                            features_[t][static_cast<std::size_t>(closest.region)], true});
    }

    /// Leaves those hits that are touches of their own: places where the wall is nearer than all around; one per
    /// patch; no edge beside a touching patch, no corner beside a touching patch or edge.
    template <class Hits> void choose(Hits& hits) const {
        for (Hit& hit : hits)
            for (const Hit& other : hits)
                if (hit.region != face && other.distance2 < hit.distance2 * (1 - same) && shares_part(hit, other))
                    hit.counts = false;
        for (Hit& hit : hits)
            for (const Hit& other : hits)
                if (hit.counts && other.counts && &hit != &other && hit.feature.id == other.feature.id &&
                    before(other, hit))
                    hit.counts = false;
        for (const FeatureKind kind : {FeatureKind::edge, FeatureKind::corner})
            for (Hit& hit : hits)
                if (hit.counts && hit.feature.kind == kind && beside_lower_kind(hit, hits))
                    hit.counts = false;
    }

    /// Of two hits on one feature: the nearer; at the same distance a face before an edge before a corner, because its
    /// foot is the more exact; else the first.
    static bool before(const Hit& a, const Hit& b) {
        if (std::abs(a.distance2 - b.distance2) > same * b.distance2)
            return a.distance2 < b.distance2;
        const auto rank = [](const Hit& hit) { return hit.region == face ? 0 : hit.region < corner_a ? 1 : 2; };
        return rank(a) != rank(b) ? rank(a) < rank(b) : a.triangle < b.triangle;
    }

    /// The edge or corner at which `hit` is nearest also belongs to the other's triangle.
    [[nodiscard]] bool shares_part(const Hit& hit, const Hit& other) const {
        const auto& own = corners_[static_cast<std::size_t>(hit.triangle)];
        if (hit.region >= corner_a)
            return has(other, own[static_cast<std::size_t>(hit.region - corner_a)]);
        const auto side = static_cast<std::size_t>(hit.region - edge_ab);
        return has(other, own[side]) && has(other, own[(side + 1) % 3]);
    }

    [[nodiscard]] bool has(const Hit& hit, int vertex) const {
        const auto& corners = corners_[static_cast<std::size_t>(hit.triangle)];
        return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
    }

    template <class Hits> bool beside_lower_kind(const Hit& hit, const Hits& hits) const {
        for (const Hit& beside : hits) {
            if (!shares_part(hit, beside))
                continue;
            const int patch = features_[static_cast<std::size_t>(beside.triangle)][face].id;
            for (const Hit& other : hits) {
                const bool same_patch = other.feature.kind == FeatureKind::patch && other.feature.id == patch;
                const bool same_edge = hit.feature.kind == FeatureKind::corner && &other == &beside &&
                                       other.feature.kind == FeatureKind::edge;
                if (other.counts && (same_patch || same_edge))
                    return true;
            }
        }
        return false;
    }

    [[nodiscard]] WallTouch touch(const Hit& hit, double radius) const {
        // On a patch, edges between its triangles included, the triangle's normal is exact however near the centre is.
        const Vector3d& normal = flats_[static_cast<std::size_t>(hit.triangle)].normal;
        if (hit.feature.kind == FeatureKind::patch || hit.distance2 == 0) {
            const double height = hit.away.dot(normal);
            return {height < 0 ? Vector3d(-normal) : normal, std::abs(height) - radius, hit.feature.id, hit.triangle};
        }
        const double far = std::sqrt(hit.distance2);
        return {hit.away / far, far - radius, hit.feature.id, hit.triangle};
    }

    std::vector<std::array<int, 3>> corners_; // vertices of each triangle
    std::vector<std::array<MeshFeature, 7>> features_;
    std::vector<FlatTriangle> flats_;
    TriangleTree tree_;
};

} // namespace

Result<SurfacePartsPtr> mesh_parts(const scene::MeshShape& shape, const scene::Domain& domain) {
    Result<MeshTopology> topology = mesh_topology(shape, domain);
    if (!topology.ok())
        return topology.problems();
    return SurfacePartsPtr(std::make_shared<Mesh>(std::move(*topology)));
}

} // namespace tumble::sim3d
