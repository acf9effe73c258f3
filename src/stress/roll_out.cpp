#include "stress/roll_out.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace tumble::stress {

namespace {

using Eigen::Vector3d;
using Along = std::array<double, 4>; // m, where a facet's corners lie along the contour

constexpr double circular = 1e-6; // of the radius, and of the area that an all-round side has left over
// Between a round side's facet and the radii to its corners; twelve facets all round have 15 degrees.
constexpr double half_turn_of_facet = 15.5 * std::numbers::pi / 180;
constexpr double later_to_the_left = 1 + 1e-6; // of two ways round of equal length the right one is taken
constexpr double gap = 0.1;                    // between pieces, of the width of all before

double middle_of(const Along& along) {
    return 0.25 * (along[0] + along[1] + along[2] + along[3]);
}

class Roller {
public:
    Roller(const solid::HexMesh& mesh, const fem::Slice& slice, const Vector3d& base, const Vector3d& ahead)
        : mesh_(mesh), slice_(slice), side_(mesh.facet_sets.at(slice.side)), base_(base), up_(slice.up),
          ahead_(across(ahead).normalized()), laid_(side_.size()), at_(side_.size()) {
        rolled_.facets.resize(side_.size());
    }

    RolledOut roll() {
        if (is_round()) {
            std::vector<std::size_t> all(side_.size());
            for (std::size_t f = 0; f < all.size(); ++f)
                all[f] = f;
            lay_round();
            gather(all);
            return std::move(rolled_);
        }
        prepare();
        double end = 0; // m, of the pieces so far
        for (std::size_t left = side_.size(); left > 0;) {
            std::vector<std::size_t> piece = lay_piece(most_ahead());
            left -= piece.size();
            const auto [lo, hi] = reach(piece);
            if (!rolled_.points.empty())
                for (const std::size_t f : piece)
                    for (double& along : at_[f])
                        along += end - lo;
            end = (rolled_.points.empty() ? hi : end + hi - lo) + gap * (hi - lo);
            gather(piece);
        }
        return std::move(rolled_);
    }

private:
    [[nodiscard]] Vector3d across(const Vector3d& vector) const { return vector - up_.dot(vector) * up_; }
    [[nodiscard]] const std::array<int, 4>& corners(std::size_t f) const {
        return mesh_.facets[static_cast<std::size_t>(side_[f])].corners;
    }
    [[nodiscard]] const Vector3d& node(int n) const { return mesh_.nodes[static_cast<std::size_t>(n)]; }

    /// All the way round, facets add up to nothing across the axis.
    [[nodiscard]] bool is_round() const {
        double least = std::numeric_limits<double>::infinity(), most = 0, size = 0; // m, m2
        Vector3d sum = Vector3d::Zero();                                            // m2
        for (std::size_t f = 0; f < side_.size(); ++f) {
            const Vector3d area = mesh_.area_of(side_[f]);
            sum += across(area);
            size += area.norm();
            for (const int corner : corners(f)) {
                const Vector3d arm = across(node(corner) - base_);
                if (std::abs(arm.dot(area)) < std::cos(half_turn_of_facet) * arm.norm() * area.norm())
                    return false;
                least = std::min(least, arm.norm());
                most = std::max(most, arm.norm());
            }
        }
        return most - least <= circular * most && sum.norm() <= circular * size;
    }

    void lay_round() {
        std::map<int, const fem::SlicePoint*> beneath;
        for (const fem::SlicePoint& point : slice_.points)
            beneath[point.node] = &point;
        const Vector3d seen = mesh_.area_of(side_.front()), arm = mesh_.centre_of(side_.front()) - base_;
        const Vector3d right =
            seen.dot(across(arm)) > 0 ? up_.cross(ahead_) : ahead_.cross(up_); // a bore is seen from its axis
        for (std::size_t f = 0; f < side_.size(); ++f) {
            Along round{}; // m, of the whole circle
            for (std::size_t k = 0; k < 4; ++k) {
                const Vector3d off = beneath.at(corners(f)[k])->place - base_;
                const double x = ahead_.dot(off), y = right.dot(off);
                at_[f][k] = std::hypot(x, y) * std::atan2(y, x);
                round[k] = 2 * std::numbers::pi * std::hypot(x, y);
            }
            const double most = *std::max_element(at_[f].begin(), at_[f].end());
            for (std::size_t k = 0; k < 4; ++k)
                at_[f][k] += most - at_[f][k] < 0.5 * round[k] ? 0 : round[k];
        }
    }

    /// Each facet by itself, and which meet at an edge.
    void prepare() {
        for (std::size_t f = 0; f < side_.size(); ++f) {
            const Vector3d contour = up_.cross(mesh_.area_of(side_[f])).normalized();
            Along own{};
            for (std::size_t k = 0; k < 4; ++k) {
                own[k] = contour.dot(node(corners(f)[k]) - base_);
                at_edge_[std::minmax(corners(f)[k], corners(f)[(k + 1) % 4])].push_back(f);
            }
            own_.push_back(own);
        }
    }

    /// Of the facets that are not laid yet the one that lies ahead of the axis and looks there.
    [[nodiscard]] std::size_t most_ahead() const {
        std::size_t found = 0;
        double best = -std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < side_.size(); ++f) {
            if (laid_[f])
                continue;
            const double here = ahead_.dot(across(mesh_.centre_of(side_[f]) - base_).normalized()) +
                                ahead_.dot(across(mesh_.area_of(side_[f])).normalized());
            if (here > best) {
                best = here;
                found = f;
            }
        }
        return found;
    }

    /// A facet and where it would be laid: `offset` on its own places; the nearer to the first, the sooner, so that
    /// what comes round from both sides meets half way.
    struct Next {
        double far = 0; // m
        std::size_t facet = 0;
        double offset = 0; // m
        bool operator<(const Next& other) const { return far > other.far; }
    };

    std::vector<std::size_t> lay_piece(std::size_t first) {
        std::vector<std::size_t> piece;
        std::priority_queue<Next> nearest;
        nearest.push({0, first, -middle_of(own_[first])});
        while (!nearest.empty()) {
            const Next next = nearest.top();
            nearest.pop();
            if (laid_[next.facet])
                continue;
            laid_[next.facet] = true;
            piece.push_back(next.facet);
            for (std::size_t k = 0; k < 4; ++k)
                at_[next.facet][k] = own_[next.facet][k] + next.offset;
            for (std::size_t k = 0; k < 4; ++k)
                for (const std::size_t other :
                     at_edge_.at(std::minmax(corners(next.facet)[k], corners(next.facet)[(k + 1) % 4])))
                    if (!laid_[other]) {
                        const double offset = 0.5 * (past(next.facet, k, other) + past(next.facet, (k + 1) % 4, other));
                        const double middle = middle_of(own_[other]) + offset;
                        nearest.push({middle < 0 ? -later_to_the_left * middle : middle, other, offset});
                    }
        }
        return piece;
    }

    /// m, that the corner k of a facet that is laid lies past its own place in another.
    [[nodiscard]] double past(std::size_t laid, std::size_t k, std::size_t other) const {
        const auto& there = corners(other);
        const auto found = std::find(there.begin(), there.end(), corners(laid)[k]);
        return at_[laid][k] - own_[other][static_cast<std::size_t>(found - there.begin())];
    }

    [[nodiscard]] std::pair<double, double> reach(const std::vector<std::size_t>& piece) const {
        double lo = std::numeric_limits<double>::infinity(), hi = -lo;
        for (const std::size_t f : piece)
            for (const double along : at_[f]) {
                lo = std::min(lo, along);
                hi = std::max(hi, along);
            }
        return {lo, hi};
    }

    /// One point for what is one corner; those of a cut lie a whole contour apart.
    void gather(const std::vector<std::size_t>& piece) {
        const auto [lo, hi] = reach(piece);
        const double half = 0.5 * (hi - lo);
        std::map<int, std::vector<int>> points_of; // by node
        for (const std::size_t f : piece)
            for (std::size_t k = 0; k < 4; ++k) {
                const int corner = corners(f)[k];
                std::vector<int>& points = points_of[corner];
                const auto found = std::find_if(points.begin(), points.end(), [&](int point) {
                    return std::abs(rolled_.points[static_cast<std::size_t>(point)].along - at_[f][k]) < half;
                });
                if (found != points.end()) {
                    rolled_.facets[f][k] = *found;
                    continue;
                }
                points.push_back(static_cast<int>(rolled_.points.size()));
                rolled_.facets[f][k] = points.back();
                rolled_.points.push_back({corner, at_[f][k]});
            }
    }

    const solid::HexMesh& mesh_;
    const fem::Slice& slice_;
    const std::vector<int>& side_;
    Vector3d base_, up_, ahead_;
    std::map<std::pair<int, int>, std::vector<std::size_t>> at_edge_;
    std::vector<Along> own_; // per facet of the side, in its own plane
    std::vector<bool> laid_;
    std::vector<Along> at_;
    RolledOut rolled_;
};

} // namespace

RolledOut rolled_out(const solid::HexMesh& mesh, const fem::Slice& slice, const Vector3d& base, const Vector3d& ahead) {
    return Roller(mesh, slice, base, ahead).roll();
}

} // namespace tumble::stress
