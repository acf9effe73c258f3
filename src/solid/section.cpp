#include "solid/section.h"

#include <algorithm>
#include <map>

namespace tumble::solid {

namespace {

constexpr std::array<std::array<int, 4>, 6> tetrahedra{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
/// Those faces of the tetrahedra that are halves of the hexahedron's own.
constexpr std::array<std::array<int, 3>, 12> halves{{{0, 1, 2},
                                                     {0, 2, 3},
                                                     {2, 3, 6},
                                                     {3, 7, 6},
                                                     {0, 3, 7},
                                                     {0, 7, 4},
                                                     {7, 4, 6},
                                                     {4, 5, 6},
                                                     {0, 4, 5},
                                                     {0, 5, 1},
                                                     {5, 1, 6},
                                                     {1, 2, 6}}};

class Cutter {
public:
    Cutter(const HexMesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
        for (const Eigen::Vector3d& node : mesh.nodes)
            height_.push_back(normal.dot(node - point));
    }

    void cut(const std::array<int, 8>& hex) {
        const auto above = [&](int node) { return height(node) >= 0; };
        if (std::all_of(hex.begin(), hex.end(), above) || std::none_of(hex.begin(), hex.end(), above))
            return;
        for (const auto& corners : tetrahedra)
            cut_tetrahedron(hex, corners);
        for (const auto& half : halves)
            cut_face(hex, half);
    }

    Section section;

private:
    [[nodiscard]] double height(int node) const { return height_[static_cast<std::size_t>(node)]; }

    /// Where the line between a node above and one below meets the plane; one point however often it is asked for.
    int crossing(int a, int b) {
        const std::pair key = std::minmax(a, b);
        const auto [found, fresh] = made_.try_emplace(key, static_cast<int>(section.points.size()));
        if (fresh)
            section.points.push_back(
                {key.first, key.second, height(key.first) / (height(key.first) - height(key.second))});
        return found->second;
    }

    void cut_tetrahedron(const std::array<int, 8>& hex, const std::array<int, 4>& corners) {
        std::vector<int> up, down;
        for (const int corner : corners) {
            const int node = hex[static_cast<std::size_t>(corner)];
            (height(node) >= 0 ? up : down).push_back(node);
        }
        if (up.empty() || down.empty())
            return;
        if (up.size() == 2) {
            const std::array round{crossing(up[0], down[0]), crossing(up[0], down[1]), crossing(up[1], down[1]),
                                   crossing(up[1], down[0])};
            section.triangles.push_back({round[0], round[1], round[2]});
            section.triangles.push_back({round[0], round[2], round[3]});
            return;
        }
        const std::vector<int>& one = up.size() == 1 ? up : down;
        const std::vector<int>& three = up.size() == 1 ? down : up;
        section.triangles.push_back(
            {crossing(one[0], three[0]), crossing(one[0], three[1]), crossing(one[0], three[2])});
    }

    void cut_face(const std::array<int, 8>& hex, const std::array<int, 3>& corners) {
        std::vector<int> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = hex[static_cast<std::size_t>(corners[k])];
            const int b = hex[static_cast<std::size_t>(corners[(k + 1) % 3])];
            if ((height(a) >= 0) != (height(b) >= 0))
                ends.push_back(crossing(a, b));
        }
        if (ends.size() == 2)
            section.lines.push_back({ends[0], ends[1]});
    }

    std::vector<double> height_; // m, of each node above the plane
    std::map<std::pair<int, int>, int> made_;
};

} // namespace

Section section_of(const HexMesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    Cutter cutter(mesh, point, normal);
    for (const auto& hex : mesh.hexes)
        cutter.cut(hex);
    return std::move(cutter.section);
}

} // namespace tumble::solid
