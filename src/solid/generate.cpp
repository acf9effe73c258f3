#include "solid/generate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::solid {

using Eigen::Vector3d;

namespace {

/// Turns y into the place's axis by the shortest way.
Eigen::Matrix3d frame_of(const Place& place) {
    return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), place.axis).toRotationMatrix();
}

Problem fault(const char* key, std::string what, std::string fix) {
    return {.key = key, .what = std::move(what), .fix = std::move(fix)};
}

void need_one(Problems& problems, const char* key, int count, int least) {
    if (count < least)
        problems.push_back(
            fault(key, fmt::format("{} hexahedra are too few", count), fmt::format("give at least {}", least)));
}

// Beyond, numbers of nodes and triangles come near what 32 bits hold, and no factorisation fits a machine long before.
constexpr std::int64_t most_hexahedra = 2'000'000;

void need_few(Problems& problems, const char* key, std::int64_t layer, std::int64_t along, const char* others) {
    if (problems.empty() && layer > most_hexahedra / along)
        problems.push_back(fault(key,
                                 fmt::format("{} layers of {} hexahedra are more than the {} that a part may have",
                                             along, layer, most_hexahedra),
                                 fmt::format("give fewer, or fewer {}", others)));
}

/// A box of cells i, j, k as a mesh; `wraps`: the last i is joined to the first.
class Grid {
public:
    Grid(int i, int j, int k, bool wraps) : i_(i), j_(j), k_(k), across_(wraps ? i : i + 1) {}

    [[nodiscard]] int node(int i, int j, int k) const { return (j * (k_ + 1) + k) * across_ + i % across_; }
    [[nodiscard]] int nodes() const { return across_ * (j_ + 1) * (k_ + 1); }

    /// Cells whose i, j, k directions are right-handed.
    [[nodiscard]] std::vector<std::array<int, 8>> cells() const {
        std::vector<std::array<int, 8>> cells;
        for (int j = 0; j < j_; ++j)
            for (int k = 0; k < k_; ++k)
                for (int i = 0; i < i_; ++i)
                    cells.push_back({node(i, j, k), node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j, k),
                                     node(i, j + 1, k), node(i, j + 1, k + 1), node(i + 1, j + 1, k + 1),
                                     node(i + 1, j + 1, k)});
        return cells;
    }

private:
    int i_, j_, k_, across_;
};

/// Ends by layers of nodes: j = 0 and j = last.
void name_ends(HexMesh& mesh, int nodes_per_layer) {
    const int count = static_cast<int>(mesh.nodes.size());
    for (int n = 0; n < nodes_per_layer; ++n)
        mesh.node_sets["base"].push_back(n);
    for (int n = count - nodes_per_layer; n < count; ++n)
        mesh.node_sets["top"].push_back(n);
}

template <class Name> void name_facets(HexMesh& mesh, Name name) {
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f)
        mesh.facet_sets[name(f)].push_back(f);
}

} // namespace

Result<HexMesh> mesh_of(const BoredCylinder& part, const Place& place) {
    Problems problems;
    if (!(part.bore_radius > 0) || !(part.bore_radius < part.radius))
        problems.push_back(fault("bore_radius_m",
                                 fmt::format("a bore of radius {:.6g} m leaves nothing of a cylinder of {:.6g} m",
                                             part.bore_radius, part.radius),
                                 "make it smaller than radius_m"));
    else if (!(part.shell > 0) || !(part.shell < part.radius - part.bore_radius))
        problems.push_back(fault("shell_m",
                                 fmt::format("a shell of {:.6g} m does not fit into a wall of {:.6g} m", part.shell,
                                             part.radius - part.bore_radius),
                                 "make it thinner than the wall between bore and outside"));
    need_one(problems, "around", part.around, 3);
    need_one(problems, "along", part.along, 1);
    need_one(problems, "shell_rings", part.shell_rings, 1);
    need_one(problems, "inner_rings", part.inner_rings, 1);
    need_few(problems, "along", std::int64_t{part.around} * (std::int64_t{part.inner_rings} + part.shell_rings),
             part.along, "around, shell_rings or inner_rings");
    if (!problems.empty())
        return problems;

    const int rings = part.inner_rings + part.shell_rings;
    const double inner = part.radius - part.bore_radius - part.shell;
    const auto radius_at = [&](int ring) { // exact at either end of the shell
        return ring <= part.inner_rings ? part.bore_radius + inner * ring / part.inner_rings
                                        : part.radius - part.shell * (rings - ring) / part.shell_rings;
    };
    const Grid grid(part.around, part.along, rings, true);
    const Eigen::Matrix3d frame = frame_of(place);
    HexMesh mesh;
    mesh.nodes.resize(static_cast<std::size_t>(grid.nodes()));
    for (int j = 0; j <= part.along; ++j)
        for (int k = 0; k <= rings; ++k)
            for (int i = 0; i < part.around; ++i) {
                const double angle = 2 * std::numbers::pi * i / part.around, radius = radius_at(k);
                mesh.nodes[static_cast<std::size_t>(grid.node(i, j, k))] =
                    place.base +
                    frame * Vector3d(radius * std::sin(angle), part.length * j / part.along, radius * std::cos(angle));
            }
    mesh.hexes = grid.cells();
    Result<HexMesh> whole = finished(std::move(mesh));
    if (!whole)
        return whole;
    name_ends(*whole, part.around * (rings + 1));
    name_facets(*whole, [&](int f) {
        const Vector3d normal = whole->area_of(f).normalized();
        const double along = normal.dot(place.axis);
        const Vector3d arm = whole->centre_of(f) - place.base;
        return along > 0.5                                              ? "top"
               : along < -0.5                                           ? "base"
               : normal.dot(arm - place.axis.dot(arm) * place.axis) > 0 ? "side"
                                                                        : "bore";
    });
    return whole;
}

Result<HexMesh> mesh_of(const Prism& part, const Place& place) {
    Problems problems;
    if (!(part.corner > 0) || !(2 * part.corner < part.side))
        problems.push_back(
            fault("corner_m",
                  fmt::format("corners of {:.6g} m leave no middle of a side of {:.6g} m", part.corner, part.side),
                  "make them shorter than half of side_m"));
    need_one(problems, "corner_cells", part.corner_cells, 1);
    need_one(problems, "middle_cells", part.middle_cells, 1);
    need_one(problems, "along", part.along, 1);
    const std::int64_t across = 2 * std::int64_t{part.corner_cells} + part.middle_cells;
    need_few(problems, "along", across * across, part.along, "corner_cells or middle_cells");
    if (!problems.empty())
        return problems;

    const int cells = 2 * part.corner_cells + part.middle_cells;
    const auto at = [&](int cell) { // from one edge of the side to the other, about its middle
        const double half = part.side / 2;
        if (cell <= part.corner_cells)
            return -half + part.corner * cell / part.corner_cells;
        if (cell >= cells - part.corner_cells)
            return half - part.corner * (cells - cell) / part.corner_cells;
        return -half + part.corner + (part.side - 2 * part.corner) * (cell - part.corner_cells) / part.middle_cells;
    };
    const Grid grid(cells, part.along, cells, false);
    const Eigen::Matrix3d frame = frame_of(place);
    HexMesh mesh;
    mesh.nodes.resize(static_cast<std::size_t>(grid.nodes()));
    for (int j = 0; j <= part.along; ++j)
        for (int k = 0; k <= cells; ++k)
            for (int i = 0; i <= cells; ++i)
                mesh.nodes[static_cast<std::size_t>(grid.node(i, j, k))] =
                    place.base + frame * Vector3d(at(i), part.length * j / part.along, at(k));
    mesh.hexes = grid.cells();
    Result<HexMesh> whole = finished(std::move(mesh));
    if (!whole)
        return whole;
    name_ends(*whole, (cells + 1) * (cells + 1));
    name_facets(*whole, [&](int f) {
        const Vector3d normal = frame.transpose() * whole->area_of(f).normalized();
        Eigen::Index axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const bool up = normal[axis] > 0;
        return axis == 1 ? (up ? "top" : "base") : axis == 0 ? (up ? "+x" : "-x") : (up ? "+z" : "-z");
    });
    return whole;
}

} // namespace tumble::solid
