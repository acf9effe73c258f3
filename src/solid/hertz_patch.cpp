#include "solid/hertz_patch.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace tumble::solid {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr int fewest_rings = 5, most_rings = 24;
// Along a facet's shorter side: so many samples of its linear shape functions miss their integral by 1 / (3 pi)^2, 1 %.
constexpr double points_a_facet = 3;
// Times the radius: what is further above or below is another place of the part, for 60 degrees rise by 1.73 in 1.
constexpr double steepest = 2;
constexpr double rounding = 1e-12; // of the radius, or of half a facet's side
constexpr int most_turns = 8;
constexpr double nearly_middle = 1.0 / 64; // of the radius
constexpr double no_width = 1e-6;          // of the radius, of a patch too narrow to lean across it

/// A point of the unit circle and the share of Hertz' force that it bears; its opposite bears the same.
struct Sample {
    Vector2d at;
    double share = 0;
};

/// Half of the circle's points, in rings of equal width. Between radii r and R lie (1 - r^2)^(3/2) - (1 - R^2)^(3/2) of
/// the force, and each ring stands at the mean radius of its force, so that the whole circle's comes out, 3 pi / 16:
/// what is linear in the distance from a node, as its shape function nearly is, is then right about the middle, too.
std::vector<Sample> samples_of(int rings) {
    std::vector<Sample> samples;
    // Integrals of 3 r sqrt(1 - r^2) dr, the force, from a radius to the rim, and of r times it to a radius.
    const auto beyond = [](double r) { return std::pow(1 - r * r, 1.5); };
    const auto within = [](double r) { return 3.0 / 8 * (std::asin(r) - r * (1 - 2 * r * r) * std::sqrt(1 - r * r)); };
    for (int ring = 0; ring < rings; ++ring) {
        const double inner = static_cast<double>(ring) / rings, outer = (ring + 1.0) / rings;
        const double force = beyond(inner) - beyond(outer);
        const double radius = (within(outer) - within(inner)) / force;
        const int pairs = std::max(2, static_cast<int>(std::lround(std::numbers::pi * (ring + 0.5))));
        for (int k = 0; k < pairs; ++k) {
            const double angle = std::numbers::pi * (k + 0.5 * (ring % 2)) / pairs;
            samples.push_back({radius * Vector2d(std::cos(angle), std::sin(angle)), force / (2 * pairs)});
        }
    }
    return samples;
}

const std::vector<Sample>& circle(int rings) {
    static const auto circles = [] {
        std::array<std::vector<Sample>, most_rings + 1> made;
        for (int count = fewest_rings; count <= most_rings; ++count)
            made[static_cast<std::size_t>(count)] = samples_of(count);
        return made;
    }();
    return circles[static_cast<std::size_t>(rings)];
}

/// A place of the surface, and where it is seen along the normal.
struct Foot {
    int facet = 0;
    Vector2d at = Vector2d::Zero();
    Vector3d point = Vector3d::Zero();
};

/// The surface about a push as it looks along the normal, in a plane with the push at its origin.
class View {
public:
    View(const HexMesh& mesh, const std::vector<int>& facets, const Vector3d& origin, const Vector3d& normal,
         double radius)
        : origin_(origin), normal_(normal), radius_(radius) {
        along_ = normal.unitOrthogonal();
        across_ = normal.cross(along_);
        for (const int facet : facets)
            if (mesh.area_of(facet).normalized().dot(normal) >= facing)
                add(mesh, facet);
    }

    /// Whether the push lies on what is seen.
    [[nodiscard]] bool holds_origin() const {
        return !facets_.empty() && nearest(Vector2d::Zero()).at.norm() <= 1e-6 * radius_;
    }

    /// Of a vector: what it has across the normal, and back.
    [[nodiscard]] Vector2d components(const Vector3d& vector) const {
        return {vector.dot(along_), vector.dot(across_)};
    }
    [[nodiscard]] Vector3d vector(const Vector2d& across) const { return across.x() * along_ + across.y() * across_; }

    /// m, above the push.
    [[nodiscard]] double height(const Vector3d& point) const { return (point - origin_).dot(normal_); }

    [[nodiscard]] int rings() const {
        return std::clamp(static_cast<int>(std::ceil(points_a_facet * radius_ / finest_ - rounding)), fewest_rings,
                          most_rings);
    }

    /// Places opposite to each other: `wanted` and its opposite where the surface has both; else both are drawn towards
    /// the middle, in turn, until both are there.
    [[nodiscard]] std::pair<Foot, Foot> opposite(const Vector2d& wanted) const {
        Vector2d at = wanted;
        for (int turn = 0; turn < most_turns; ++turn) {
            const Foot one = nearest(at), two = nearest(-one.at);
            if ((one.at + two.at).norm() <= rounding * radius_)
                return {one, two};
            at = -two.at;
        }
        // Turns at a curved edge may go on without end: straight to the middle, then.
        for (at = wanted / 2; at.norm() > nearly_middle * radius_; at /= 2) {
            const Foot one = nearest(at), two = nearest(-at);
            if (one.at == at && two.at == -at)
                return {one, two};
        }
        const Foot middle = nearest(Vector2d::Zero());
        return {middle, middle};
    }

private:
    struct Seen {
        int facet = 0;
        Eigen::Matrix<double, 3, 4> corners;
        Eigen::Matrix<double, 2, 4> flat; // as they look
        Vector2d lo, hi;                  // of those
    };

    void add(const HexMesh& mesh, int facet) {
        Seen seen;
        seen.facet = facet;
        for (int k = 0; k < 4; ++k) {
            const int node = mesh.facets[static_cast<std::size_t>(facet)].corners[static_cast<std::size_t>(k)];
            seen.corners.col(k) = mesh.nodes[static_cast<std::size_t>(node)];
            seen.flat.col(k) = flat(seen.corners.col(k));
        }
        seen.lo = seen.flat.rowwise().minCoeff().array() - rounding * radius_;
        seen.hi = seen.flat.rowwise().maxCoeff().array() + rounding * radius_;
        for (int k = 0; k < 4; ++k)
            finest_ = std::min(finest_, (seen.corners.col((k + 1) % 4) - seen.corners.col(k)).norm());
        facets_.push_back(seen);
    }

    [[nodiscard]] Vector2d flat(const Vector3d& point) const { return components(point - origin_); }
    [[nodiscard]] double depth(const Vector3d& point) const { return std::abs(height(point)); }

    /// What lies straight beneath or above, of several the nearest; else the edge that is nearest across the normal.
    [[nodiscard]] Foot nearest(const Vector2d& at) const {
        Foot found;
        double lowest = steepest * radius_;
        bool beneath = false;
        for (const Seen& seen : facets_) {
            if ((at.array() < seen.lo.array()).any() || (at.array() > seen.hi.array()).any())
                continue;
            const auto point = beneath_of(seen, at);
            if (!point || depth(*point) > lowest)
                continue;
            lowest = depth(*point);
            found = {seen.facet, at, *point};
            beneath = true;
        }
        return beneath ? found : at_edge(at);
    }

    /// The facet's point that looks to be at `at`; nothing where the facet looks to be elsewhere.
    [[nodiscard]] static std::optional<Vector3d> beneath_of(const Seen& seen, const Vector2d& at) {
        Vector2d place = Vector2d::Zero(); // Newton's method; one step finds it in a parallelogram
        for (int round = 0; round < 20; ++round) {
            const Eigen::Matrix2d tangents = seen.flat * facet_slopes_at(place.x(), place.y());
            const Vector2d move = tangents.inverse() * (at - seen.flat * facet_shape_at(place.x(), place.y()));
            place += move;
            if (!(std::abs(move.x()) + std::abs(move.y()) > 1e-15))
                break;
        }
        if (std::abs(place.x()) <= 1 + rounding && std::abs(place.y()) <= 1 + rounding) // so no NaN is
            return Vector3d(seen.corners * facet_shape_at(place.x(), place.y()));
        return std::nullopt;
    }

    [[nodiscard]] Foot at_edge(const Vector2d& at) const {
        Foot found;
        double least = std::numeric_limits<double>::infinity();
        for (const Seen& seen : facets_)
            for (int k = 0; k < 4; ++k) {
                const int next = (k + 1) % 4;
                const Vector2d from = seen.flat.col(k), way = seen.flat.col(next) - from;
                const double part = std::clamp((at - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
                const double away = (from + part * way - at).squaredNorm();
                const Vector3d point = (1 - part) * seen.corners.col(k) + part * seen.corners.col(next);
                if (away < least && depth(point) <= steepest * radius_) {
                    least = away;
                    found = {seen.facet, from + part * way, point};
                }
            }
        return found;
    }

    Vector3d origin_, normal_, along_, across_;
    double radius_;                                           // m, of the circle
    double finest_ = std::numeric_limits<double>::infinity(); // m, shortest side of a facet
    std::vector<Seen> facets_;
};

/// A point of a patch and its share of the force.
struct Bearer {
    Foot foot;
    double share = 0;
};

/// Points that lie lower than the contact take a shear force there with them, and its moment with it. What bears that
/// is pressure that leans: more before the contact, less behind it.
struct Lean {
    Vector2d slope = Vector2d::Zero(); // N/m, added to the pressing of a point by how far it lies from the middle
    Vector2d left = Vector2d::Zero();  // N, shear that acts at the contact itself: leaning against it would pull
};

/// `shear`: N, across the normal; `pressing`: N, its size; `height`: m, of the points' middle above the contact.
Lean lean_of(const std::vector<Bearer>& bearers, const Vector2d& shear, double pressing, double height, double radius) {
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const Bearer& bearer : bearers)
        squares += bearer.share * bearer.foot.at * bearer.foot.at.transpose();
    const Eigen::Matrix2d ways = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(squares).eigenvectors();
    const Vector2d needed = height * (ways.transpose() * shear); // N m, either way
    Vector2d square = Vector2d::Zero(), reach = Vector2d::Zero();
    for (const Bearer& bearer : bearers) {
        const Vector2d off = ways.transpose() * bearer.foot.at;
        square += bearer.share * off.cwiseAbs2();
        reach = reach.cwiseMax(off.cwiseAbs());
    }
    // Of what presses, needed for leaning at the patch's rim, either way; both together no more than there is.
    Vector2d strain = Vector2d::Zero();
    for (int k = 0; k < 2; ++k)
        if (needed[k] != 0)
            strain[k] = reach[k] > no_width * radius && pressing > 0
                            ? std::abs(needed[k]) * reach[k] / (square[k] * pressing)
                            : std::numeric_limits<double>::infinity();
    Lean lean;
    for (int k = 0; k < 2; ++k) {
        const double most = std::max(0.5, 1 - strain[1 - k]);
        const double spread = strain[k] > most ? most / strain[k] : 1;
        if (spread > 0 && needed[k] != 0)
            lean.slope += spread * needed[k] / square[k] * ways.col(k);
        lean.left += (1 - spread) * ways.col(k).dot(shear) * ways.col(k);
    }
    return lean;
}

} // namespace

PatchSpreader::PatchSpreader(const HexMesh& mesh) : mesh_(mesh) {
    for (int f = 0; f < static_cast<int>(mesh.facets.size()); ++f) {
        centres_.push_back(mesh.centre_of(f));
        double reach = 0;
        for (const int node : mesh.facets[static_cast<std::size_t>(f)].corners)
            reach = std::max(reach, (mesh.nodes[static_cast<std::size_t>(node)] - centres_.back()).norm());
        reaches_.push_back(reach);
    }
}

std::vector<int> PatchSpreader::facets_within(const Vector3d& point, double radius) const {
    std::vector<int> facets;
    for (std::size_t f = 0; f < centres_.size(); ++f) {
        const double reach = radius + reaches_[f];
        if ((centres_[f] - point).squaredNorm() <= reach * reach)
            facets.push_back(static_cast<int>(f));
    }
    return facets;
}

std::vector<Push> PatchSpreader::spread(const Push& push, const Vector3d& normal, double radius) const {
    if (!(radius > 0))
        return {push};
    const View view(mesh_, facets_within(push.point, steepest * radius), push.point, normal, radius);
    if (!view.holds_origin())
        return {push};
    std::vector<Bearer> bearers;
    double height = 0; // m
    Vector2d middle = Vector2d::Zero();
    for (const Sample& sample : circle(view.rings())) {
        const auto [one, two] = view.opposite(radius * sample.at);
        for (const Foot& foot : {one, two}) {
            bearers.push_back({foot, sample.share});
            height += sample.share * view.height(foot.point);
            middle += sample.share * foot.at;
        }
    }
    if (middle.norm() > rounding * radius) // the push lies a little off what is seen
        return {push};
    Lean lean;
    if (std::abs(height) > rounding * radius)
        lean = lean_of(bearers, view.components(push.force), std::abs(push.force.dot(normal)), height, radius);
    const Vector3d left = view.vector(lean.left);
    std::vector<Push> points;
    for (const Bearer& bearer : bearers)
        points.push_back({bearer.foot.facet, bearer.foot.point,
                          bearer.share * (push.force - left + lean.slope.dot(bearer.foot.at) * normal)});
    if (left != Vector3d::Zero())
        points.push_back({push.facet, push.point, left});
    return points;
}

} // namespace tumble::solid
