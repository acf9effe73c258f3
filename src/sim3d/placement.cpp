#include "sim3d/placement.h"

namespace tumble::sim3d {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Gaps are measured this many sphere skins far: a body that is not that near is left alone the longer.
constexpr double far_skins = 6;

const ShapeConstants& constants(const World& world, const Placement& body) {
    return world.shape_constants[static_cast<std::size_t>(body.shape)];
}

void put_bounding(double* to, const Vector3d& centre, double radius) {
    Eigen::Map<Vector3d>{to} = centre;
    to[3] = radius;
}

} // namespace

Placement placement_of(const World& world, int slot) {
    const auto at = static_cast<std::size_t>(slot);
    return {world.shape[at], Vector3d(world.motion[at].position), Eigen::Map<const RowMajor>(world.turn[at].rotation)};
}

Vector3d bounding_centre(const World& world, const Placement& body) {
    return body.position + body.rotation * Vector3d(constants(world, body).bounding_centre);
}

SphereScan scan_between(const World& world, const Placement& a, const Placement& b, const Vector3d& shift) {
    const ShapeConstants& shape_a = constants(world, a);
    const ShapeConstants& shape_b = constants(world, b);
    const Matrix3d b_to_a = a.rotation.transpose() * b.rotation;
    const Vector3d offset = a.rotation.transpose() * (b.position + shift - a.position);
    SphereScan scan{};
    scan.exposed_a = shape_a.exposed;
    scan.count_a = shape_a.exposed_count;
    scan.exposed_b = shape_b.exposed;
    scan.count_b = shape_b.exposed_count;
    Eigen::Map<RowMajor>{scan.rotation} = b_to_a;
    Eigen::Map<Vector3d>{scan.offset} = offset;
    put_bounding(scan.bounding_a, Vector3d(shape_a.bounding_centre), shape_a.bounding_radius);
    put_bounding(scan.bounding_b, b_to_a * Vector3d(shape_b.bounding_centre) + offset, shape_b.bounding_radius);
    scan.skin = world.sphere_skin;
    scan.far_skin = far_skins * world.sphere_skin;
    return scan;
}

int run_scan(const World& world, SphereScan& scan, double& smallest_gap, const std::uint32_t*& found) {
    thread_local Lines<double> lanes;
    thread_local std::vector<std::uint32_t> pairs(64);
    lanes.resize(5 * (static_cast<std::size_t>(scan.count_a) + 8));
    scan.scratch = lanes.data();
    for (;;) {
        const int room = static_cast<int>(pairs.size());
        const int count = world.kernels->scan_spheres(scan, pairs.data(), room, &smallest_gap);
        found = pairs.data();
        if (count <= room)
            return count;
        pairs.resize(static_cast<std::size_t>(count) * 2);
    }
}

bool overlap(const World& world, const Placement& a, const Placement& b, const Vector3d& shift) {
    SphereScan scan = scan_between(world, a, b, shift);
    scan.skin = 0;
    double smallest_gap = 0;
    const std::uint32_t* found = nullptr;
    return run_scan(world, scan, smallest_gap, found) > 0;
}

const WallState* wall_met(const World& world, const Placement& body) {
    const ShapeConstants& shape = constants(world, body);
    std::vector<int> primitives;
    for (const WallState& wall : world.walls) {
        const Matrix3d to_wall = wall.pose.rotation.transpose();
        wall.surface.primitives_near(to_wall * (bounding_centre(world, body) - wall.pose.translation),
                                     shape.bounding_radius, primitives);
        for (int s = 0; s < shape.exposed_count; ++s) {
            const double* sphere = shape.exposed + 4 * static_cast<std::ptrdiff_t>(s);
            const Vector3d centre = body.position + body.rotation * Vector3d(sphere[0], sphere[1], sphere[2]);
            const Vector3d local = to_wall * (centre - wall.pose.translation);
            for (const int primitive : primitives)
                if (wall.surface.distance(primitive, local) < sphere[3])
                    return &wall;
        }
    }
    return nullptr;
}

} // namespace tumble::sim3d
