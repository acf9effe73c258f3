#include "solid/locate.h"

#include <Eigen/LU>
#include <cmath>

namespace tumble::solid {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double skin = 1e-6; // of a brick, so that no point falls between two

/// Natural coordinates of the point by Newton's method, which takes one step in a parallelepiped; nothing where it
/// leaves the brick far behind.
std::optional<Vector3d> natural_of(const Corners& corners, const Vector3d& point) {
    Vector3d at = Vector3d::Zero();
    for (int round = 0; round < 30; ++round) {
        const Vector3d move = jacobian_at(corners, at).inverse() * (point - corners * shape_at(at));
        at += move;
        if (!(at.cwiseAbs().maxCoeff() < 10))
            return std::nullopt;
        if (move.cwiseAbs().maxCoeff() < 1e-13)
            break;
    }
    if (at.cwiseAbs().maxCoeff() > 1 + skin)
        return std::nullopt;
    return at;
}

} // namespace

Locator::Locator(const HexMesh& mesh) : mesh_(mesh) {
    for (int hex = 0; hex < static_cast<int>(mesh.hexes.size()); ++hex) {
        const Corners corners = mesh.corners_of(hex);
        Eigen::AlignedBox3d box(Vector3d(corners.rowwise().minCoeff()), Vector3d(corners.rowwise().maxCoeff()));
        const Vector3d margin = Vector3d::Constant(skin * box.diagonal().norm());
        box.extend(box.min() - margin).extend(box.max() + margin);
        boxes_.push_back(box);
        bounds_.extend(box);
    }
    if (boxes_.empty())
        return;
    const double cell = std::cbrt(bounds_.volume() / static_cast<double>(boxes_.size()));
    counts_ = (bounds_.diagonal() / cell).array().ceil().cast<int>().max(1);
    cells_.resize(static_cast<std::size_t>(counts_.prod()));
    for (int hex = 0; hex < static_cast<int>(boxes_.size()); ++hex) {
        const auto& box = boxes_[static_cast<std::size_t>(hex)];
        const Vector3i lo = cell_at(box.min()), hi = cell_at(box.max());
        for (int x = lo.x(); x <= hi.x(); ++x)
            for (int y = lo.y(); y <= hi.y(); ++y)
                for (int z = lo.z(); z <= hi.z(); ++z)
                    cells_[index_of({x, y, z})].push_back(hex);
    }
}

Vector3i Locator::cell_at(const Vector3d& point) const {
    const Vector3d share = (point - bounds_.min()).cwiseQuotient(bounds_.diagonal());
    return (share.array() * counts_.cast<double>().array()).floor().cast<int>().max(0).min(counts_.array() - 1);
}

std::size_t Locator::index_of(const Vector3i& cell) const {
    return static_cast<std::size_t>((cell.z() * counts_.y() + cell.y()) * counts_.x() + cell.x());
}

std::optional<Inside> Locator::find(const Vector3d& point) const {
    if (boxes_.empty() || !bounds_.contains(point))
        return std::nullopt;
    for (const int hex : cells_[index_of(cell_at(point))])
        if (boxes_[static_cast<std::size_t>(hex)].contains(point))
            if (const auto natural = natural_of(mesh_.corners_of(hex), point))
                return Inside{hex, shape_at(*natural)};
    return std::nullopt;
}

} // namespace tumble::solid
