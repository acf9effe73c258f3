#include "stress/facet_loads.h"

#include "base/table.h"
#include "solid/facet_load.h"

namespace tumble::stress {

namespace {

constexpr double alike = 1e-9; // of cosines, and of a facet's diagonal

} // namespace

FacetFinder::FacetFinder(const solid::HexMesh& mesh) : mesh_(mesh), facets_of_node_(mesh.nodes.size()) {
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f) {
        normals_.push_back(mesh.area_of(f).normalized());
        for (const int node : mesh.facets[static_cast<std::size_t>(f)].corners)
            facets_of_node_[static_cast<std::size_t>(node)].push_back(f);
    }
}

int FacetFinder::facet_of(const observe::WallPush& push) const {
    int found = push.triangle / 2;
    double most = push.normal.dot(normals_[static_cast<std::size_t>(found)]);
    if (most > 1 - alike) // on its face
        return found;
    const auto& corners = mesh_.facets[static_cast<std::size_t>(found)].corners;
    const auto node = [&](int number) -> const Eigen::Vector3d& {
        return mesh_.nodes[static_cast<std::size_t>(number)];
    };
    const double near = alike * (node(corners[2]) - node(corners[0])).norm();
    for (const int corner : corners)
        for (const int facet : facets_of_node_[static_cast<std::size_t>(corner)]) {
            const double faces = push.normal.dot(normals_[static_cast<std::size_t>(facet)]);
            if (faces < most + alike)
                continue;
            const Eigen::Vector3d foot = solid::point_of(mesh_, facet, solid::shares_at(mesh_, facet, push.foot));
            if ((foot - push.foot).norm() > near)
                continue;
            most = faces;
            found = facet;
        }
    return found;
}

std::map<int, FacetLoad> facet_loads(const std::vector<observe::WallPush>& pushes, const FacetFinder& finder) {
    std::map<int, FacetLoad> facets;
    for (const observe::WallPush& push : pushes) {
        const int number = finder.facet_of(push);
        const Eigen::Vector3d normal = finder.mesh().area_of(number).normalized();
        const double pressing = -push.force.dot(normal);
        FacetLoad& facet = facets[number];
        facet.pressing += pressing;
        facet.shearing += push.force + pressing * normal;
    }
    return facets;
}

std::string facets_csv(const run::PartLoads& loads, const solid::HexMesh& mesh) {
    const FacetFinder finder(mesh);
    std::string text = "time_s,element,face,area_m2,normal_Pa,shear_Pa\n";
    for (const run::LoadInstant& instant : loads.instants)
        for (const auto& [facet, sum] : facet_loads(instant.pushes, finder)) {
            const solid::Facet& of = mesh.facets[static_cast<std::size_t>(facet)];
            const double area = mesh.area_of(facet).norm();
            text += csv_line(std::vector<double>{
                instant.time, static_cast<double>(mesh.hex_numbers[static_cast<std::size_t>(of.hex)]),
                static_cast<double>(of.face + 1), area, sum.pressing / area, sum.shearing.norm() / area});
        }
    return text;
}

} // namespace tumble::stress
